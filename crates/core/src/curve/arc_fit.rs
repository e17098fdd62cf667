//! A polyline as lines and circular arcs.

use std::f64::consts::TAU;

use nalgebra::{Point3, Unit, Vector3};

use super::distance_to_segment;
use crate::units::{Angle, Length};

/// A part of a fitted curve; it starts where the one before it ends. Indices are those of the
/// polyline.
#[derive(Debug, Clone, PartialEq)]
pub enum Piece {
    /// Straight from one point to another.
    Line {
        /// First point.
        from: usize,
        /// Last point.
        to: usize,
    },
    /// Along a circle, right-handed about its axis.
    Arc {
        /// First point.
        from: usize,
        /// Last point.
        to: usize,
        /// Centre of the circle, in mm.
        centre: Point3<f64>,
        /// Axis of the circle.
        axis: Unit<Vector3<f64>>,
        /// Radius.
        radius: Length,
        /// How far it goes round, more than zero.
        sweep: Angle,
    },
}

/// Covers a polyline with lines and arcs through points of it, so that no vertex and no middle of a
/// segment is farther than `tolerance` from its piece. Each piece is taken as long as it can be,
/// from the first point on; where an arc reaches no farther than a line, it is a line. An arc has
/// at least four points, since any three lie on one.
#[must_use]
pub fn fit_arcs(points: &[Point3<f64>], tolerance: Length) -> Vec<Piece> {
    let mut pieces = Vec::new();
    let mut from = 0;
    while from + 1 < points.len() {
        let line_to = longest(points.len(), from + 1, |to| is_line(&points[from..=to], tolerance.mm()));
        let arc_to =
            longest(points.len(), from + 3, |to| circle(&points[from..=to], tolerance.mm()).is_some());
        let arc = if arc_to > line_to && arc_to < points.len() {
            circle(&points[from..=arc_to], tolerance.mm())
        } else {
            None
        };
        if let Some((centre, axis, radius, sweep)) = arc {
            pieces.push(Piece::Arc { from, to: arc_to, centre, axis, radius, sweep });
            from = arc_to;
        } else {
            pieces.push(Piece::Line { from, to: line_to });
            from = line_to;
        }
    }
    pieces
}

/// The last index from `first` on up to which `fits` holds without a gap; `first` itself is
/// returned even where it does not.
fn longest(count: usize, first: usize, fits: impl Fn(usize) -> bool) -> usize {
    let mut to = first;
    if first >= count || !fits(first) {
        // For an arc this is below four points, which the caller sees by comparing with the line.
        return if first < count { first.saturating_sub(2) } else { 0 };
    }
    while to + 1 < count && fits(to + 1) {
        to += 1;
    }
    to
}

fn is_line(points: &[Point3<f64>], tolerance: f64) -> bool {
    let (a, b) = (points[0], points[points.len() - 1]);
    points.len() == 2 || points.iter().all(|p| distance_to_segment(p, &a, &b) <= tolerance)
}

type Circle = (Point3<f64>, Unit<Vector3<f64>>, Length, Angle);

/// The circle through the first, a middle and the last point, when all points and all middles of
/// segments are near it and it goes round without turning back.
fn circle(points: &[Point3<f64>], tolerance: f64) -> Option<Circle> {
    let (a, c) = (points[0], points[points.len() - 1]);
    let b = points[points.len() / 2];
    let (ab, ac) = (b - a, c - a);
    let normal = ab.cross(&ac);
    let axis = Unit::try_new(normal, 1e-12 * ab.norm() * ac.norm())?;
    // Circumcentre of the triangle a b c.
    let to_centre = (ac.norm_squared() * normal.cross(&ab) + ab.norm_squared() * ac.cross(&normal))
        / (2.0 * normal.norm_squared());
    let centre = a + to_centre;
    let radius = to_centre.norm();
    let near = |p: &Point3<f64>| {
        let out = p - centre;
        let above = out.dot(&axis);
        ((out - axis.into_inner() * above).norm() - radius).hypot(above) <= tolerance
    };
    let mut sweep = 0.0;
    for pair in points.windows(2) {
        let (u, v) = (pair[0] - centre, pair[1] - centre);
        let turn = u.cross(&v).dot(&axis).atan2(u.dot(&v));
        if turn <= 0.0 || !near(&pair[1]) || !near(&nalgebra::center(&pair[0], &pair[1])) {
            return None;
        }
        sweep += turn;
    }
    (sweep < TAU).then(|| (centre, axis, Length::computed(radius), Angle::computed(sweep)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mm(value: f64) -> Length {
        Length::from_mm(value).unwrap()
    }

    /// A straight lead-in, half a circle of radius 50 in steps of 5°, and a straight lead-out.
    fn hook() -> Vec<Point3<f64>> {
        let mut points = vec![Point3::new(50.0, -80.0, 7.0), Point3::new(50.0, -40.0, 7.0)];
        points.extend((0..=36).map(|k| {
            let angle = f64::from(5 * k).to_radians();
            Point3::new(50.0 * angle.cos(), 50.0 * angle.sin(), 7.0)
        }));
        points.push(Point3::new(-50.0, -60.0, 7.0));
        points
    }

    #[test]
    fn a_hook_is_a_line_an_arc_and_a_line() {
        // The sagitta of 5° at radius 50 is 0.048 mm.
        let pieces = fit_arcs(&hook(), mm(0.05));
        let [
            Piece::Line { from: 0, to: 2 },
            Piece::Arc { from: 2, to: 38, radius, sweep, axis, .. },
            Piece::Line { from: 38, to: 39 },
        ] = pieces.as_slice()
        else {
            panic!("{pieces:?}")
        };
        assert!((radius.mm() - 50.0).abs() < 1e-9);
        assert!((sweep.deg() - 180.0).abs() < 1e-9);
        assert!(axis.z > 0.999, "counter-clockwise seen from +z");
    }

    #[test]
    fn what_is_no_arc_stays_straight() {
        let pieces = fit_arcs(&hook(), mm(0.01));
        assert!(pieces.iter().all(|piece| matches!(piece, Piece::Line { .. })));
        assert_eq!(fit_arcs(&hook()[..1], mm(1.0)), []);
        assert_eq!(fit_arcs(&hook()[..2], mm(1.0)), [Piece::Line { from: 0, to: 1 }]);
    }

    #[test]
    fn the_pieces_join_and_stay_within_the_tolerance() {
        // A helix is no arc: with a tolerance it becomes several.
        let helix: Vec<_> = (0..200)
            .map(|k| {
                let angle = f64::from(k) * 0.1;
                Point3::new(30.0 * angle.cos(), 30.0 * angle.sin(), 2.0 * angle)
            })
            .collect();
        let pieces = fit_arcs(&helix, mm(0.3));
        let mut at = 0;
        for piece in &pieces {
            let (from, to) = match piece {
                Piece::Line { from, to } | Piece::Arc { from, to, .. } => (*from, *to),
            };
            assert_eq!(from, at);
            at = to;
            if let Piece::Arc { centre, axis, radius, .. } = piece {
                for point in &helix[from..=to] {
                    let out = point - centre;
                    let above = out.dot(axis);
                    let off = ((out - axis.into_inner() * above).norm() - radius.mm()).hypot(above);
                    assert!(off <= 0.3);
                }
            }
        }
        assert_eq!(at, helix.len() - 1);
        assert!(pieces.len() < 40, "{}", pieces.len());
    }
}
