//! For tests: the firmware's own AVR binary on a simulated Arduino Uno, in virtual time or behind a terminal.
//!
//! [`Uno`] is an `ATmega328P` at 16 MHz. Time is counted in its cycles of 62.5 ns from power-on, through every
//! reset; the same inputs give the same outputs at the same cycles. [`OnPty`] lets it run in a thread with its
//! serial line on a pseudo-terminal, where a program opens it like a port. What the simulator does otherwise than
//! the chip, and what is done about it, is in this crate's README.
//!
//! The simulator, libsimavr, is under the GPL-3. This crate is for tests only and nothing that ships links it.

#![cfg(target_os = "linux")]

pub mod board;
mod built;
mod chip;
mod error;
mod fault;
mod ffi;
pub mod job;
pub mod lockstep;
mod memory;
mod pty;
pub mod table;
mod uno;

pub use built::{firmware, probe};
pub use chip::{InterruptTime, PinChange, Port};
pub use error::UnoError;
pub use pty::{Behind, OnPty, Options, Pace};
pub use uno::{BYTE_CYCLES, HZ, Ram, ResetCause, Uno, vector};
