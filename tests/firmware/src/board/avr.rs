//! The binary of the board, seen by its pins alone.

#![allow(clippy::unwrap_used)] // a test may stop at what cannot be

use super::{Board, MS, Observation, Reset, What};
use crate::{PinChange, Port, Ram, ResetCause, Uno, firmware};

/// Step and direction pins of port D, by axis: those of `firmware/machines/wirebend-kit.h`.
const STEP: [u8; 3] = [2, 4, 3];
const DIRECTION: [u8; 3] = [5, 7, 6];
/// Pins of port B.
const MOTORS_OFF: u8 = 0;
const SWITCH: u8 = 2;
const PEG: u8 = 3;
/// Pins of port C.
const EMERGENCY: u8 = 0;
const HOLD: u8 = 1;
/// So much the width of a servo's pulse may differ from what was asked, µs.
const SERVO_TOLERANCE_US: u64 = 8;
/// How long it may run before its pins are looked at: less than the shortest interval of the bend axis, whose
/// switch has to follow it.
const LOOK_EVERY: u64 = MS;

pub struct Avr {
    pub uno: Uno,
    /// Cycles at which each step pulse and the servo's pulse began, and each direction was set.
    risen: [u64; 3],
    turned: [u64; 3],
    forward: [bool; 3],
    peg_risen: Option<u64>,
    servo_us: Option<u16>,
    /// Shortest time that a step pin was high, cycles.
    pub least_high: u64,
    /// And from a direction to the next pulse.
    pub least_setup: u64,
    /// Every pulse of the servo: its beginning and width, cycles.
    pub servo: Vec<(u64, u64)>,
}

impl Board for Avr {
    const NAME: &'static str = "avr";

    fn new() -> Self {
        Self {
            uno: Uno::new(&firmware("wirebend-kit")).unwrap(),
            risen: [0; 3],
            turned: [0; 3],
            forward: [false; 3],
            peg_risen: None,
            servo_us: None,
            least_high: u64::MAX,
            least_setup: u64::MAX,
            servo: Vec::new(),
        }
    }

    fn now(&self) -> u64 {
        self.uno.cycle()
    }

    fn send(&mut self, bytes: &[u8]) {
        self.uno.send(bytes);
    }

    fn run(&mut self, until: u64) -> Vec<Observation> {
        let mut seen = Vec::new();
        while seen.is_empty() && self.uno.cycle() < until {
            self.uno.run_until(until.min(self.uno.cycle() + LOOK_EVERY)).unwrap();
            for change in self.uno.pins() {
                seen.extend(self.changed(change).map(|what| Observation { at: change.cycle, what }));
            }
            seen.extend(
                self.uno.received().into_iter().map(|(at, byte)| Observation { at, what: What::Byte(byte) }),
            );
            seen.sort_by_key(|seen| seen.at);
        }
        seen
    }

    fn set_switch(&mut self, high: bool) {
        self.uno.set_input(Port::B, SWITCH, high).unwrap();
    }

    fn set_inputs(&mut self, hold_open: bool, emergency_open: bool) {
        self.uno.set_input(Port::C, HOLD, hold_open).unwrap();
        self.uno.set_input(Port::C, EMERGENCY, emergency_open).unwrap();
    }

    fn reset(&mut self, cause: Reset) {
        let cause = match cause {
            Reset::PowerOn => ResetCause::PowerOn,
            Reset::External => ResetCause::External,
            Reset::BrownOut => ResetCause::BrownOut,
            Reset::Watchdog => ResetCause::Watchdog,
        };
        let ram = if cause == ResetCause::PowerOn { Ram::Scrambled(self.now()) } else { Ram::Kept };
        self.uno.reset(cause, ram);
    }

    fn stored(&mut self) -> Vec<u8> {
        self.uno.eeprom().to_vec()
    }

    fn store(&mut self, bytes: &[u8]) {
        self.uno.set_eeprom(bytes).unwrap();
    }
}

impl Avr {
    fn changed(&mut self, change: PinChange) -> Option<What> {
        let PinChange { cycle, port, bit, level } = change;
        if port == Port::D {
            if let Some(axis) = STEP.iter().position(|&step| step == bit) {
                if !level {
                    self.least_high = self.least_high.min(cycle - self.risen[axis]);
                    return None;
                }
                self.risen[axis] = cycle;
                self.least_setup = self.least_setup.min(cycle - self.turned[axis]);
                return Some(What::Pulse { axis, forward: self.forward[axis] });
            }
            if let Some(axis) = DIRECTION.iter().position(|&direction| direction == bit) {
                self.turned[axis] = cycle;
                self.forward[axis] = level;
            }
            return None;
        }
        match bit {
            MOTORS_OFF => Some(What::Motors(!level)),
            PEG => self.peg_changed(cycle, level),
            _ => None,
        }
    }

    /// Reports a width when it is another than that of the pulse before.
    fn peg_changed(&mut self, cycle: u64, level: bool) -> Option<What> {
        if level {
            self.peg_risen = Some(cycle);
            return None;
        }
        let risen = self.peg_risen.take()?;
        self.servo.push((risen, cycle - risen));
        let told = u64::from(self.servo_us.unwrap_or_default());
        if (cycle - risen).abs_diff(told * MS / 1000) <= SERVO_TOLERANCE_US * MS / 1000 {
            return None;
        }
        // The settings of the peg are multiples of 100 µs in all tests.
        let width_us = (cycle - risen + 50 * MS / 1000) / (100 * MS / 1000) * 100;
        // A controller that hangs leaves its pin as it is until it is reset: that is no pulse.
        let width_us = u16::try_from(width_us).ok()?;
        self.servo_us = Some(width_us);
        Some(What::Servo { width_us })
    }
}
