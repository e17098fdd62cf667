//! Units of frame files.

use wirebend_error::ErrorRemedy;

use super::super::error::{Location, ReadError};
use super::super::text::Source;

/// Standard gravity, m/s²: turns a weight per volume into a density.
const GRAVITY: f64 = 9.80665;

/// What is measured, and in what it is wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Quantity {
    /// mm².
    Area,
    /// mm⁴.
    SecondMoment,
    /// `MPa`.
    Stress,
    /// kg/m³.
    Density,
    /// N.
    Force,
    /// N mm.
    Moment,
    /// N/mm.
    LineForce,
}

/// Unit as files write it, without `^` and blanks, and what it is in the wanted one.
const UNITS: &[(Quantity, &str, f64)] = &[
    (Quantity::Area, "m2", 1e6),
    (Quantity::Area, "meter2", 1e6),
    (Quantity::Area, "cm2", 1e2),
    (Quantity::Area, "centimeter2", 1e2),
    (Quantity::Area, "mm2", 1.0),
    (Quantity::Area, "millimeter2", 1.0),
    (Quantity::SecondMoment, "m4", 1e12),
    (Quantity::SecondMoment, "meter4", 1e12),
    (Quantity::SecondMoment, "cm4", 1e4),
    (Quantity::SecondMoment, "centimeter4", 1e4),
    (Quantity::SecondMoment, "mm4", 1.0),
    (Quantity::SecondMoment, "millimeter4", 1.0),
    (Quantity::Stress, "kN/m2", 1e-3),
    (Quantity::Stress, "kN/cm2", 10.0),
    (Quantity::Stress, "N/mm2", 1.0),
    (Quantity::Stress, "MPa", 1.0),
    (Quantity::Stress, "GPa", 1e3),
    (Quantity::Stress, "Pa", 1e-6),
    (Quantity::Density, "kN/m3", 1e3 / GRAVITY),
    (Quantity::Density, "N/m3", 1.0 / GRAVITY),
    (Quantity::Density, "kg/m3", 1.0),
    (Quantity::Force, "kN", 1e3),
    (Quantity::Force, "N", 1.0),
    (Quantity::Moment, "kNm", 1e6),
    (Quantity::Moment, "Nm", 1e3),
    (Quantity::Moment, "Nmm", 1.0),
    (Quantity::LineForce, "kN/m", 1.0),
    (Quantity::LineForce, "N/m", 1e-3),
    (Quantity::LineForce, "N/mm", 1.0),
];

/// What one of a unit is in the wanted one.
///
/// # Errors
/// [`ReadError::Syntax`] for a unit that measures something else or is not known.
pub(crate) fn quantity(
    source: Source<'_>,
    place: &Location,
    wanted: Quantity,
    unit: &str,
) -> Result<f64, ReadError> {
    let plain: String = unit.chars().filter(|letter| !matches!(letter, '^' | ' ' | '-')).collect();
    let of_kind = || UNITS.iter().filter(|(kind, ..)| *kind == wanted);
    let found = of_kind().find(|(_, name, _)| *name == plain);
    found.map(|(.., factor)| *factor).ok_or_else(|| {
        let known: Vec<&str> = of_kind().map(|(_, name, _)| *name).collect();
        let expected = format!("one of the units {}", known.join(", "));
        source.syntax(place.clone(), unit, &expected, ErrorRemedy::CorrectFile)
    })
}
