//! A controller that does what it should, one pulse after the other.

use std::sync::LazyLock;

use wirebend_driver_api::Axis;
use wirebend_driver_wirebend_kit::bench::{Bench, Bender, Compliance, Peg, Scale, Wire};

/// The published resolutions: 37.3 mm wheel with 6400 steps, belt 18/7, gearbox 26.85 with 4 microsteps.
pub const SCALE: Scale =
    Scale { feed_mm_per_step: 0.0184, rotate_deg_per_step: 0.02188, bend_deg_per_step: 0.01676 };

/// Where the peg comes out: the straight wire is touched at 13.25 degrees.
const CLEAR_DEG: f64 = 20.0;

/// The published bender and wire, on a machine that gives as it does.
pub fn published() -> Bench {
    static BENCH: LazyLock<Bench> = LazyLock::new(|| on(Compliance::published().unwrap()));
    BENCH.clone()
}

pub fn on(compliance: Compliance) -> Bench {
    Bench::new(Bender::PUBLISHED, Wire::PUBLISHED, SCALE, compliance).unwrap()
}

/// Knows where its axes should be, so that roundings do not add up.
pub struct Hand {
    pub bench: Bench,
    scale: Scale,
    /// Steps done by each axis.
    fed: i64,
    turned: i64,
    bent: i64,
    feed_mm: f64,
    head_deg: f64,
}

impl Hand {
    pub fn new(bench: Bench) -> Self {
        Self { bench, scale: SCALE, fed: 0, turned: 0, bent: 0, feed_mm: 0.0, head_deg: 0.0 }
    }

    pub fn feed(&mut self, mm: f64) -> &mut Self {
        self.feed_mm += mm;
        let target = nearest(self.feed_mm / self.scale.feed_mm_per_step);
        pulses(&mut self.bench, Axis::Feed, target - self.fed);
        self.fed = target;
        self
    }

    pub fn rotate(&mut self, deg: f64) -> &mut Self {
        self.head_deg += deg;
        let target = nearest(self.head_deg / self.scale.rotate_deg_per_step);
        pulses(&mut self.bench, Axis::Rotate, target - self.turned);
        self.turned = target;
        self
    }

    pub fn axis_to(&mut self, deg: f64) -> &mut Self {
        let target = nearest(deg / self.scale.bend_deg_per_step);
        pulses(&mut self.bench, Axis::Bend, target - self.bent);
        self.bent = target;
        self
    }

    pub fn peg(&mut self, peg: Peg) -> &mut Self {
        self.bench.peg(peg);
        self
    }

    /// Takes the bend axis out to a place and back, the way a bend is done.
    pub fn press(&mut self, axis_deg: f64) -> &mut Self {
        let clear = -CLEAR_DEG * axis_deg.signum();
        self.axis_to(clear).peg(Peg::Between).peg(Peg::Out);
        self.axis_to(axis_deg).axis_to(clear);
        self.peg(Peg::Between).peg(Peg::In).axis_to(0.0)
    }
}

pub fn pulses(bench: &mut Bench, axis: Axis, steps: i64) {
    for _ in 0..steps.abs() {
        bench.step(axis, steps > 0);
    }
}

fn nearest(steps: f64) -> i64 {
    #[expect(clippy::cast_possible_truncation, reason = "some ten thousand steps")]
    let steps = steps.round() as i64;
    steps
}
