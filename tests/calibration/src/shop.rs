//! A shop: a bender on the bench whose dimensions are not those of its profile, a protractor and a caliper.

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use wirebend_core::bend::Step;
use wirebend_core::units::Angle;
use wirebend_driver_api::Axis;
use wirebend_driver_wirebend_kit::bench::{
    Bench, Bender, Compliance, ErrorTerm, Made, Noise, Peg, Scale, Wire,
};

/// The published resolutions.
const SCALE: Scale =
    Scale { feed_mm_per_step: 0.0184, rotate_deg_per_step: 0.02188, bend_deg_per_step: 0.01676 };
/// Where the peg comes out: clear of a straight wire on every machine here.
const CLEAR_DEG: f64 = 24.0;

pub(crate) struct Shop {
    bench: Bench,
    noise: Noise,
    read: ChaCha8Rng,
}

impl Shop {
    /// A machine whose s, R, K and springback are so many times the published ones, and whose bends scatter by half a
    /// degree.
    pub fn new(factor: f64, seed: u64) -> Self {
        let bender =
            Bender { orbit_radius_mm: 20.4 * factor, orbit_offset_mm: 12.0 * factor, ..Bender::PUBLISHED };
        let wire = Wire { k_factor: 0.3 * factor, ..Wire::PUBLISHED };
        let give = Compliance::fitted(&bender, &wire, 10.23 * factor).unwrap();
        let noise = Noise { seed, bend_deg: ErrorTerm { bias: 0.0, sigma: 0.5 }, ..Noise::default() };
        let bench = Bench::new(bender, wire, SCALE, give).unwrap();
        Self { bench, noise, read: ChaCha8Rng::seed_from_u64(seed) }
    }

    /// A machine that does not give, without errors, with wire that yields at so much of what the published one does: what is left of
    /// its springback is that of the wire itself.
    pub fn soft(share: f64) -> Self {
        let strength = |published: f64| published * share;
        let wire = Wire {
            yield_strength_mpa: strength(Wire::PUBLISHED.yield_strength_mpa),
            ultimate_strength_mpa: strength(Wire::PUBLISHED.ultimate_strength_mpa),
            ..Wire::PUBLISHED
        };
        let bench = Bench::new(Bender::PUBLISHED, wire, SCALE, Compliance::RIGID).unwrap();
        Self { bench, noise: Noise::default(), read: ChaCha8Rng::seed_from_u64(0) }
    }

    /// The published machine without errors.
    pub fn exact() -> Self {
        let mut shop = Self::new(1.0, 0);
        shop.noise.bend_deg.sigma = 0.0;
        shop
    }

    /// The wire that commands bend: feeds in mm, positions of the axis, turns of the head. No two wires have the same
    /// errors.
    pub fn bend(&mut self, steps: &[Step]) -> Made {
        let bench = self.bent(steps, &vec![None; steps.len()]);
        assert_eq!(bench.incidents(), []);
        bench.made()
    }

    /// The machine after it was told so. `approaches`: where the peg comes out where that is farther than for straight wire.
    pub fn bent(&mut self, steps: &[Step], approaches: &[Option<Angle>]) -> Bench {
        self.noise.seed += 1;
        let mut bench = self.bench.clone().with_noise(&self.noise).unwrap();
        let mut axis_at = 0;
        for (step, approach) in steps.iter().zip(approaches) {
            pulses(&mut bench, Axis::Feed, nearest(step.feed.mm() / SCALE.feed_mm_per_step));
            pulses(&mut bench, Axis::Rotate, nearest(step.rotate.deg() / SCALE.rotate_deg_per_step));
            let side = approach.map_or(step.bend.signum(), |at| -at.signum());
            if side == 0.0 {
                continue;
            }
            let mut go = |bench: &mut Bench, deg: f64| {
                let to = nearest(deg / SCALE.bend_deg_per_step);
                pulses(bench, Axis::Bend, to - axis_at);
                axis_at = to;
            };
            let clear = approach.map_or(CLEAR_DEG, |at| at.abs().deg().max(CLEAR_DEG));
            let clear = -clear * side;
            go(&mut bench, clear);
            bench.peg(Peg::Between);
            bench.peg(Peg::Out);
            go(&mut bench, step.bend.deg());
            go(&mut bench, clear);
            bench.peg(Peg::Between);
            bench.peg(Peg::In);
            go(&mut bench, 0.0);
        }
        bench
    }

    /// A reading that scatters by `sd`.
    pub fn read(&mut self, value: f64, sd: f64) -> f64 {
        let normal: f64 = StandardNormal.sample(&mut self.read);
        value + sd * normal
    }
}

fn pulses(bench: &mut Bench, axis: Axis, steps: i64) {
    (0..steps.abs()).for_each(|_| bench.step(axis, steps > 0));
}

fn nearest(steps: f64) -> i64 {
    #[expect(clippy::cast_possible_truncation, reason = "some ten thousand steps")]
    let steps = steps.round() as i64;
    steps
}

/// The distance of two corners of a wire, mm.
pub(crate) fn side(made: &Made, from: usize) -> f64 {
    let corners = made.corners();
    let squared = corners[from].iter().zip(&corners[from + 1]).map(|(a, b)| (a - b).powi(2));
    squared.sum::<f64>().sqrt()
}
