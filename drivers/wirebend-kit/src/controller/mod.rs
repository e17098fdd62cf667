//! The simulated controller: the firmware's own core, with a clock that only moves when it is told to.

mod ffi;

use wirebend_driver_api::Axis;

use crate::protocol::Reset;
use ffi::Host;

/// Cycles of the controller's clock in a second.
pub const HZ: u64 = 16_000_000;
/// A byte on the line at 115200 baud, in cycles.
pub const BYTE_CYCLES: u64 = 1360;

/// Something that can be seen from outside.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Seen {
    /// When, in cycles from the first power on.
    pub at: u64,
    /// What.
    pub what: Sight,
}

/// What can be seen of a controller.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sight {
    /// A pulse on a step pin, and the level of its direction pin.
    Pulse {
        /// The axis.
        axis: Axis,
        /// Whether its direction pin is high.
        forward: bool,
    },
    /// The servo of the peg gets pulses of this width, µs.
    Peg {
        /// The width, µs.
        width_us: u16,
    },
    /// A byte on the line to the host.
    Sent(u8),
    /// The motor drivers were turned on.
    MotorsOn,
    /// The motor drivers were turned off.
    MotorsOff,
}

/// A controller.
#[derive(Debug)]
pub struct Controller {
    host: Host,
    now: u64,
    /// Bytes on their way to it, with the time of their arrival and whether they come damaged.
    line: std::collections::VecDeque<(u64, u8, bool)>,
}

impl Controller {
    /// A new board with nothing stored, and power on. `None` when there is no memory for it.
    #[must_use]
    pub fn new() -> Option<Self> {
        let mut controller = Self { host: Host::new()?, now: 0, line: std::collections::VecDeque::new() };
        controller.reset(Reset::PowerOn);
        Some(controller)
    }

    /// Starts again; what is stored stays.
    pub fn reset(&mut self, cause: Reset) {
        self.line.clear();
        self.host.reset(cause as u8);
    }

    /// Counts the time from now on.
    pub fn restart_clock(&mut self) {
        self.line.clear();
        self.host.restart_clock();
        self.now = 0;
    }

    /// The time, in cycles from the first power on.
    #[must_use]
    pub const fn now(&self) -> u64 {
        self.now
    }

    /// Sends bytes to it, one after the other, after those that are on their way.
    pub fn send(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            let free = self.line.back().map_or(self.now, |&(at, ..)| at).max(self.now);
            self.line.push_back((free + BYTE_CYCLES, byte, false));
        }
    }

    /// Bytes that have all come before its main loop looks at any of them, as when it is busy.
    pub fn send_unseen(&mut self, bytes: &[u8]) {
        self.host.receive_all(bytes);
    }

    /// The level of the pin of its switch from now on: high when pressed.
    pub fn set_switch(&mut self, high: bool) {
        self.host.switch(high);
    }

    /// The contacts of its inputs from now on: whether that of the hold and that of the emergency stop is open.
    pub fn set_inputs(&mut self, hold_open: bool, emergency_open: bool) {
        self.host.inputs(u8::from(hold_open) | u8::from(emergency_open) << 1);
    }

    /// Lets time pass until `until`, or until something can be seen.
    pub fn run(&mut self, until: u64) -> Option<Seen> {
        loop {
            if let Some(event) = self.host.next() {
                if let Some(what) = sight(event) {
                    return Some(Seen { at: event.at, what });
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
                return self.host.next().and_then(|event| Some(Seen { at: event.at, what: sight(event)? }));
            }
        }
    }

    /// Power fails when so many more bytes are stored: the others are lost, until the next reset.
    pub fn fail_after(&mut self, bytes: u32) {
        self.host.fail_after(bytes);
    }

    /// The bytes that outlive power.
    pub fn stored(&mut self) -> &mut [u8] {
        self.host.stored()
    }
}

fn sight(event: ffi::RawEvent) -> Option<Sight> {
    let axis = match event.value {
        0 => Axis::Feed,
        1 => Axis::Rotate,
        _ => Axis::Bend,
    };
    Some(match event.kind {
        0 => Sight::Pulse { axis, forward: event.on != 0 },
        1 => Sight::Peg { width_us: event.value },
        2 => Sight::Sent(u8::try_from(event.value).ok()?),
        _ if event.on != 0 => Sight::MotorsOn,
        _ => Sight::MotorsOff,
    })
}
