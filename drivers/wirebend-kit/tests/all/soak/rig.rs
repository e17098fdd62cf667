//! The link and the controller in one virtual time, with a noisy line between them.

use std::time::Duration;

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use wirebend_driver_api::Axis;
use wirebend_driver_wirebend_kit::controller::{Controller, HZ, Observation, Observed};
use wirebend_driver_wirebend_kit::link::{Link, MachineEvent};

/// How long a slice of time is: what a computer's serial port delivers at once.
const SLICE: Duration = Duration::from_millis(1);

/// What happens to bytes on their way: so many of a thousand are flipped, dropped or joined by another.
pub struct Noise {
    random: ChaCha8Rng,
    share: f64,
}

impl Noise {
    pub fn new(seed: u64, percent: f64) -> Self {
        Self { random: ChaCha8Rng::seed_from_u64(seed), share: percent / 100.0 }
    }

    fn pass(&mut self, bytes: Vec<u8>) -> Vec<u8> {
        let mut out = Vec::with_capacity(bytes.len());
        for byte in bytes {
            if !self.random.random_bool(self.share) {
                out.push(byte);
                continue;
            }
            match self.random.random_range(0..3) {
                0 => out.push(byte ^ 1 << self.random.random_range(0..8)),
                1 => {}
                _ => out.extend([byte, self.random.random()]),
            }
        }
        out
    }
}

/// A machine on a table, its line, and the link.
pub struct Rig {
    pub controller: Controller,
    pub link: Link,
    noise: Noise,
    now: Duration,
    /// Pulses since the power came on, by axis.
    pub counted: [i64; 3],
    /// Where the bend axis really stands, steps from zero.
    bend: i64,
    pub pegs: Vec<u16>,
    pub events: Vec<MachineEvent>,
}

/// The edge of the switch of the shipped settings.
const SWITCH: i64 = -9547;

impl Rig {
    pub fn new(session: u16, noise: Noise) -> Self {
        let mut controller = Controller::new().unwrap();
        controller.set_switch(false);
        let link = Link::new(session, None, Duration::from_millis(500), Duration::ZERO);
        Self {
            controller,
            link,
            noise,
            now: Duration::ZERO,
            counted: [0; 3],
            bend: -3000,
            pegs: Vec::new(),
            events: Vec::new(),
        }
    }

    fn cycles(time: Duration) -> u64 {
        u64::try_from(time.as_nanos()).unwrap() * (HZ / 1_000_000) / 1000
    }

    fn saw(&mut self, seen: Observation, sent: &mut Vec<u8>) {
        match seen.what {
            Observed::Pulse { axis, forward } => {
                let way = if forward { 1 } else { -1 };
                let index = match axis {
                    Axis::Feed => 0,
                    Axis::Rotate => 1,
                    Axis::Bend => 2,
                };
                self.counted[index] += way;
                if axis == Axis::Bend {
                    self.bend += way;
                    self.controller.set_switch(self.bend <= SWITCH);
                }
            }
            Observed::Peg { width_us } => self.pegs.push(width_us),
            Observed::Sent(byte) => sent.push(byte),
            Observed::MotorsOn | Observed::MotorsOff => {}
        }
    }

    /// One slice of time.
    pub fn slice(&mut self) {
        let out = self.link.take_bytes();
        let out = self.noise.pass(out);
        self.controller.send(&out);
        self.now += SLICE;
        let until = Self::cycles(self.now);
        let mut sent = Vec::new();
        while let Some(seen) = self.controller.run(until) {
            self.saw(seen, &mut sent);
        }
        let heard = self.noise.pass(sent);
        self.link.advance(&heard, self.now);
        self.events.extend(self.link.take_events());
    }

    /// Time in which the program does not look at the line, such as while a person reads a question.
    pub fn away(&mut self, time: Duration) {
        self.now += time;
        let until = Self::cycles(self.now);
        let mut unread = Vec::new();
        while let Some(seen) = self.controller.run(until) {
            self.saw(seen, &mut unread);
        }
        self.link.advance(&unread, self.now);
        self.events.extend(self.link.take_events());
    }

    /// Until something is known, for so long at most.
    pub fn until(&mut self, max: Duration, mut done: impl FnMut(&[MachineEvent]) -> bool) -> bool {
        let end = self.now + max;
        while !done(&self.events) {
            if self.now >= end {
                return false;
            }
            self.slice();
        }
        true
    }
}
