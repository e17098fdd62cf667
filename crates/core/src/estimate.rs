//! What a wire takes: time, stock, mass and money.

use crate::bend::Step;
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

/// How long the parts of a step take, in s.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StepSeconds {
    /// Feed.
    pub feed: f64,
    /// Turn of the head.
    pub rotate: f64,
    /// The bend axis out to the commanded angle and back.
    pub bend: f64,
    /// What a bend takes besides: the way to where the peg comes out and the way back, the peg comes out and goes in.
    pub wait: f64,
}

impl StepSeconds {
    /// The whole step.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.feed + self.rotate + self.bend + self.wait
    }
}

impl TimeModel {
    /// How long the parts of a step take as the machine is told it. `detour`: how much farther the bend axis goes than beside straight
    /// wire before the peg comes out ([`CompensatedProgram::peg_detour`]); that far it has to come back, too.
    #[must_use]
    pub fn step_seconds(&self, told: &Step, detour: Angle) -> StepSeconds {
        let bends = told.bend != Angle::ZERO;
        let fixed = if bends { self.fixed_per_bend_s } else { 0.0 };
        let detour = 2.0 * detour.abs().deg() / self.bend_deg_per_s;
        // A machine whose bends take no time besides does not wait for its peg.
        let (wait, way) = if fixed > 0.0 { (fixed + detour, 0.0) } else { (0.0, detour) };
        StepSeconds {
            feed: told.feed.abs().mm() / self.feed_mm_per_s,
            rotate: told.rotate.abs().deg() / self.rotate_deg_per_s,
            bend: if bends { self.bend_seconds(told.bend) - fixed + way } else { 0.0 },
            wait,
        }
    }

    /// The same of each step of a program.
    pub fn each_step<'p>(
        &'p self,
        program: &'p CompensatedProgram,
    ) -> impl Iterator<Item = StepSeconds> + 'p {
        let step_seconds = |(index, told)| self.step_seconds(told, program.peg_detour(index));
        program.steps().iter().enumerate().map(step_seconds)
    }

    /// Seconds for a bend: out to the commanded angle, back, and what every bend takes.
    #[must_use]
    pub fn bend_seconds(&self, command: Angle) -> f64 {
        2.0 * command.abs().deg() / self.bend_deg_per_s + self.fixed_per_bend_s
    }

    /// Seconds for a program: each feed, turn of the head and bend after the other.
    #[must_use]
    pub fn seconds(&self, program: &CompensatedProgram) -> f64 {
        self.each_step(program).map(|step| step.total()).sum()
    }
}

/// What the wire is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WireModel {
    /// Diameter.
    pub diameter: Length,
    /// Density, in kg/m³.
    pub density_kg_per_m3: f64,
    /// Young's modulus, in gigapascal.
    pub youngs_modulus_gpa: f64,
    /// Price of a millimetre; none where nobody knows.
    pub price_per_mm: Option<f64>,
}

impl WireModel {
    /// Area of its cross-section, in mm².
    #[must_use]
    pub fn section_mm2(&self) -> f64 {
        std::f64::consts::FRAC_PI_4 * self.diameter.mm().powi(2)
    }

    /// Young's modulus in megapascal, which are N/mm².
    #[must_use]
    pub fn youngs_modulus_mpa(&self) -> f64 {
        self.youngs_modulus_gpa * 1.0e3
    }

    /// Mass of a length of wire, in g.
    #[must_use]
    pub fn mass_g(&self, length: Length) -> f64 {
        // kg/m³ is 1e-6 g/mm³.
        length.mm() * self.section_mm2() * self.density_kg_per_m3 * 1.0e-6
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

#[cfg(test)]
mod tests {
    use crate::testing::{mm, published_machine};

    #[test]
    fn the_published_jobs_cost_their_length_at_the_published_price() {
        // Cube, house, cup holder, pegboard, phone stand and spring: mm, and USD at 0.00199 a mm.
        let jobs =
            [(241.0, 0.480), (292.0, 0.581), (469.0, 0.933), (380.0, 0.756), (362.0, 0.720), (641.0, 1.276)];
        let wire = published_machine().wire;
        for (length, cost) in jobs {
            assert!((wire.cost(mm(length)).unwrap() - cost).abs() < 1e-3, "{length} mm");
        }
        // 3 mm aluminium of 2.7 g/cm³ weighs 19.1 g a metre.
        assert!((wire.mass_g(mm(1000.0)) - 19.085).abs() < 1e-3);
    }
}
