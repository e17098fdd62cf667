//! The core on this computer.

#![allow(clippy::unwrap_used)] // a test may stop at what cannot be

use wirebend_driver_api::Axis;
use wirebend_driver_wirebend_kit::controller::{Controller, Sight};

use super::{BEND, Board, Reset, Seen, What};

/// The core, started anew.
pub struct Host(Controller);

impl Host {
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

    fn run(&mut self, until: u64) -> Vec<Seen> {
        let seen = self.0.run(until);
        seen.map(|seen| Seen { at: seen.at, what: what(seen.what) }).into_iter().collect()
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

fn what(sight: Sight) -> What {
    match sight {
        Sight::Pulse { axis, forward } => {
            let axis = match axis {
                Axis::Feed => 0,
                Axis::Rotate => 1,
                Axis::Bend => BEND,
            };
            What::Pulse { axis, forward }
        }
        Sight::Peg { width_us } => What::Servo { width_us },
        Sight::Sent(byte) => What::Byte(byte),
        Sight::MotorsOn => What::Motors(true),
        Sight::MotorsOff => What::Motors(false),
    }
}
