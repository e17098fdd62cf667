//! Units and the published wire, for the tests of this crate.

use wirebend_core::estimate::WireModel;
use wirebend_core::units::{Angle, Length};

pub(crate) fn mm(value: f64) -> Length {
    Length::from_mm(value).unwrap()
}

pub(crate) fn deg(value: f64) -> Angle {
    Angle::from_deg(value).unwrap()
}

/// The steel wire of Bend-Forming, by its diameter in mm.
pub(crate) fn steel_wire(diameter: f64) -> WireModel {
    WireModel {
        diameter: mm(diameter),
        density_kg_per_m3: 7800.0,
        youngs_modulus_gpa: 200.0,
        price_per_mm: None,
    }
}
