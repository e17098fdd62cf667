//! The centreline and the edges of a wire, seen from one side.

use nalgebra::Point3;

use crate::write::centreline::{Arc, Piece};
use crate::write::drawing::{Layer, Point, Shape};
use crate::write::plane::View;

/// What is shorter than this, in mm, is seen as a point.
const POINT_MM: f64 = 1e-9;

/// The shapes of a wire: its centreline, and lines half a diameter to both sides of it, which is where the edges of a
/// round wire are seen. Arcs that are not seen along their axis become chords that leave them by no more than `chord`.
pub(super) fn outline(pieces: &[Piece], view: &View, diameter: f64, chord: f64) -> Vec<(Layer, Shape)> {
    let half = diameter / 2.0;
    let mut shapes = Vec::new();
    for piece in pieces {
        match piece {
            Piece::Straight([from, to]) => straight(&mut shapes, [*from, *to].map(|p| view.point(p)), half),
            Piece::Arc(arc) if faces(arc, view) => round(&mut shapes, arc, view, half),
            Piece::Arc(arc) => oblique(&mut shapes, arc, view, half, chord),
        }
    }
    let begin = pieces.first().map(|piece| end_of(piece, 0.0, view));
    let end = pieces.last().map(|piece| end_of(piece, 1.0, view));
    for (at, tangent) in begin.into_iter().chain(end) {
        shapes.push((Layer::Wire, end_face(at, tangent, half)));
    }
    shapes
}

/// The point and the direction at the beginning (0) or the end (1) of a piece.
pub(super) fn end_of(piece: &Piece, at: f64, view: &View) -> (Point, Point) {
    let (point, tangent): (Point3<f64>, _) = match piece {
        Piece::Straight([from, to]) => {
            let point = if at < 0.5 { *from } else { *to };
            (point, (to - from).try_normalize(0.0).unwrap_or_default())
        }
        Piece::Arc(arc) => (arc.at(at), arc.tangent(at)),
    };
    (view.point(point), view.vector(tangent))
}

fn straight(shapes: &mut Vec<(Layer, Shape)>, [from, to]: [Point; 2], half: f64) {
    let Some(aside) = aside([to[0] - from[0], to[1] - from[1]]) else {
        // Seen along the wire.
        shapes.push((Layer::Wire, Shape::Circle { centre: from, radius: half }));
        return;
    };
    shapes.push((Layer::Centreline, Shape::Line([from, to])));
    for side in [half, -half] {
        shapes.push((Layer::Wire, Shape::Line([from, to].map(|point| shifted(point, aside, side)))));
    }
}

fn faces(arc: &Arc, view: &View) -> bool {
    arc.before.cross(&arc.side).cross(&view.normal()).norm() < 1e-9
}

fn round(shapes: &mut Vec<(Layer, Shape)>, arc: &Arc, view: &View, half: f64) {
    let (centre, begin) = (view.point(arc.centre()), view.point(arc.begin));
    let from = (begin[1] - centre[1]).atan2(begin[0] - centre[0]);
    let left = arc.before.cross(&arc.side).dot(&view.normal()) > 0.0;
    let sweep = if left { arc.angle } else { -arc.angle };
    shapes.push((Layer::Centreline, Shape::Arc { centre, radius: arc.radius, from, sweep }));
    // A bend that is tighter than the wire is thick has no inner edge.
    for radius in [arc.radius + half, arc.radius - half].into_iter().filter(|radius| *radius > POINT_MM) {
        shapes.push((Layer::Wire, Shape::Arc { centre, radius, from, sweep }));
    }
}

fn oblique(shapes: &mut Vec<(Layer, Shape)>, arc: &Arc, view: &View, half: f64, chord: f64) {
    let count = arc.chords(chord);
    let places = (0..=count).map(|k| f64::from(k) / f64::from(count));
    let middle: Vec<(Point, Option<Point>)> =
        places.map(|at| (view.point(arc.at(at)), aside(view.vector(arc.tangent(at))))).collect();
    shapes.push((Layer::Centreline, Shape::Chain(middle.iter().map(|(point, _)| *point).collect())));
    for side in [half, -half] {
        // Where the wire runs towards the eye or away from it, its sides change places.
        let (mut chain, mut last): (Vec<Point>, Option<Point>) = (Vec::new(), None);
        let mut finish = |chain: &mut Vec<Point>| {
            let whole = std::mem::take(chain);
            if whole.len() > 1 {
                shapes.push((Layer::Wire, Shape::Chain(whole)));
            }
        };
        for (point, aside) in &middle {
            let turned = |a: &Point, b: &Point| a[0] * b[0] + a[1] * b[1] < 0.0;
            if aside.is_none() || last.zip(*aside).is_some_and(|(a, b)| turned(&a, &b)) {
                finish(&mut chain);
            }
            if let Some(aside) = *aside {
                chain.push(shifted(*point, aside, side));
            }
            last = *aside;
        }
        finish(&mut chain);
    }
}

/// The end of a wire: a line across it, or the circle that is seen along it.
fn end_face(at: Point, tangent: Point, half: f64) -> Shape {
    match aside(tangent) {
        Some(aside) => Shape::Line([shifted(at, aside, half), shifted(at, aside, -half)]),
        None => Shape::Circle { centre: at, radius: half },
    }
}

/// The unit vector to the left of a direction; none where it has no length.
fn aside([x, y]: Point) -> Option<Point> {
    let length = x.hypot(y);
    (length > POINT_MM).then(|| [-y / length, x / length])
}

fn shifted([x, y]: Point, [along_x, along_y]: Point, by: f64) -> Point {
    [x + along_x * by, y + along_y * by]
}
