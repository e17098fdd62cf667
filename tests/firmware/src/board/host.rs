//! The core on this computer.

#![allow(clippy::unwrap_used)] // a test may stop at what cannot be

use wirebend_driver_api::Axis;
use wirebend_driver_wirebend_kit::controller::{Controller, Observed};

use super::{BEND, Board, Observation, Reset, What};

/// The core, started anew.
pub struct Host(Controller);

impl Host {
    /// Its main loop does nothing for so long, as while it writes its EEPROM.
    pub fn keep_busy(&mut self, cycles: u64) {
        self.0.keep_busy(cycles);
    }

    /// Power fails when so many more bytes are stored, until the next reset.
    pub fn fail_after(&mut self, bytes: u32) {
        self.0.fail_after(bytes);
    }
}

impl Board for Host {
    const NAME: &'static str = "host";

    fn new() -> Self {
        Self(Controller::new().unwrap())
    }

    fn now(&self) -> u64 {
        self.0.now()
    }

    fn send(&mut self, bytes: &[u8]) {
        self.0.send(bytes);
    }

    fn run(&mut self, until: u64) -> Vec<Observation> {
        let seen = self.0.run(until);
        seen.map(|seen| Observation { at: seen.at, what: what(seen.what) }).into_iter().collect()
    }

    fn set_switch(&mut self, high: bool) {
        self.0.set_switch(high);
    }

    fn set_inputs(&mut self, hold_open: bool, emergency_open: bool) {
        self.0.set_inputs(hold_open, emergency_open);
    }

    fn reset(&mut self, cause: Reset) {
        self.0.reset(cause);
    }

    fn stored(&mut self) -> Vec<u8> {
        self.0.stored().to_vec()
    }

    fn store(&mut self, bytes: &[u8]) {
        self.0.stored()[..bytes.len()].copy_from_slice(bytes);
    }
}

fn what(sight: Observed) -> What {
    match sight {
        Observed::Pulse { axis, forward } => {
            let axis = match axis {
                Axis::Feed => 0,
                Axis::Rotate => 1,
                Axis::Bend => BEND,
            };
            What::Pulse { axis, forward }
        }
        Observed::Peg { width_us } => What::Servo { width_us },
        Observed::Sent(byte) => What::Byte(byte),
        Observed::MotorsOn => What::Motors(true),
        Observed::MotorsOff => What::Motors(false),
    }
}
