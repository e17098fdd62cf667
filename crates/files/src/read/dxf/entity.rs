//! Shapes of records, one record each.

use nalgebra::{Affine3, Matrix3, Point3, Vector3};
use wirebend_core::curve::EllipticArc;
use wirebend_core::units::Angle;

use super::super::error::ReadError;
use super::super::note::NoteKind;
use super::super::outline::{Outline, Piece};
use super::record::Record;
use super::shape::{Insert, Shape};
use super::{faces, spline};

/// Of every record but the vertices of a polyline, which follow theirs as records of their own.
pub(super) fn shape(record: &Record<'_>) -> Shape {
    read(record).unwrap_or_else(Shape::broken)
}

fn read(record: &Record<'_>) -> Result<Shape, ReadError> {
    let outline = match record.kind.as_str() {
        "LINE" => {
            let mut outline = Outline::new(record.point(10)?);
            outline.pieces.push(Piece::Line(record.point(11)?));
            outline
        }
        "LWPOLYLINE" => light_polyline(record)?,
        "CIRCLE" => arc(record, 0.0, 360.0)?,
        "ARC" => arc(record, record.needed(50)?, record.needed(51)?)?,
        "ELLIPSE" => ellipse(record)?,
        "SPLINE" | "HELIX" => return spline::shape(record),
        "3DFACE" => return faces::face(record),
        "INSERT" => return Ok(Shape::Insert(Box::new(insert(record)?))),
        other => return Ok(Shape::Ignored(ignored(other))),
    };
    Ok(Shape::Outline(outline))
}

/// How an entity of a kind that is not read is counted.
fn ignored(kind: &str) -> NoteKind {
    match kind {
        "TEXT" | "MTEXT" | "ATTRIB" | "ATTDEF" | "RTEXT" | "ARCALIGNEDTEXT" | "TOLERANCE" => {
            NoteKind::TextsIgnored
        }
        "HATCH" | "MPOLYGON" | "WIPEOUT" => NoteKind::HatchesIgnored,
        "DIMENSION" | "ARC_DIMENSION" | "LARGE_RADIAL_DIMENSION" | "LEADER" | "MLEADER" | "MULTILEADER" => {
            NoteKind::DimensionsIgnored
        }
        "SOLID" | "TRACE" | "MESH" | "3DSOLID" | "BODY" | "REGION" | "SURFACE" | "EXTRUDEDSURFACE"
        | "LOFTEDSURFACE" | "REVOLVEDSURFACE" | "SWEPTSURFACE" | "PLANESURFACE" => NoteKind::SurfacesIgnored,
        "IMAGE" | "OLEFRAME" | "OLE2FRAME" | "UNDERLAY" | "PDFUNDERLAY" => NoteKind::ImagesIgnored,
        "POINT" => NoteKind::PointsIgnored,
        _ => NoteKind::ElementsIgnored,
    }
}

/// A linear map as one that moves nothing.
pub(super) fn affine(linear: &Matrix3<f64>) -> Affine3<f64> {
    Affine3::from_matrix_unchecked(linear.to_homogeneous())
}

fn angle(deg: f64) -> Angle {
    Angle::from_deg(deg).unwrap_or_default()
}

/// So far a whole turn may be from 2π in a file of six digits.
const ROUNDED_DEG: f64 = 1e-3;

/// How far it is from one angle in degrees on to another, more than 0 and up to a whole turn.
fn turn(from: f64, to: f64) -> f64 {
    let turn = (to - from).rem_euclid(360.0);
    if turn > 0.0 { turn } else { 360.0 }
}

/// Against the clock as seen from the extrusion, angles in degrees.
fn arc(record: &Record<'_>, from: f64, to: f64) -> Result<Outline, ReadError> {
    let radius = record.needed(40)?.abs();
    let (u, v) = (Vector3::x() * radius, Vector3::y() * radius);
    let (start, sweep) = (angle(from), angle(turn(from, to)));
    let arc = EllipticArc { centre: record.point(10)?, u, v, start, sweep };
    Ok(Outline::arc(arc).mapped(&affine(&record.axes()?)))
}

