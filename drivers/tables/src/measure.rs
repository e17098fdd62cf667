//! Lengths of a wire in mm, before anything is rounded.

use wirebend_driver_api::{DesignStep, DriverError};

use crate::refusal;
use crate::values::Lengths;

/// Arcs that just meet may overlap by the last bits of a float, mm.
const MEETING_MM: f64 = 1e-6;

/// A straight part, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Part {
    /// Sum of the lengths of all straight parts up to the end of this one.
    pub sum_mm: f64,
    /// Distance along the wire from its start to the end of this one.
    pub distance_mm: f64,
}

/// The straight parts of a wire. Between corners the distance is the sum of the lengths; between tangents
/// the arcs that were passed are in the distance too, each radius times angle along the centreline.
pub(crate) fn parts(
    wire: usize,
    steps: &[DesignStep],
    radius_mm: f64,
    lengths: Lengths,
) -> Result<Vec<Part>, DriverError> {
    let (mut sum_mm, mut arcs_mm) = (0.0, 0.0);
    let part = |(n, step): (usize, &DesignStep)| {
        sum_mm += match lengths {
            Lengths::Tangent => straight(wire, n, step, radius_mm)?,
            Lengths::Intersection if step.feed_mm < 0.0 => {
                return Err(refusal::negative_feed(wire, n, step.feed_mm));
            }
            Lengths::Intersection => step.feed_mm,
        };
        let part = Part { sum_mm, distance_mm: sum_mm + arcs_mm };
        if lengths == Lengths::Tangent {
            arcs_mm += radius_mm * step.bend_deg.abs().to_radians();
        }
        Ok(part)
    };
    steps.iter().enumerate().map(part).collect()
}

fn straight(wire: usize, n: usize, step: &DesignStep, radius_mm: f64) -> Result<f64, DriverError> {
    let straight_mm = step.straight_mm.ok_or_else(|| refusal::no_corner(wire, n))?;
    if straight_mm < -MEETING_MM {
        return Err(refusal::overlap(wire, n, -straight_mm, radius_mm));
    }
    Ok(straight_mm.max(0.0))
}
