//! Large tetrahedral trusses as one plate: closed formulas of Bend-Forming (Bhundiya and Cordero 2023, section 4).
//!
//! They hold for many rings; a truss of a few is stiffer at its rim, and is better solved strut by strut.

use wirebend_core::estimate::WireModel;
use wirebend_core::units::Length;

/// The mean distance of the two faces from their planes over the diameter and the strain error of the struts, times depth over strut
/// (Eq 4).
const SURFACE: f64 = 0.119;

/// For so many rings at most the authors have fitted their factor of the frequency; far beyond them it is below zero.
const FITTED: u32 = 10;

/// What takes the place of 8/15 in Eq 7: the authors' own half, the tangent of an arc with pinned ends, and that of one
/// whose ends are clamped. A truss with rigid joints lies between the last two.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum BowedStrut {
    /// One half, as printed.
    #[default]
    Published,
    /// 8/15: the exact tangent of a flat arc that turns at its ends.
    Pinned,
    /// 4/45: the exact tangent of a flat arc whose ends do not turn.
    Clamped,
}

impl BowedStrut {
    fn factor(self) -> f64 {
        match self {
            Self::Published => 0.5,
            Self::Pinned => 8.0 / 15.0,
            Self::Clamped => 4.0 / 45.0,
        }
    }
}

/// A tetrahedral truss of many rings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Continuum {
    /// Rings around the middle triangle.
    pub rings: u32,
    /// Distance of the two faces, above zero.
    pub depth: Length,
    /// Across the truss: 2N + 1 struts; above zero.
    pub diameter: Length,
    /// Of the struts.
    pub wire: WireModel,
}

impl Continuum {
    /// Length of a strut of the faces.
    #[must_use]
    pub fn strut(&self) -> Length {
        Length::computed(self.diameter.mm() / (2.0 * f64::from(self.rings) + 1.0))
    }

    /// How far the faces are from their planes, RMS in mm, for each mm of standard deviation of the lengths (Eq 4).
    #[must_use]
    pub fn surface_per_length(&self) -> f64 {
        SURFACE * self.diameter.mm() / self.depth.mm()
    }

    /// The force in a strut, RMS in N, for each mm of standard deviation of the lengths (Eq 5): of each strut a third of
    /// the strain is held by the others.
    #[must_use]
    pub fn force_per_length(&self) -> f64 {
        self.axial_stiffness() / (3.0_f64.sqrt() * self.strut().mm())
    }

    /// E A of a straight strut, N.
    fn axial_stiffness(&self) -> f64 {
        self.wire.youngs_modulus_mpa() * self.wire.section_mm2()
    }

    /// The first frequency of the free truss in Hz (Eq 8), with struts that rise by `bow` times their length.
    ///
    /// The factor is the authors' fit to finite elements for 1 to 10 rings: of more rings nothing is said.
    #[must_use]
    pub fn first_frequency_hz(&self, bow: f64, strut: BowedStrut) -> Option<f64> {
        if self.rings > FITTED {
            return None;
        }
        let n = f64::from(self.rings);
        let fit = -0.0181 + 2.9778 / n - 4.9461 / n.powi(2) + 4.8929 / n.powi(3) - 2.3455 / n.powi(4);
        let softer = axial_share(bow, self.strut(), self.wire.diameter, strut);
        // MPa over kg/m³ is 1e6 m²/s², of which the root is m/s; the diameter in m.
        let speed = (self.wire.youngs_modulus_mpa() * softer / self.wire.density_kg_per_m3).sqrt() * 1.0e3;
        Some(fit * speed / (std::f64::consts::TAU * self.diameter.mm() * 1.0e-3))
    }
}

/// The axial stiffness of a bowed strut over that of a straight one (Eq 7): it rises by `bow` times its length.
///
/// ```
/// use wirebend_accuracy::{BowedStrut, axial_share};
/// use wirebend_core::units::Length;
/// // A strut of 61.237 mm of 0.9 mm wire that rises by 3 % has a thirty-fourth of its stiffness.
/// let (strut, wire) = (Length::from_mm(61.237)?, Length::from_mm(0.9)?);
/// let share = axial_share(0.03, strut, wire, BowedStrut::Published);
/// assert!((share - 0.0291).abs() < 1e-4);
/// # Ok::<(), wirebend_core::units::NotFinite>(())
/// ```
#[must_use]
pub fn axial_share(bow: f64, strut: Length, wire_diameter: Length, ends: BowedStrut) -> f64 {
    let radius_of_gyration = wire_diameter.mm() / 4.0;
    let slender = bow * strut.mm() / radius_of_gyration;
    1.0 / (1.0 + ends.factor() * slender * slender)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{mm, steel_wire};

    const STRUT: f64 = 61.237_243_57;

    fn rings(rings: u32) -> Continuum {
        let diameter = mm(STRUT * f64::from(2 * rings + 1));
        Continuum { rings, depth: mm(50.0), diameter, wire: steel_wire(0.9) }
    }

    fn near(value: f64, expected: f64, part: f64) {
        assert!((value / expected - 1.0).abs() < part, "{value} instead of {expected}");
    }

    /// Eq 4 in the authors' own normal form, for struts as long as the diagonals.
    #[test]
    fn the_surface_is_that_of_equation_4() {
        let truss = rings(3);
        near(truss.surface_per_length() * STRUT / truss.diameter.mm(), 0.1457, 1e-3);
    }

    /// The frequencies that the authors' factors give; κ is from the sheet beside their paper.
    #[test]
    fn frequencies_are_those_of_equation_8() {
        let published = [
            (3, 0.0, 1085.2),
            (3, 0.01, 500.4),
            (3, 0.03, 185.2),
            (10, 0.0, 147.2),
            (10, 0.01, 67.9),
            (10, 0.03, 25.1),
        ];
        for (n, bow, hz) in published {
            near(rings(n).first_frequency_hz(bow, BowedStrut::Published).unwrap(), hz, 1e-3);
        }
        assert_eq!(rings(11).first_frequency_hz(0.0, BowedStrut::Published), None);
    }

    /// A bow of 3 %, by a beam computation of the arc on its own.
    #[test]
    fn an_arc_is_softest_where_its_ends_turn() {
        let share = |ends| axial_share(0.03, mm(STRUT), mm(0.9), ends);
        near(share(BowedStrut::Pinned), 0.0274, 2e-3);
        near(share(BowedStrut::Clamped), 0.144, 4e-3);
        assert!(axial_share(0.0, mm(STRUT), mm(0.9), BowedStrut::Published).to_bits() == 1.0_f64.to_bits());
    }

    /// A reflector of 50 m that is to be true within 1 mm, with 5 N in its struts at most (section 4.3).
    #[test]
    fn a_large_reflector_asks_for_micrometres() {
        // As many rings as make the struts those of a regular truss of this depth.
        let truss =
            |wire| Continuum { rings: 408, depth: mm(50.0), diameter: mm(50_000.0), wire: steel_wire(wire) };
        near(1.0 / truss(0.9).surface_per_length(), 8.40e-3, 1e-3);
        near(5.0 / truss(0.9).force_per_length(), 4.168e-3, 1e-3);
        near(5.0 / truss(1.0).force_per_length(), 3.376e-3, 1e-3);
    }
}
