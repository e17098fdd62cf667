//! The centreline of the bent wire: straight parts and arcs.

use nalgebra::{Point3, Vector3};
use wirebend_core::units::Length;

/// The centreline of a wire as a polyline in mm.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Centreline {
    pub points: Vec<Point3<f64>>,
    /// The corners (indices into the path) whose arc does not fit, so that it has a smaller radius
    /// here than on the machine; a fold back has none at all.
    pub tightened: Vec<usize>,
}

/// A part of the centreline, in mm. Each begins where the one before it ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Piece {
    Straight([Point3<f64>; 2]),
    Arc(Arc),
}

/// An arc from `begin`, where the wire runs along the unit vector `before`, turning by `angle` (rad, above 0)
/// towards the unit vector `side`, which is across `before`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Arc {
    pub begin: Point3<f64>,
    pub before: Vector3<f64>,
    pub side: Vector3<f64>,
    pub angle: f64,
    pub radius: f64,
}

/// Rounds the corners of a path (points in mm) with arcs of a centreline radius, tangent to both
/// sides. The arcs become chords that leave them by no more than `chord`.
///
/// Where the arcs at both ends of a side do not fit on it, those that need more than half of it are
/// made smaller and listed. Repeated points are left out; a path of one point stays one.
#[must_use]
pub fn centreline(path: &[Point3<f64>], radius: Length, chord: Length) -> Centreline {
    let (pieces, tightened) = pieces(path, radius);
    let mut points: Vec<Point3<f64>> = path.first().copied().into_iter().collect();
    for piece in pieces {
        match piece {
            Piece::Straight([_, to]) => points.push(to),
            Piece::Arc(arc) => {
                let count = arc.chords(chord.mm());
                points.extend((1..=count).map(|k| arc.at(f64::from(k) / f64::from(count))));
            }
        }
    }
    Centreline { points, tightened }
}

/// The straight parts and arcs of a path, and the corners whose arc is smaller than the radius.
pub(super) fn pieces(path: &[Point3<f64>], radius: Length) -> (Vec<Piece>, Vec<usize>) {
    let mut places: Vec<(usize, Point3<f64>)> = Vec::new();
    for (k, &point) in path.iter().enumerate() {
        if places.last().is_none_or(|(_, last)| (point - last).norm() > 0.0) {
            places.push((k, point));
        }
    }
    let corners: Vec<Corner> = places
        .windows(3)
        .map(|three| Corner::new([three[0].1, three[1].1, three[2].1], radius.mm()))
        .collect();
    let (mut pieces, mut tightened) = (Vec::new(), Vec::new());
    let Some(&(_, mut at)) = places.first() else { return (pieces, tightened) };
    let go = |pieces: &mut Vec<Piece>, at: &mut Point3<f64>, to: Point3<f64>| {
        let from = std::mem::replace(at, to);
        if from != to {
            pieces.push(Piece::Straight([from, to]));
        }
    };
    for (k, corner) in corners.iter().enumerate() {
        let wanted = |k: Option<usize>| k.and_then(|k| corners.get(k)).map_or(0.0, |other| other.setback);
        let before = left_for(corner.sides[0].norm(), wanted(k.checked_sub(1)));
        let after = left_for(corner.sides[1].norm(), wanted(Some(k + 1)));
        let room = before.min(after);
        let tight = corner.setback > room * (1.0 + 1e-9);
        if tight || corner.folded {
            tightened.push(places[k + 1].0);
        }
        let setback = if tight { room } else { corner.setback };
        if let Some(arc) = corner.arc(setback) {
            go(&mut pieces, &mut at, arc.begin);
            at = arc.at(1.0);
            pieces.push(Piece::Arc(arc));
        } else {
            go(&mut pieces, &mut at, corner.at);
        }
    }
    if let [_, .., (_, end)] = places[..] {
        go(&mut pieces, &mut at, end);
    }
    (pieces, tightened)
}

/// What a corner may take of a side whose other end wants so much of it: where both do not fit, half at least.
fn left_for(side: f64, other: f64) -> f64 {
    (side - other).max(side / 2.0).min(side)
}

