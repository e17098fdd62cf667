//! The centreline of the bent wire: straight parts and arcs.

use nalgebra::{Point3, Vector3};
use wirebend_core::units::Length;

/// The centreline of a wire as a polyline in mm.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Centreline {
    /// Its points.
    pub points: Vec<Point3<f64>>,
    /// The corners (indices into the path) whose arc does not fit, so that it has a smaller radius
    /// here than on the machine; a fold back has none at all.
    pub tightened: Vec<usize>,
}

/// Rounds the corners of a path (points in mm) with arcs of a centreline radius, tangent to both
/// sides. The arcs become chords that leave them by no more than `chord`.
///
/// Where an arc would need more than half of a side that has a corner at its other end too, it is
/// made smaller and listed. Repeated points are left out; a path of one point stays one.
#[must_use]
pub fn centreline(path: &[Point3<f64>], radius: Length, chord: Length) -> Centreline {
    let mut corners: Vec<(usize, Point3<f64>)> = Vec::new();
    for (k, &point) in path.iter().enumerate() {
        if corners.last().is_none_or(|(_, last)| (point - last).norm() > 0.0) {
            corners.push((k, point));
        }
    }
    let Some(&(_, start)) = corners.first() else {
        return Centreline::default();
    };
    let mut line = Centreline { points: vec![start], tightened: Vec::new() };
    let last = corners.len() - 1;
    for k in 1..last {
        let (index, corner) = corners[k];
        let (before, after) = (corner - corners[k - 1].1, corners[k + 1].1 - corner);
        // A side that ends the wire belongs to this corner alone.
        let room = |side: Vector3<f64>, ends: bool| if ends { side.norm() } else { side.norm() / 2.0 };
        let room = room(before, k == 1).min(room(after, k + 1 == last));
        let arc = Arc::new(corner, before.normalize(), after.normalize(), radius.mm(), room);
        if arc.tightened {
            line.tightened.push(index);
        }
        arc.points(chord.mm(), &mut line.points);
    }
    if last > 0 {
        line.points.push(corners[last].1);
    }
    line
}

/// The arc at a corner: from `corner - before·setback`, turning from `before` to `after`.
struct Arc {
    corner: Point3<f64>,
    before: Vector3<f64>,
    after: Vector3<f64>,
    angle: f64,
    radius: f64,
    setback: f64,
    tightened: bool,
}

impl Arc {
    fn new(corner: Point3<f64>, before: Vector3<f64>, after: Vector3<f64>, radius: f64, room: f64) -> Self {
        let angle = before.cross(&after).norm().atan2(before.dot(&after));
        let tangent = (angle / 2.0).tan();
        let wanted = radius * tangent;
        let tightened = angle > 1e-9 && wanted > room * (1.0 + 1e-9);
        let setback = if tightened { room } else { wanted };
        let folded = angle > std::f64::consts::PI - 1e-6;
        let (radius, setback) = if folded { (0.0, 0.0) } else { (radius.min(setback / tangent), setback) };
        Self { corner, before, after, angle, radius, setback, tightened: tightened && radius < f64::INFINITY }
    }

    fn points(&self, chord: f64, points: &mut Vec<Point3<f64>>) {
        // Without a side to turn to, or without a radius, the corner is all there is.
        let side = self.after - self.before * self.before.dot(&self.after);
        let Some(side) = side.try_normalize(1e-9).filter(|_| self.radius > 0.0 && self.radius.is_finite())
        else {
            points.push(self.corner);
            return;
        };
        let begin = self.corner - self.before * self.setback;
        let count = chords(self.angle, self.radius, chord);
        for k in 0..=count {
            let turned = self.angle * f64::from(k) / f64::from(count);
            let along = self.before * (self.radius * turned.sin());
            points.push(begin + along + side * (self.radius * (1.0 - turned.cos())));
        }
    }
}

/// How many chords keep within `chord` of an arc: the sagitta of one is r·(1 - cos(angle / 2n)).
fn chords(angle: f64, radius: f64, chord: f64) -> u32 {
    let widest = 2.0 * (1.0 - (chord / radius).clamp(1e-6, 1.0)).acos();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // from 1 to some thousand
    let count = (angle / widest).ceil().clamp(1.0, 4096.0) as u32;
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mm(value: f64) -> Length {
        Length::from_mm(value).unwrap()
    }

    fn length(points: &[Point3<f64>]) -> f64 {
        points.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum()
    }

    #[test]
    fn a_corner_becomes_an_arc_of_the_radius() {
        let path = [Point3::new(0., 0., 0.), Point3::new(50., 0., 0.), Point3::new(50., 0., 40.)];
        let line = centreline(&path, mm(10.0), mm(1e-3));
        // 90 mm less two tangents of 10 mm, and a quarter of a circle.
        let expected = 90.0 - 20.0 + 5.0 * std::f64::consts::PI;
        assert!((length(&line.points) - expected).abs() < 0.01, "{}", length(&line.points));
        assert!(line.tightened.is_empty());
        let centre = Point3::new(40., 0., 10.);
        let arc = &line.points[1..line.points.len() - 1];
        assert!(arc.iter().all(|p| ((p - centre).norm() - 10.0).abs() < 1e-9));
    }

    #[test]
    fn what_does_not_fit_is_tightened_and_named() {
        let path =
            [(0., 0.), (10., 0.), (10., 10.), (20., 10.), (0., 10.)].map(|(x, y)| Point3::new(x, y, 0.));
        let line = centreline(&path, mm(8.0), mm(0.01));
        assert_eq!(line.tightened, [1, 2, 3], "two arcs of 8 mm on a side of 10 mm, and a fold back");
        assert_eq!(line.points.last(), path.last());
        assert!(line.points.iter().all(|p| p.coords.iter().all(|c| c.is_finite())));
    }

    #[test]
    fn nothing_and_points_and_straight_lines_stay() {
        assert_eq!(centreline(&[], mm(1.0), mm(0.1)).points, []);
        let twice = [Point3::new(1., 2., 3.); 2];
        assert_eq!(centreline(&twice, mm(1.0), mm(0.1)).points, twice[..1]);
        let straight = [0., 10., 30.].map(|x| Point3::new(x, 0., 0.));
        assert_eq!(centreline(&straight, mm(5.0), mm(0.1)).points, straight);
    }
}
