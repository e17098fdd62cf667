//! A bender behind a port: a controller, its bend axis with the switch, wire in the nozzle, and a note of every
//! pulse.

mod changed;
mod moment;
mod pulses;

use std::time::{Duration, Instant};

use wirebend_driver_api::Axis;
use wirebend_driver_wirebend_kit::bench::{Bench, Bender as Head, Compliance, Made, Peg, Scale, Wire};
use wirebend_driver_wirebend_kit::protocol::STOP;
use wirebend_tests_firmware::{BYTE_CYCLES, Behind, UnoError};

use changed::{Change, Changed};
use moment::Watch;
pub use moment::{Moment, Phase};
pub use pulses::{Pulse, Pulses, lines, net, ways};
use wirebend_tests_firmware::board::{Board, Reset, What};

/// Where the bend axis stands when the power comes on, degrees: anywhere, but not at zero.
const BEND_AT_DEG: i32 = -30;
/// The edge of its switch, degrees: that of the profile.
const SWITCH_DEG: i32 = -160;
/// How far the axis itself can go: to the switch and a little on.
const AXIS_LIMIT_DEG: f64 = 162.0;
/// How far the head's cable lets it turn either way: that of the profile.
const HEAD_LIMIT_DEG: f64 = 360.0;
/// Width of the servo's pulse with the peg out, µs: that of the profile.
const PEG_OUT_US: u16 = 2000;

/// The longest that the interrupt of a step takes, cycles, as measured.
const STEP_INTERRUPT: u64 = 1265;

/// Steps of the motors, as the machine is built.
#[derive(Debug, Clone, Copy)]
pub struct Gears {
    pub feed_steps_per_mm: f64,
    pub rotate_steps_per_turn: u32,
    pub bend_steps_per_turn: u32,
}

impl Gears {
    /// The published machine.
    pub const PUBLISHED: Self =
        Self { feed_steps_per_mm: 54.44, rotate_steps_per_turn: 16457, bend_steps_per_turn: 21480 };

    fn scale(self) -> Scale {
        Scale {
            feed_mm_per_step: 1.0 / self.feed_steps_per_mm,
            rotate_deg_per_step: 360.0 / f64::from(self.rotate_steps_per_turn),
            bend_deg_per_step: 360.0 / f64::from(self.bend_steps_per_turn),
        }
    }
}

/// A STOP that came.
#[derive(Debug, Clone, Copy)]
pub struct Stop {
    /// When its byte was read from the port.
    pub came: Instant,
    /// The cycle at which the controller has it.
    pub at: u64,
}

pub struct Bender<B> {
    pub board: B,
    /// Where the bend axis really stands, and the edge of its switch, steps.
    bend: i64,
    switch_at: i64,
    /// The wire of the switch is broken, which reads as pressed.
    broken: bool,
    bench: Bench,
    pub pulses: Pulses,
    pub stops: Vec<Stop>,
    sent: Vec<u8>,
    /// Bytes to the controller that come before this moment are lost on the line.
    deaf_until: Option<Instant>,
    /// Lines to the controller that are heard otherwise.
    changed: Option<Changed>,
    /// Cycle at which the wire to the controller is free again.
    wire_free: u64,
    /// The last cycle at which the servo was commanded.
    servo_at: u64,
    watches: Vec<Watch<B>>,
}

impl<B: Board> Bender<B> {
    /// A machine whose power was just switched on, with wire up to its nozzle. `stored`: what outlives power.
    pub fn new(gears: Gears, stored: Option<&[u8]>) -> Self {
        let scale = gears.scale();
        let head = Head { axis_limit_deg: AXIS_LIMIT_DEG, ..Head::PUBLISHED };
        let bench = Bench::new(head, Wire::PUBLISHED, scale, Compliance::published().unwrap()).unwrap();
        let bench = bench.with_head_limit(HEAD_LIMIT_DEG).unwrap();
        let steps = |deg: i64| (2 * deg * i64::from(gears.bend_steps_per_turn) + 360).div_euclid(720); // the nearest
        let mut bender = Self {
            board: B::new(),
            bend: steps(BEND_AT_DEG.into()),
            switch_at: steps(SWITCH_DEG.into()),
            broken: false,
            bench: bench.with_bend_axis_at(BEND_AT_DEG.into()).unwrap(),
            pulses: Pulses::default(),
            stops: Vec::new(),
            sent: Vec::new(),
            deaf_until: None,
            changed: None,
            wire_free: 0,
            servo_at: 0,
            watches: Vec::new(),
        };
        bender.move_switch();
        if let Some(stored) = stored {
            bender.board.store(stored);
            bender.board.reset(Reset::PowerOn);
        }
        bender
    }

