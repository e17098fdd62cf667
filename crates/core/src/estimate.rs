//! What a wire takes: time, stock, mass and money.

use crate::compensate::{CompensatedProgram, ToldStep};
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
    /// What every feed takes besides its motion, in s.
    pub fixed_per_feed_s: f64,
    /// What every turn of the head takes besides its motion, in s.
    pub fixed_per_turn_s: f64,
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
    pub fn step_seconds(&self, told: &ToldStep, detour: Angle) -> StepSeconds {
        let bends = told.bends();
        let fixed = if bends { self.fixed_per_bend_s } else { 0.0 };
        let beyond_zero = Angle::computed(told.beyond_zero().max(0.0));
        let there_and_back = |way: f64| 2.0 * way / self.bend_deg_per_s;
        let detour = there_and_back(detour.abs().deg());
        // A machine whose bends take no time besides does not wait for its peg.
        let (wait, way) = if fixed > 0.0 { (fixed + detour, 0.0) } else { (0.0, detour) };
        // What ends before zero bends on a part of the way that others have only gone until they are there.
        let approach = told.approach.filter(|_| bends && told.beyond_zero() < 0.0);
        let pressing = approach.map_or(0.0, |at| (at.abs() - told.step.bend.abs()).deg().max(0.0));
        let pressing = there_and_back(pressing).min(wait);
        StepSeconds {
            feed: moving(told.step.feed.mm(), self.feed_mm_per_s, self.fixed_per_feed_s),
            rotate: moving(told.step.rotate.deg(), self.rotate_deg_per_s, self.fixed_per_turn_s),
            bend: if bends { self.bend_seconds(beyond_zero) - fixed + way + pressing } else { 0.0 },
            wait: wait - pressing,
        }
    }

    /// The same of each step of a program.
    pub fn each_step<'p>(
        &'p self,
        program: &'p CompensatedProgram,
    ) -> impl Iterator<Item = StepSeconds> + 'p {
        let step_seconds =
            |(index, told): (usize, ToldStep)| self.step_seconds(&told, program.peg_detour(index));
        program.told().enumerate().map(step_seconds)
    }

    /// Seconds for a bend: out to the commanded angle, back, and what every bend takes. Of one that ends before zero the angle is zero:
    /// its axis goes no farther than every peg does to come out.
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

/// Seconds for a motion at a rate, and for what every one takes; what does not move takes nothing.
fn moving(way: f64, rate: f64, fixed: f64) -> f64 {
    if way == 0.0 { 0.0 } else { way.abs() / rate + fixed }
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
    use super::{StepSeconds, TimeModel};
    use crate::bend::Step;
    use crate::compensate::ToldStep;
    use crate::testing::{deg, mm, published_machine};
    use crate::units::Angle;

    /// The axis does not have to come to zero and back for it.
    #[test]
    fn a_bend_that_ends_before_zero_takes_no_longer_than_to_bring_the_peg_out() {
        let time = published_machine().time;
        let bend = |bend: f64, approach: Option<f64>| {
            let step = Step { bend: deg(bend), ..Step::default() };
            let seconds = time.step_seconds(&ToldStep { step, approach: approach.map(deg) }, Angle::ZERO);
            (seconds.bend, seconds.wait)
        };
        let (pressing, wait) = bend(-10.0, Some(-18.25));
        assert!((pressing + wait - time.fixed_per_bend_s).abs() < 1e-9, "{pressing} {wait}");
        // From 18.25 degrees before zero to 10, and back.
        assert!((pressing - 2.0 * 8.25 / time.bend_deg_per_s).abs() < 1e-9, "{pressing}");
        assert_eq!(bend(0.0, None), (0.0, 0.0), "no bend");
        assert!((bend(10.0, Some(-18.25)).0 - 20.0 / time.bend_deg_per_s).abs() < 1e-9);
    }

    /// 50 mm at 25 mm/s, and 90° at 45°/s, each after 1.5 s in which nothing moves.
    #[test]
    fn what_feeds_and_turns_takes_what_each_does_besides() {
        let time = TimeModel {
            feed_mm_per_s: 25.0,
            rotate_deg_per_s: 45.0,
            fixed_per_feed_s: 1.5,
            fixed_per_turn_s: 1.5,
            ..published_machine().time
        };
        let step = Step { feed: mm(50.0), rotate: deg(-90.0), ..Step::default() };
        let seconds = time.step_seconds(&ToldStep { step, approach: None }, Angle::ZERO);
        assert_eq!(seconds, StepSeconds { feed: 3.5, rotate: 3.5, ..StepSeconds::default() });
        let still = time.step_seconds(&ToldStep { step: Step::default(), approach: None }, Angle::ZERO);
        assert_eq!(still, StepSeconds::default());
    }

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
