//! Smooth curves as straight edges that a machine can make: none shorter than a limit, and as near to the curve as that
//! allows.

mod fit;
mod march;

use nalgebra::{Point3, Vector3};

use self::fit::Fit;
use self::march::Samples;
use crate::units::Length;

/// What of the edges of a curve can be made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EdgeLimit {
    /// No edge is shorter. It holds for corners of up to 90°.
    pub shortest: Length,
    /// Centreline radius of a bend: the arc of a sharper corner takes more of both edges. 0 where it takes nothing.
    pub bend_radius: Length,
}

impl EdgeLimit {
    /// The shortest edge, mm, between corners where the wire turns by two angles, in radians.
    #[must_use]
    pub fn between(&self, one: f64, other: f64) -> f64 {
        let beyond = |turn: f64| ((turn.min(3.0) / 2.0).tan() - 1.0).max(0.0);
        self.shortest.mm() + self.bend_radius.mm() * (beyond(one) + beyond(other))
    }

    /// What each edge between corners lacks of the length that it needs, mm; not above 0 where it is long enough. A ring
    /// has its first corner once more at its end.
    #[must_use]
    pub fn lacking(&self, corners: &[Point3<f64>], ends: CurveEnds) -> Vec<f64> {
        let edges: Vec<Vector3<f64>> = corners.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let (before, behind) = match ends {
            CurveEnds::Ring => (edges.last().copied(), edges.first().copied()),
            CurveEnds::Open([before, behind]) => (before, behind),
        };
        let lacks = |(k, edge): (usize, &Vector3<f64>)| {
            let turn = |side: Option<Vector3<f64>>| side.map_or(0.0, |side| side.angle(edge));
            let one = k.checked_sub(1).map(|k| edges[k]).or(before);
            let other = edges.get(k + 1).copied().or(behind);
            self.between(turn(one), turn(other)) - edge.norm()
        };
        edges.iter().enumerate().map(lacks).collect()
    }
}

/// What may become of the ends of a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CurveEnds {
    /// They stay. One that a straight line leads to, or from, without a corner may slide along that line, onwards from
    /// where it meets the curve: with the direction of the line as the curve is run through, of any length.
    Open([Option<Vector3<f64>>; 2]),
    /// The curve ends where it begins, without a corner: no point of it has to stay.
    Ring,
}

/// A curve as straight edges.
#[derive(Debug, Clone, PartialEq)]
pub struct CurveCut {
    /// The corners from one end to the other. A single one where the lines before and behind the curve meet instead of
    /// it. The last of a ring is not its first again.
    pub points: Vec<Point3<f64>>,
    /// How far apart points of the curve and of the edges are at most, to a hundredth of a millimetre.
    pub deviation: Length,
    /// Where on the curve that is.
    pub at: Point3<f64>,
    /// How many edges are shorter than the limit all the same, since the curve has no room for longer ones.
    pub too_short: usize,
}

/// Cuts a curve, given as points so close together that the curve does not leave the lines between them. A ring has its
/// first point once more at its end. Fewer than two points are no curve and are given back.
///
/// With as few edges as `tolerance` allows, or with those that are nearest to the curve where none of the limit's length
/// are as near as that. Corners lie on the outside of the curve and edges on its inside, equally far where that is
/// possible. There are at least `min_edges`, which is 0 where any number will do: more than one where the same two ends are
/// joined by another edge already.
#[must_use]
pub fn cut_curve(
    curve: &[Point3<f64>],
    ends: CurveEnds,
    tolerance: Length,
    limit: &EdgeLimit,
    min_edges: usize,
) -> CurveCut {
    let samples = Samples::new(curve);
    if curve.len() < 2 || samples.length() <= 0.0 {
        let at = curve.first().copied().unwrap_or_default();
        return CurveCut { points: curve.to_vec(), deviation: Length::ZERO, at, too_short: 0 };
    }
    let fit = Fit::new(&samples, ends, limit);
    let shortest = limit.shortest.mm();
    let near = |cut: &CurveCut| cut.deviation <= tolerance;
    // What cannot be fed is worse than what is less true.
    let better = |one: &CurveCut, other: &CurveCut| {
        let first = one.too_short.cmp(&other.too_short);
        first.then_with(|| match (near(one), near(other)) {
            (true, true) => one.points.len().cmp(&other.points.len()),
            _ => one.deviation.mm().total_cmp(&other.deviation.mm()),
        })
    };
    let least = fewest(&samples, ends).max(min_edges);
    let (counts, room) = counts(&samples, least, tolerance.mm(), shortest);
    let mut best = if min_edges == 0 { fit.corner() } else { None };
    let wanted = counts.len();
    let divided = counts.iter().map(|&count| samples.divided(count, shortest));
    // Where a curve comes back to where it was, the last edge may be short: fewer edges are then left to try, and a single
    // one is as long as its ends are apart.
    let fewer = (1..=FEWER).map(|less| room.saturating_sub(less).max(least)).chain([least]);
    let fewer = fewer.map(|count| samples.divided(count, shortest));
    for (k, places) in divided.chain([samples.divided_evenly(room)]).chain(fewer).enumerate() {
        let is_enough = |best: &CurveCut| best.too_short == 0 && (near(best) || k > wanted);
        if best.as_ref().is_some_and(is_enough) {
            break;
        }
        let cut = fit.of(&places);
        if best.as_ref().is_none_or(|best| better(&cut, best).is_lt()) {
            best = Some(cut);
        }
    }
    best.unwrap_or_else(|| fit.of(&samples.divided_evenly(least)))
}

/// So many edges fewer than there is room for are tried where one would be too short.
const FEWER: usize = 6;

/// The fewest edges that a curve can have.
fn fewest(samples: &Samples, ends: CurveEnds) -> usize {
    if ends == CurveEnds::Ring || samples.returns() { 3 } else { 1 }
}

/// The numbers of edges that are worth a try, from few to many: as many as the tolerance asks for, where the deviation is
/// on one side or shared by both, and as many as there is room for, which is given beside them.
fn counts(samples: &Samples, least: usize, tolerance: f64, shortest: f64) -> (Vec<usize>, usize) {
    let by = |sagitta| samples.march(shortest, sagitta, usize::MAX).len() - 1;
    let room = by(0.0).max(least);
    // The last step of a march is what was left.
    let full = room.saturating_sub(1).max(least);
    // A little below twice the tolerance, so that not a rounding is missing.
    let mut counts = vec![by(1.9 * tolerance), by(tolerance), full, room];
    for count in &mut counts {
        *count = (*count).max(least);
    }
    counts.sort_unstable();
    counts.dedup();
    (counts, full)
}

#[cfg(test)]
mod tests;
