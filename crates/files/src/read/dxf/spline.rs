//! SPLINE, and HELIX, which is one with more groups behind.

use nalgebra::Point3;
use wirebend_core::curve::Spline;
use wirebend_error::ErrorRemedy;

use super::super::error::ReadError;
use super::super::note::NoteKind;
use super::super::outline::{Outline, Piece};
use super::fit::{Ends, through};
use super::record::Record;
use super::shape::Shape;

/// By its control points, weights and knots; without control points through the points that it was fitted to, and with
/// the directions of its ends where they are given.
pub(super) fn shape(record: &Record<'_>) -> Result<Shape, ReadError> {
    let source = record.source;
    let (mut control, mut fit) = (Vec::new(), Vec::new());
    let (mut knots, mut weights) = (Vec::new(), Vec::new());
    // The groups of a helix mean something else from its own part on.
    let of_spline = record.pairs.iter().take_while(|pair| !(pair.code == 100 && pair.text() == "AcDbHelix"));
    for pair in of_spline {
        let points: &mut Vec<Point3<f64>> = if pair.code % 10 == 0 { &mut control } else { &mut fit };
        match (pair.code, points.last_mut()) {
            (10 | 11, _) => points.push(Point3::new(pair.real(source)?, f64::NAN, 0.0)),
            (20 | 21, Some(point)) => point.y = pair.real(source)?,
            (30 | 31, Some(point)) => point.z = pair.real(source)?,
            (40, _) => knots.push(pair.real(source)?),
            (41, _) => weights.push(pair.real(source)?),
            _ => {}
        }
    }
    if control.iter().chain(&fit).any(|point| point.y.is_nan()) {
        return Err(record.lacks(20));
    }
    if control.is_empty() {
        return fitted(record, &fit);
    }
    let degree = record.whole(71)?.ok_or_else(|| record.lacks(71))?;
    let degree = usize::try_from(degree).unwrap_or_default();
    let spline = Spline::new(degree, knots, control, weights).map_err(|error| {
        let expected = "degree, knots and control points that fit together";
        source.refused(record.place.clone(), &error, expected, ErrorRemedy::ExportAgain)
    })?;
    // The first point that the curve has, which is not always a control point.
    let start = spline.start();
    Ok(Shape::Outline(Outline { start, pieces: vec![Piece::Spline(spline)], closed: false }))
}

fn fitted(record: &Record<'_>, fit: &[Point3<f64>]) -> Result<Shape, ReadError> {
    let direction = |code: i32| -> Result<_, ReadError> {
        Ok(if record.find(code).is_some() { Some(record.point(code)?.coords) } else { None })
    };
    let ends = if record.flag(1)? { Ends::Closed } else { Ends::Open([direction(12)?, direction(13)?]) };
    Ok(match through(fit, ends) {
        Some(spline) => {
            let closed = ends == Ends::Closed;
            Shape::Fitted(Outline { start: spline.start(), pieces: vec![Piece::Spline(spline)], closed })
        }
        // A helix of a program that leaves its spline away, or points on one another.
        None => Shape::Ignored(NoteKind::ElementsIgnored),
    })
}
