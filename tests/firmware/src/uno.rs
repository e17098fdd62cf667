//! The controller: time, pins, serial line, resets.

use std::ffi::CString;
use std::os::unix::ffi::OsStrExt;
use std::path::Path;

use crate::chip::{InterruptTime, PinChange, Port};
use crate::error::UnoError;
use crate::ffi::{Controller, Ended, last_words};

/// Cycles a second.
pub const HZ: u64 = 16_000_000;

/// Cycles of a byte on the wire, both ways, at "115200 baud": start, eight bits and stop of 136 cycles. The chip's
/// divider gives 117647 baud, and the chip that is the Uno's USB port has the same divider.
pub const BYTE_CYCLES: u64 = 1360;

/// Seed of the noise in RAM at the first power-on.
const FIRST_SEED: u64 = 1;

/// Why the chip is reset, as MCUSR shows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ResetCause {
    /// PORF, which clears the flags of earlier resets.
    PowerOn,
    /// EXTRF: the reset button, or a port that is opened.
    External,
    /// BORF: the supply was too low for a moment.
    BrownOut,
    /// WDRF, without the time that the watchdog takes.
    Watchdog,
}

/// What a reset leaves in the RAM.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ram {
    /// All of it, as a short reset does.
    Kept,
    /// Noise of this seed, as after a time without power.
    Scrambled(u64),
}

/// Numbers of interrupts in the chip's table.
pub mod vector {
    /// Timer 2, compare match A.
    pub const TIMER2_COMPA: u8 = 7;
    /// Timer 2, overflow.
    pub const TIMER2_OVF: u8 = 9;
    /// Timer 1, compare match A.
    pub const TIMER1_COMPA: u8 = 11;
    /// Timer 0, compare match A.
    pub const TIMER0_COMPA: u8 = 14;
    /// A byte has been received.
    pub const USART_RX: u8 = 18;
    /// There is a place for a byte to send.
    pub const USART_UDRE: u8 = 19;
}

/// An `ATmega328P` at 16 MHz with a program in its flash.
pub struct Uno {
    pub(crate) controller: Controller,
    /// Cycle at which the wire to the controller is free again.
    wire_free: u64,
}

impl Uno {
    /// A controller with the program of an ELF file, its power just switched on: an empty EEPROM and noise in RAM.
    ///
    /// # Errors
    /// When the file is no program for an AVR.
    pub fn new(elf: &Path) -> Result<Self, UnoError> {
        let no_program = |why: String| UnoError::NoProgram { file: elf.to_owned(), why };
        let bytes = std::fs::read(elf).map_err(|why| no_program(why.to_string()))?;
        // The machine of an ELF file stands at byte 18, and 83 is the AVR; simavr itself ends the process on some
        // files that are something else.
        if !bytes.starts_with(b"\x7FELF") || bytes.get(18..20) != Some(&[83, 0]) {
            return Err(no_program("it is no ELF file of that machine".to_owned()));
        }
        let name = CString::new(elf.as_os_str().as_bytes()).map_err(|why| no_program(why.to_string()))?;
        let controller = Controller::new(&name).ok_or_else(|| no_program(last_words()))?;
        let mut uno = Self { controller, wire_free: 0 };
        uno.reset(ResetCause::PowerOn, Ram::Scrambled(FIRST_SEED));
        Ok(uno)
    }

    /// Cycles since the first power-on.
    #[must_use]
    pub fn cycle(&self) -> u64 {
        self.controller.cycle()
    }

    /// Runs until a cycle; it ends after the instruction that reaches it. In the past, it does nothing.
    ///
    /// # Errors
    /// When the program crashes or sleeps with interrupts off. A reset brings it back.
    pub fn run_until(&mut self, cycle: u64) -> Result<(), UnoError> {
        match self.controller.run_until(cycle) {
            Ended::Reached => Ok(()),
            Ended::Crashed => Err(UnoError::Crashed {
                cycle: self.cycle(),
                program_counter: self.controller.crashed_at(),
                said: last_words(),
            }),
            Ended::AsleepForEver => Err(UnoError::AsleepForEver { cycle: self.cycle() }),
        }
    }