    /// Power goes and comes, or the reset pin is touched.
    pub fn reset(&mut self, cause: Reset) {
        self.sent.clear();
        self.board.reset(cause);
    }

    /// The wire that came out.
    pub fn made(&self) -> Made {
        self.bench.clone().made()
    }

    /// What should never have happened.
    pub fn incidents(&self) -> Vec<String> {
        self.bench.incidents().iter().map(ToString::to_string).collect()
    }

    /// The first STOP, and how many pulses came after it. A step whose interrupt has begun when the byte is over is done.
    pub fn stopped(&self) -> (Stop, usize) {
        let stop = *self.stops.first().expect("a STOP");
        let after = |pulse: &&Pulse| pulse.at > stop.at + STEP_INTERRUPT;
        (stop, self.pulses.all().iter().filter(after).count())
    }

    /// Time since anything has moved, in cycles.
    pub fn still_for(&self) -> u64 {
        self.board.now() - self.pulses.last().map_or(0, |pulse| pulse.at).max(self.servo_at)
    }

    /// Whatever the host sends from here on is lost, for a time.
    pub fn deafen(&mut self, time: Duration) {
        self.deaf_until = Instant::now().checked_add(time);
    }

    /// Whatever the host sends from here on is heard as this says.
    pub fn hears(&mut self, change: Change) {
        self.changed = Some(Changed::new(change));
    }

    /// Breaks the wire of the switch.
    pub fn break_switch(&mut self) {
        self.broken = true;
        self.move_switch();
    }

    fn move_switch(&mut self) {
        self.board.set_switch(self.broken || self.bend <= self.switch_at);
    }

    fn pulsed(&mut self, at: u64, axis: usize, forward: bool) {
        let axis = [Axis::Feed, Axis::Rotate, Axis::Bend][axis];
        if axis == Axis::Bend {
            self.bend += if forward { 1 } else { -1 };
            self.move_switch();
        }
        self.bench.step(axis, forward);
        self.pulses.push(Pulse { at, axis, forward });
        self.look();
    }

    fn servo(&mut self, at: u64, width_us: u16) {
        self.servo_at = at;
        self.bench.peg(if width_us == PEG_OUT_US { Peg::Out } else { Peg::In });
    }
}

impl<B: Board + Send + 'static> Behind for Bender<B> {
    fn cycle(&self) -> u64 {
        self.board.now()
    }

    fn run_for(&mut self, cycles: u64) -> Result<(), UnoError> {
        let until = self.board.now() + cycles;
        loop {
            let seen = self.board.run(until);
            if seen.is_empty() && self.board.now() >= until {
                break;
            }
            for seen in seen {
                match seen.what {
                    What::Pulse { axis, forward } => self.pulsed(seen.at, axis, forward),
                    What::Servo { width_us } => self.servo(seen.at, width_us),
                    What::Byte(byte) => self.sent.push(byte),
                    What::Motors(_) => {}
                }
            }
        }
        self.look();
        Ok(())
    }

    fn send(&mut self, bytes: &[u8]) {
        if self.deaf_until.is_some_and(|until| Instant::now() < until) {
            return;
        }
        let heard = self.changed.as_mut().map_or_else(|| bytes.to_vec(), |changed| changed.pass(bytes));
        for &byte in &heard {
            self.wire_free = self.wire_free.max(self.board.now()) + BYTE_CYCLES;
            if byte == STOP {
                self.stops.push(Stop { came: Instant::now(), at: self.wire_free });
            }
        }
        self.board.send(&heard);
    }

    fn on_wire(&self) -> u64 {
        self.wire_free.saturating_sub(self.board.now()).div_ceil(BYTE_CYCLES)
    }

    fn take_sent(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.sent)
    }

    fn reset_by_port(&mut self) {
        self.reset(Reset::External);
    }
}
