//! Why a table is not written: which key, or which wire and step, and what to do.

use wirebend_driver_api::DriverError;

use crate::values::LengthUnit;

/// A setting with an invalid value.
pub(crate) fn setting(message: impl Into<String>, help: impl Into<String>) -> DriverError {
    DriverError::new("settings", message, help)
}

/// A value that is NaN or infinite; `place` is a step or a point. Indices are from 0, here and below.
pub(crate) fn not_a_number(wire: usize, place: &str, index: usize, what: &str, value: f64) -> DriverError {
    let message = format!("wire {}, {place} {}: {what} is {value}, expected a number", wire + 1, index + 1);
    DriverError::new("not-a-number", message, "plan the design again")
}

pub(crate) fn empty(wire: usize, what: &str) -> DriverError {
    let message = format!("wire {} has no {what}, expected one at least", wire + 1);
    DriverError::new("empty-wire", message, "plan the design again")
}

pub(crate) fn radius(value: f64) -> DriverError {
    let message = format!("the bend radius of the job is {value} mm, expected 0 or more");
    DriverError::new(
        "bend-radius",
        message,
        "correct the pin's radius or the wire's diameter in the profiles",
    )
}

pub(crate) fn negative_feed(wire: usize, step: usize, feed_mm: f64) -> DriverError {
    let message =
        format!("wire {}, step {}: the length is {feed_mm} mm, expected 0 or more", wire + 1, step + 1);
    DriverError::new("negative-length", message, "plan the design again")
}

pub(crate) fn too_sharp(wire: usize, step: usize, bend_deg: f64) -> DriverError {
    let (wire, step) = (wire + 1, step + 1);
    let message = format!("wire {wire}, step {step}: the bend is {bend_deg} degrees, expected -180 to 180");
    DriverError::new("bend-range", message, "plan the design again")
}

const CORNERS: &str = "or write lengths from corner to corner: set 'lengths' to intersection";

pub(crate) fn no_corner(wire: usize, step: usize) -> DriverError {
    let (wire, step) = (wire + 1, step + 1);
    let message = format!(
        "wire {wire}, step {step}: there is no length from tangent to tangent, since a bend of 180 degrees \
         beside it has no corner"
    );
    DriverError::new("no-corner", message, format!("make the bend less sharp, {CORNERS}"))
}

pub(crate) fn overlap(wire: usize, step: usize, short_mm: f64, radius_mm: f64) -> DriverError {
    let (wire, step) = (wire + 1, step + 1);
    let message = format!(
        "wire {wire}, step {step}: the arcs of radius {radius_mm} mm at its ends overlap by {short_mm:.3} mm"
    );
    let help = format!("make the edge longer by that, bend around a smaller pin, {CORNERS}");
    DriverError::new("arcs-overlap", message, help)
}

pub(crate) fn too_long(wire: usize, value: f64, unit: LengthUnit, decimals: u8) -> DriverError {
    let unit = unit.word();
    let message = format!(
        "wire {}: {value} {unit} with {decimals} decimals has more digits than are written without fault",
        wire + 1
    );
    DriverError::new("too-long", message, "lower 'decimals', or look at the scale of the design")
}