    /// Runs for so many cycles.
    ///
    /// # Errors
    /// As [`Self::run_until`].
    pub fn run_for(&mut self, cycles: u64) -> Result<(), UnoError> {
        self.run_until(self.cycle().saturating_add(cycles))
    }

    /// Puts bytes on the wire to the controller, from now on or as soon as those before are over. The controller
    /// has a byte [`BYTE_CYCLES`] after its start.
    pub fn send(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.send_at(self.cycle(), byte);
        }
    }

    /// Puts a byte on the wire at a cycle, or as soon after it as the wire is free.
    pub fn send_at(&mut self, cycle: u64, byte: u8) {
        let end = self.occupy_wire(cycle);
        self.controller.receive(end, byte, false);
    }

    /// Puts a byte without a stop bit on the wire, as a wrong baud rate or a loose contact does: the controller
    /// sees a framing error with it.
    pub fn send_broken(&mut self, byte: u8) {
        let end = self.occupy_wire(self.cycle());
        self.controller.receive(end, byte, true);
    }

    fn occupy_wire(&mut self, cycle: u64) -> u64 {
        self.wire_free = cycle.max(self.wire_free).max(self.cycle()) + BYTE_CYCLES;
        self.wire_free
    }

    /// Bytes that are on their way to the controller.
    #[must_use]
    pub fn on_wire(&self) -> u64 {
        self.wire_free.saturating_sub(self.cycle()).div_ceil(BYTE_CYCLES)
    }

    /// What the controller has sent since the last call: the cycle at which each byte was over, and the byte.
    pub fn received(&mut self) -> Vec<(u64, u8)> {
        self.controller.take_sent()
    }

    /// Bytes that the controller lost because it did not read in time.
    #[must_use]
    pub fn overruns(&self) -> u64 {
        self.controller.overruns()
    }

    /// Bytes that the controller lost because it sent without waiting for a place.
    #[must_use]
    pub fn lost_sending(&self) -> u64 {
        self.controller.lost_sending()
    }

    /// Cycles that it has slept since the first power-on.
    #[must_use]
    pub fn asleep(&self) -> u64 {
        self.controller.asleep()
    }

    /// Every change of an output on ports B, C and D since the last call, in the order of time.
    pub fn pins(&mut self) -> Vec<PinChange> {
        self.controller.take_pins()
    }

    /// Drives an input from outside, from now on and through resets.
    ///
    /// # Errors
    /// When the port has no such bit.
    pub fn set_input(&mut self, port: Port, bit: u8, level: bool) -> Result<(), UnoError> {
        if bit > 7 {
            return Err(UnoError::NoBit { bit });
        }
        self.controller.set_input(port, bit, level);
        Ok(())
    }

    /// Resets the chip. The EEPROM is kept, the cycles continue; a byte on its way to the controller still arrives.
    pub fn reset(&mut self, cause: ResetCause, ram: Ram) {
        let flag = match cause {
            ResetCause::PowerOn => 1,
            ResetCause::External => 1 << 1,
            ResetCause::BrownOut => 1 << 2,
            ResetCause::Watchdog => 1 << 3,
        };
        self.controller.reset(flag, cause == ResetCause::PowerOn);
        if let Ram::Scrambled(seed) = ram {
            self.scramble(seed);
        }
    }

    /// How often the chip's own watchdog has reset it. Each shows as WDRF in MCUSR and keeps the RAM.
    #[must_use]
    pub fn watchdog_resets(&self) -> u64 {
        self.controller.watchdog_resets()
    }

    /// What each interrupt that ran has cost since the first power-on.
    #[must_use]
    pub fn interrupt_times(&self) -> Vec<InterruptTime> {
        let times = (1..=25).map(|vector| self.controller.interrupt_time(vector));
        times.filter(|time| time.count > 0).collect()
    }
}
