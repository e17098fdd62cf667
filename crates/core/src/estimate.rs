//! What a wire takes: time, stock, mass and money.

use crate::compensate::CompensatedProgram;
use crate::units::{Angle, Length};

/// How fast a machine is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TimeModel {
    /// Feed, in mm/s.
    pub feed_mm_per_s: f64,
    /// Head, in °/s.
    pub rotate_deg_per_s: f64,
    /// Bend axis, in °/s.
    pub bend_deg_per_s: f64,
    /// What every bend takes besides its stroke (pin, settling), in s.
    pub fixed_per_bend_s: f64,
}

impl TimeModel {
    /// Seconds for a bend: out to the commanded angle, back, and what every bend takes.
    #[must_use]
    pub fn bend_seconds(&self, command: Angle) -> f64 {
        2.0 * command.abs().deg() / self.bend_deg_per_s + self.fixed_per_bend_s
    }

    /// Seconds for a program: each feed, turn of the head and bend after the other.
    #[must_use]
    pub fn seconds(&self, program: &CompensatedProgram) -> f64 {
        let step_seconds = |step: &crate::bend::Step| {
            let bend = if step.bend == Angle::ZERO { 0.0 } else { self.bend_seconds(step.bend) };
            step.feed.abs().mm() / self.feed_mm_per_s + step.rotate.abs().deg() / self.rotate_deg_per_s + bend
        };
        program.steps().iter().map(step_seconds).sum()
    }
}

/// What the wire is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WireModel {
    /// Diameter.
    pub diameter: Length,
    /// Density, in kg/m³.
    pub density_kg_per_m3: f64,
    /// Price of a millimetre; none where nobody knows.
    pub price_per_mm: Option<f64>,
}

impl WireModel {
    /// Mass of a length of wire, in g.
    #[must_use]
    pub fn mass_g(&self, length: Length) -> f64 {
        let section_mm2 = std::f64::consts::FRAC_PI_4 * self.diameter.mm().powi(2);
        // kg/m³ is 1e-6 g/mm³.
        length.mm() * section_mm2 * self.density_kg_per_m3 * 1.0e-6
    }

    /// Price of a length of wire.
    #[must_use]
    pub fn cost(&self, length: Length) -> Option<f64> {
        self.price_per_mm.map(|price| price * length.mm())
    }
}

/// The stock that has to be loaded: all feeds, and the tail that cannot be fed.
#[must_use]
pub fn stock(program: &CompensatedProgram, tail: Length) -> Length {
    program.feed_total() + tail
}
