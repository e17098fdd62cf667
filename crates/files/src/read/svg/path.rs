//! The data of a path element: all its commands, arcs as arcs.
//!
//! `svgtypes` splits the text into commands. Its `SimplifyingPathParser` would also resolve relative and smooth ones, but
//! makes cubics of arcs, within 0.1 of whatever unit the file has: a circle of 5 mm would be bent 0.1 mm off.

use kurbo::{Arc, SvgArc};
use nalgebra::{Affine3, Point3, Rotation3, Vector3};
use svgtypes::{PathParser, PathSegment};
use wirebend_core::curve::{EllipticArc, Spline};
use wirebend_core::units::Angle;

use super::super::outline::{Outline, Piece};

/// A point of the page, y down as in the file.
pub(super) fn flat(x: f64, y: f64) -> Point3<f64> {
    Point3::new(x, y, 0.0)
}

/// One outline for each move.
///
/// # Errors
/// What the parser says.
pub(super) fn outlines(data: &str) -> Result<Vec<Outline>, svgtypes::Error> {
    let mut path = Path::default();
    for segment in PathParser::from(data) {
        path.segment(segment?);
    }
    Ok(path.done)
}

/// The path so far.
#[derive(Default)]
struct Path {
    done: Vec<Outline>,
    at: Point3<f64>,
    start: Point3<f64>,
    /// Whether the next segment belongs to the last outline.
    open: bool,
    /// The last control point of the curve that ends here, and whether it is a cubic one.
    control: Option<(Point3<f64>, bool)>,
}

impl Path {
    fn segment(&mut self, segment: PathSegment) {
        let origin = if segment.is_abs() { Vector3::zeros() } else { self.at.coords };
        let point = |x, y| flat(x, y) + origin;
        let (at, last) = (self.at, self.control.take());
        // A smooth curve begins as the curve of its kind before it ended.
        let mirrored = |is_cubic| match last {
            Some((control, was_cubic)) if was_cubic == is_cubic => at + (at - control),
            _ => at,
        };
        match segment {
            PathSegment::MoveTo { x, y, .. } => {
                self.at = point(x, y);
                self.start = self.at;
                self.open = false;
            }
            PathSegment::LineTo { x, y, .. } => self.add(point(x, y), Piece::Line(point(x, y))),
            PathSegment::HorizontalLineTo { x, .. } => {
                let to = flat(x + origin.x, at.y);
                self.add(to, Piece::Line(to));
            }
            PathSegment::VerticalLineTo { y, .. } => {
                let to = flat(at.x, y + origin.y);
                self.add(to, Piece::Line(to));
            }
            PathSegment::CurveTo { x1, y1, x2, y2, x, y, .. } => {
                self.curve(&[point(x1, y1), point(x2, y2), point(x, y)]);
            }
            PathSegment::SmoothCurveTo { x2, y2, x, y, .. } => {
                self.curve(&[mirrored(true), point(x2, y2), point(x, y)]);
            }
            PathSegment::Quadratic { x1, y1, x, y, .. } => self.curve(&[point(x1, y1), point(x, y)]),
            PathSegment::SmoothQuadratic { x, y, .. } => self.curve(&[mirrored(false), point(x, y)]),
            PathSegment::EllipticalArc { rx, ry, x_axis_rotation, large_arc, sweep, x, y, .. } => {
                let to = point(x, y);
                self.add(to, arc(at, to, [rx, ry], x_axis_rotation, large_arc, sweep));
            }
            PathSegment::ClosePath { .. } => {
                if let (true, Some(outline)) = (self.open, self.done.last_mut()) {
                    outline.closed = true;
                }
                self.at = self.start;
                self.open = false;
            }
        }
    }

    fn add(&mut self, to: Point3<f64>, piece: Piece) {
        if !self.open {
            self.done.push(Outline::new(self.at));
            self.open = true;
        }
        if let Some(outline) = self.done.last_mut() {
            outline.pieces.push(piece);
        }
        self.at = to;
    }

    /// A Bézier curve through control points to the last of them.
    fn curve(&mut self, points: &[Point3<f64>]) {
        let mut control = vec![self.at];
        control.extend(points);
        let (last, to) = (control[control.len() - 2], control[control.len() - 1]);
        // Three or four points are always a curve.
        let piece = Spline::bezier(control).map_or(Piece::Line(to), Piece::Spline);
        self.add(to, piece);
        self.control = Some((last, points.len() == 3));
    }
}

/// Shorter than this, `kurbo` takes the distance between the ends of an arc for zero where it divides by its square.
const MIN_CHORD: f64 = 1e-100;

/// The arc of a path from its two ends, whose centre `kurbo` works out: radii of 0 are a straight line, radii that are too
/// short are stretched.
pub(super) fn arc(
    from: Point3<f64>,
    to: Point3<f64>,
    radii: [f64; 2],
    rotation_deg: f64,
    large_arc: bool,
    sweep: bool,
) -> Piece {
    let ends = SvgArc {
        from: kurbo::Point::new(from.x, from.y),
        to: kurbo::Point::new(to.x, to.y),
        radii: kurbo::Vec2::new(radii[0], radii[1]),
        x_rotation: rotation_deg.to_radians(),
        large_arc,
        sweep,
    };
    let has_length = (to - from).norm() >= MIN_CHORD;
    let Some(arc) = has_length.then(|| Arc::from_svg_arc(&ends)).flatten() else { return Piece::Line(to) };
    let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), arc.x_rotation);
    let [u, v] = [Vector3::x() * arc.radii.x, Vector3::y() * arc.radii.y].map(|axis| turn * axis);
    match (Angle::from_rad(arc.start_angle), Angle::from_rad(arc.sweep_angle)) {
        (Ok(start), Ok(sweep)) => {
            Piece::Arc(EllipticArc { centre: flat(arc.center.x, arc.center.y), u, v, start, sweep }, to)
        }
        // Radii that leave the finite numbers.
        _ => Piece::Line(flat(f64::NAN, f64::NAN)),
    }
}

/// The map of a matrix a b c d e f of the file.
pub(super) fn affine(m: &svgtypes::Transform) -> Affine3<f64> {
    Affine3::from_matrix_unchecked(nalgebra::Matrix4::new(
        m.a, m.c, 0.0, m.e, //
        m.b, m.d, 0.0, m.f, //
        0.0, 0.0, 1.0, 0.0, //
        0.0, 0.0, 0.0, 1.0,
    ))
}