/// Centre and major axis are in the coordinates of the drawing, parameters in radians from the major axis.
fn ellipse(record: &Record<'_>) -> Result<Outline, ReadError> {
    let u = record.point(11)?.coords;
    let v = record.axes()?.column(2).cross(&u) * record.needed(40)?;
    let from = record.real(41)?.unwrap_or_default().to_degrees();
    let to = record.real(42)?.unwrap_or(std::f64::consts::TAU).to_degrees();
    // Files have 2π with a few digits: rounded up it would begin a second turn, and be next to nothing of it.
    let whole = ((to - from).abs() - 360.0).abs() < ROUNDED_DEG;
    let (start, sweep) = (angle(from), angle(if whole { 360.0 } else { turn(from, to) }));
    Ok(Outline::arc(EllipticArc { centre: record.point(10)?, u, v, start, sweep }))
}

/// A vertex of a polyline, and how much the way to the next one bulges: the tangent of a quarter of its angle.
pub(super) type Corner = (Point3<f64>, f64);

/// All vertices stand in the one record, each from its x on.
fn light_polyline(record: &Record<'_>) -> Result<Outline, ReadError> {
    let elevation = record.real(38)?.unwrap_or_default();
    let mut corners: Vec<Corner> = Vec::new();
    for pair in &record.pairs {
        match (pair.code, corners.last_mut()) {
            (10, _) => {
                corners.push((Point3::new(pair.real(record.source)?, f64::NAN, elevation), 0.0));
            }
            (20, Some((point, _))) => point.y = pair.real(record.source)?,
            (42, Some((_, bulge))) => *bulge = pair.real(record.source)?,
            _ => {}
        }
    }
    if corners.iter().any(|(point, _)| point.y.is_nan()) {
        return Err(record.lacks(20));
    }
    let outline = bulged(&corners, record.flag(1)?).ok_or_else(|| record.lacks(10))?;
    Ok(outline.mapped(&affine(&record.axes()?)))
}

/// The outline through the vertices of a plane polyline; none without vertices.
pub(super) fn bulged(corners: &[Corner], closed: bool) -> Option<Outline> {
    let (&(start, _), &(end, last)) = (corners.first()?, corners.last()?);
    let mut outline = Outline::new(start);
    outline.pieces.extend(corners.windows(2).map(|pair| piece(pair[0].0, pair[1].0, pair[0].1)));
    if closed && last != 0.0 {
        outline.pieces.push(piece(end, start, last));
    }
    outline.closed = closed;
    Some(outline)
}

/// The way between two vertices: positive bulges go against the clock, so that the arc is to the right of the chord
/// and its centre, for less than half a turn, to the left.
fn piece(from: Point3<f64>, to: Point3<f64>, bulge: f64) -> Piece {
    let chord = to - from;
    if bulge == 0.0 || chord == Vector3::zeros() {
        return Piece::Line(to);
    }
    let left = Vector3::new(-chord.y, chord.x, 0.0);
    let centre = nalgebra::center(&from, &to) + left * ((1.0 - bulge * bulge) / (4.0 * bulge));
    let u = from - centre;
    let v = Vector3::new(-u.y, u.x, 0.0);
    let sweep = Angle::from_rad(4.0 * bulge.atan()).unwrap_or_default();
    Piece::Arc(EllipticArc { centre, u, v, start: Angle::ZERO, sweep }, to)
}

fn insert(record: &Record<'_>) -> Result<Insert, ReadError> {
    let block = record.name(2).ok_or_else(|| record.lacks(2))?;
    let [x, y, z] = [41, 42, 43].map(|code| record.real(code));
    let scale = Vector3::new(x?.unwrap_or(1.0), y?.unwrap_or(1.0), z?.unwrap_or(1.0));
    let scale = Matrix3::from_diagonal(&scale);
    let deg = record.real(50)?.unwrap_or_default();
    let turn = nalgebra::Rotation3::from_axis_angle(&Vector3::z_axis(), deg.to_radians());
    let own = record.axes()? * turn.matrix();
    let at = record.axes()? * record.point(10)?;
    let map = nalgebra::Translation3::from(at.coords).to_homogeneous() * (own * scale).to_homogeneous();
    let (columns, rows) = (record.real(44)?.unwrap_or_default(), record.real(45)?.unwrap_or_default());
    let steps = [own * Vector3::x() * columns, own * Vector3::y() * rows];
    let counts = [record.whole(70)?.unwrap_or(1).max(1), record.whole(71)?.unwrap_or(1).max(1)];
    Ok(Insert { block, map: Affine3::from_matrix_unchecked(map), steps, counts })
}
