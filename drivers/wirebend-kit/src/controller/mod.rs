//! The simulated controller: the firmware's core with a virtual clock.

mod ffi;

use wirebend_driver_api::Axis;

use crate::protocol::Reset;
use ffi::Host;

/// Clock of the controller, cycles per second.
pub const HZ: u64 = 16_000_000;
/// Time of a byte at 115200 baud, cycles.
pub const BYTE_CYCLES: u64 = 1360;

/// An event that can be observed from outside.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Observation {
    /// Cycles since the first power-on.
    pub at: u64,
    pub what: Observed,
}

/// What can be observed of a controller.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Observed {
    Pulse {
        /// Axis of the step pin.
        axis: Axis,
        /// Whether its direction pin is high.
        forward: bool,
    },
    /// The servo of the peg gets another position.
    Peg {
        /// Pulse width of the servo, µs.
        width_us: u16,
    },
    /// A byte to the host.
    Sent(u8),
    /// The motor drivers are turned on.
    MotorsOn,
    /// The motor drivers are turned off.
    MotorsOff,
}

/// A simulated board.
#[derive(Debug)]
pub struct Controller {
    host: Host,
    now: u64,
    /// Bytes on their way to it: time of arrival in cycles, byte, whether it is damaged.
    line: std::collections::VecDeque<(u64, u8, bool)>,
}

impl Controller {
    /// A new board with an empty EEPROM, just powered on. `None` when memory has run out.
    #[must_use]
    pub fn new() -> Option<Self> {
        let mut controller = Self { host: Host::new()?, now: 0, line: std::collections::VecDeque::new() };
        controller.reset(Reset::PowerOn);
        Some(controller)
    }

    /// Resets it. The EEPROM stays.
    pub fn reset(&mut self, cause: Reset) {
        self.line.clear();
        self.host.reset(cause as u8);
    }

    /// Restarts the clock at zero.
    pub fn restart_clock(&mut self) {
        self.line.clear();
        self.host.restart_clock();
        self.now = 0;
    }

    /// Cycles since the first power-on.
    #[must_use]
    pub const fn now(&self) -> u64 {
        self.now
    }

    /// Sends bytes to it, after those that are on their way.
    pub fn send(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            let free = self.line.back().map_or(self.now, |&(at, ..)| at).max(self.now);
            self.line.push_back((free + BYTE_CYCLES, byte, false));
        }
    }

    /// Delivers bytes all at once, as if its main loop had been busy.
    pub fn send_unseen(&mut self, bytes: &[u8]) {
        self.host.receive_all(bytes);
    }

    /// Keeps its main loop busy for so many cycles, as a write of the EEPROM does: interrupts alone run.
    pub fn keep_busy(&mut self, cycles: u64) {
        self.host.busy(self.now + cycles);
    }

    /// Sets the level of its switch's pin: high when pressed.
    pub fn set_switch(&mut self, high: bool) {
        self.host.switch(high);
    }

    /// Opens and closes the contacts of the hold input and of the emergency stop.
    pub fn set_inputs(&mut self, hold_open: bool, emergency_open: bool) {
        self.host.inputs(u8::from(hold_open) | u8::from(emergency_open) << 1);
    }

    /// Runs until `until`, in cycles, or until something can be observed.
    pub fn run(&mut self, until: u64) -> Option<Observation> {
        loop {
            if let Some(event) = self.host.next() {
                if let Some(what) = observed(event) {
                    return Some(Observation { at: event.at, what });
                }
                continue;
            }
            let arrival = self.line.front().map_or(u64::MAX, |&(at, ..)| at);
            self.now = self.host.run(until.min(arrival));
            if self.now == arrival
                && let Some((_, byte, damaged)) = self.line.pop_front()
            {
                self.host.receive(byte, damaged);
            } else if self.now >= until {
                return self
                    .host
                    .next()
                    .and_then(|event| Some(Observation { at: event.at, what: observed(event)? }));
            }
        }
    }

    /// Lets the power fail after so many more stored bytes: later ones are lost, until the next reset.
    pub fn fail_after(&mut self, bytes: u32) {
        self.host.fail_after(bytes);
    }

    pub fn stored(&mut self) -> &mut [u8] {
        self.host.stored()
    }
}

fn observed(event: ffi::RawEvent) -> Option<Observed> {
    let axis = match event.value {
        0 => Axis::Feed,
        1 => Axis::Rotate,
        _ => Axis::Bend,
    };
    Some(match event.kind {
        0 => Observed::Pulse { axis, forward: event.on != 0 },
        1 => Observed::Peg { width_us: event.value },
        2 => Observed::Sent(u8::try_from(event.value).ok()?),
        _ if event.on != 0 => Observed::MotorsOn,
        _ => Observed::MotorsOff,
    })
}
