//! A wire that is known by its corners, as steps.

use nalgebra::{Point3, Vector3};

use crate::bend::{Frame, Step};
use crate::units::{Angle, Length};

/// The sine of an angle below which two directions are one, and have no plane.
const ON_ONE_LINE: f64 = 1e-9;

/// The steps of a wire that a machine has bent, from its ends and corners in mm, and the frame in which they begin.
///
/// Corners say neither to which side a bend was run nor how the head was wound: that is as in the `scheduled` steps, which begin at
/// `start`. `None` where the points are not one more than the steps, or two that follow each other are the same.
#[must_use]
pub fn steps_of_corners(
    points: &[Point3<f64>],
    start: &Frame,
    scheduled: &[Step],
) -> Option<(Frame, Vec<Step>)> {
    if points.len() != scheduled.len() + 1 {
        return None;
    }
    let parts: Option<Vec<(Vector3<f64>, f64)>> = points
        .windows(2)
        .map(|pair| {
            let length = (pair[1] - pair[0]).norm();
            Some(((pair[1] - pair[0]).try_normalize(1e-12)?, length))
        })
        .collect();
    let parts = parts?;
    let &(first, _) = parts.first()?;
    let begin = Frame::looking(*points.first()?, first, start.b().cross(&first))?;
    let mut frame = begin;
    let mut steps = Vec::with_capacity(scheduled.len());
    for (k, (step, &(_, length))) in scheduled.iter().zip(&parts).enumerate() {
        let next = parts.get(k + 1).map(|&(next, _)| next);
        let (rotate, bend) = next.map_or((step.rotate, Angle::ZERO), |next| turns(&frame, next, step));
        frame.rotate(rotate);
        frame.bend(bend);
        steps.push(Step { feed: Length::computed(length), rotate, bend });
    }
    Some((begin, steps))
}

/// The rotation and the bend that turn a frame to look along `next`, run as a step is.
fn turns(frame: &Frame, next: Vector3<f64>, step: &Step) -> (Angle, Angle) {
    let side = if step.bend < Angle::ZERO { -1.0 } else { 1.0 };
    let across = frame.t().cross(&next);
    let size = across.norm().atan2(frame.t().dot(&next));
    let bend = Angle::computed(side * size);
    let Some(axis) = across.try_normalize(ON_ONE_LINE) else { return (step.rotate, bend) };
    let wanted = axis * side;
    let turned = (-frame.n().dot(&wanted)).atan2(frame.b().dot(&wanted));
    let whole = std::f64::consts::TAU;
    let rotate = turned + whole * ((step.rotate.rad() - turned) / whole).round();
    (Angle::computed(rotate), bend)
}