struct Corner {
    at: Point3<f64>,
    /// From the corner before to this one, and from this one to the next.
    sides: [Vector3<f64>; 2],
    angle: f64,
    /// From the corner to the ends of an arc of the whole radius; none of a fold back, which has no corner.
    setback: f64,
    folded: bool,
}

impl Corner {
    fn new([from, at, to]: [Point3<f64>; 3], radius: f64) -> Self {
        let sides = [at - from, to - at];
        let angle = sides[0].cross(&sides[1]).norm().atan2(sides[0].dot(&sides[1]));
        let folded = angle > std::f64::consts::PI - 1e-6;
        let setback = if folded { 0.0 } else { radius.max(0.0) * (angle / 2.0).tan() };
        Self { at, sides, angle, setback, folded }
    }

    /// The arc whose ends are so far from the corner; none where the wire has no side to turn to.
    fn arc(&self, setback: f64) -> Option<Arc> {
        let [before, after] = self.sides.map(|side| side.normalize());
        let side = (after - before * before.dot(&after)).try_normalize(1e-9)?;
        let radius = setback / (self.angle / 2.0).tan();
        let begin = self.at - before * setback;
        (radius > 0.0 && radius.is_finite()).then_some(Arc { begin, before, side, angle: self.angle, radius })
    }
}

impl Arc {
    /// The point at a fraction of the arc.
    pub fn at(&self, fraction: f64) -> Point3<f64> {
        let turned = self.angle * fraction;
        let along = self.before * (self.radius * turned.sin());
        self.begin + along + self.side * (self.radius * (1.0 - turned.cos()))
    }

    /// The direction of the wire at a fraction of the arc.
    pub fn tangent(&self, fraction: f64) -> Vector3<f64> {
        let turned = self.angle * fraction;
        self.before * turned.cos() + self.side * turned.sin()
    }

    pub fn centre(&self) -> Point3<f64> {
        self.begin + self.side * self.radius
    }

    /// How many chords keep within `chord` of the arc: the sagitta of one is r·(1 - cos(angle / 2n)).
    pub fn chords(&self, chord: f64) -> u32 {
        let widest = 2.0 * (1.0 - (chord / self.radius).clamp(1e-6, 1.0)).acos();
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // from 1 to some thousand
        let count = (self.angle / widest).ceil().clamp(1.0, 4096.0) as u32;
        count
    }
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
    fn a_side_is_shared_as_its_arcs_need_it() {
        // A right angle takes 8 mm of the side of 12 mm, one of 2·atan(1/4) a quarter of 8 mm: both fit, although the
        // first needs more than half.
        let (cos, sin) = (15.0 / 17.0, 8.0 / 17.0);
        let path = [[0., 0.], [20., 0.], [20., 12.], [20. - 30. * sin, 12. + 30. * cos]];
        let path = path.map(|[x, y]| Point3::new(x, y, 0.));
        let line = centreline(&path, mm(8.0), mm(1e-4));
        assert!(line.tightened.is_empty());
        let bends = std::f64::consts::FRAC_PI_2 + 2.0 * 0.25_f64.atan();
        let expected = 62.0 - 2.0 * (8.0 + 2.0) + 8.0 * bends;
        assert!((length(&line.points) - expected).abs() < 1e-3, "{}", length(&line.points));
        // On 9 mm they do not: the gentle one keeps its 2 mm, 7 mm are left for the other.
        let path =
            [path[0], path[1], Point3::new(20., 9., 0.), Point3::new(20. - 30. * sin, 9. + 30. * cos, 0.)];
        let line = centreline(&path, mm(8.0), mm(1e-4));
        assert_eq!(line.tightened, [1]);
        let expected = 59.0 - 2.0 * 9.0 + 7.0 * std::f64::consts::FRAC_PI_2 + 8.0 * 2.0 * 0.25_f64.atan();
        assert!((length(&line.points) - expected).abs() < 1e-3, "{}", length(&line.points));
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
