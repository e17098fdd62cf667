//! Distances of a straight piece.

use nalgebra::Point3;

use crate::Solid;

/// How near a straight piece comes to something.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Near {
    /// The least signed distance.
    pub distance: f64,
    /// Where it is, from 0 at the piece's first end to 1 at its second.
    pub part: f64,
}

/// So many steps are far more than the narrowing ever takes; it halves at least every second one.
const MOST_STEPS: usize = 120;

/// The least signed distance of the points between `ends` from a solid, in the solid's frame, no more than `tolerance` above
/// the exact one. A piece that goes through the solid has the negative depth of its deepest point.
///
/// Along a line the signed distance of a convex solid is convex, so that a slope on either side of the least value bounds it
/// from below.
#[must_use]
pub fn to_solid(ends: [&Point3<f64>; 2], solid: &Solid, tolerance: f64) -> Near {
    nearer_than(ends, solid, tolerance, f64::INFINITY)
}

/// The same, except that it may stop at any distance once it knows that none is below `enough`.
pub(crate) fn nearer_than([from, to]: [&Point3<f64>; 2], solid: &Solid, tolerance: f64, enough: f64) -> Near {
    let way = to - from;
    let at = |part: f64| solid.distance_along(&(from + way * part), &way);
    let (mut low, mut high) = (0.0, 1.0);
    let ((mut low_value, mut low_slope), (mut high_value, mut high_slope)) = (at(low), at(high));
    let mut best = if low_value <= high_value {
        Near { distance: low_value, part: low }
    } else {
        Near { distance: high_value, part: high }
    };
    if low_slope >= 0.0 {
        return Near { distance: low_value, part: low };
    }
    if high_slope <= 0.0 {
        return Near { distance: high_value, part: high };
    }
    let mut last_width = high - low;
    for step in 0..MOST_STEPS {
        // Where the two tangents meet: nothing is below.
        let part = (high_value - low_value + low_slope * low - high_slope * high) / (low_slope - high_slope);
        let bound = low_value + low_slope * (part - low);
        if bound >= best.distance - tolerance || (bound > enough && enough < f64::INFINITY) {
            break;
        }
        let width = high - low;
        let slow = step % 2 == 1 && width > last_width / 2.0;
        if step % 2 == 1 {
            last_width = width;
        }
        let part = if slow || part <= low || part >= high { f64::midpoint(low, high) } else { part };
        let (value, slope) = at(part);
        if value < best.distance {
            best = Near { distance: value, part };
        }
        if slope < 0.0 {
            (low, low_value, low_slope) = (part, value, slope);
        } else {
            (high, high_value, high_slope) = (part, value, slope);
        }
    }
    best
}

/// The least distance between two straight pieces, and where it is on each, from 0 to 1.
///
/// ```
/// use nalgebra::Point3;
/// use wirebend_collide::between_pieces;
/// let one = [Point3::origin(), Point3::new(10.0, 0.0, 0.0)];
/// let other = [Point3::new(5.0, -5.0, 3.0), Point3::new(5.0, 5.0, 3.0)];
/// assert_eq!(between_pieces(&one, &other), (3.0, [0.5, 0.5]));
/// ```
#[must_use]
pub fn between_pieces(one: &[Point3<f64>; 2], other: &[Point3<f64>; 2]) -> (f64, [f64; 2]) {
    let (u, v) = (one[1] - one[0], other[1] - other[0]);
    let between = one[0] - other[0];
    let (uu, uv, vv) = (u.norm_squared(), u.dot(&v), v.norm_squared());
    let (uw, vw) = (u.dot(&between), v.dot(&between));
    let on_other = |s: f64| if vv > 0.0 { ((s * uv + vw) / vv).clamp(0.0, 1.0) } else { 0.0 };
    let on_one = |t: f64| if uu > 0.0 { ((t * uv - uw) / uu).clamp(0.0, 1.0) } else { 0.0 };
    let across = uu * vv - uv * uv;
    // Parallel pieces are nearest at an end.
    let free = if across > 1e-12 * uu * vv { ((uv * vw - uw * vv) / across).clamp(0.0, 1.0) } else { 0.0 };
    let settled = {
        let t = on_other(free);
        let s = on_one(t);
        [s, on_other(s)]
    };
    let ends = [[0.0, on_other(0.0)], [1.0, on_other(1.0)], [on_one(0.0), 0.0], [on_one(1.0), 1.0]];
    let apart = |[s, t]: [f64; 2]| (between + u * s - v * t).norm();
    ends.into_iter().fold((apart(settled), settled), |best, at| {
        let distance = apart(at);
        if distance < best.0 { (distance, at) } else { best }
    })
}
