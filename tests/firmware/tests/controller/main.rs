//! The firmware, by what it does on its pins and its serial line: the binary of the board on a simulated Uno, and
//! the same core on this computer.

#![cfg(target_os = "linux")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a test may stop at what cannot be
#![allow(clippy::print_stdout)] // figures, for --nocapture

mod backing_off;
mod boot;
mod builds;
mod clone;
mod core;
mod figures;
mod frames;
mod homing;
mod inputs;
mod jobs;
mod kept;
mod limits;
mod lines;
mod pulses;
mod release;
mod session;
mod settings;
mod stop;
mod talk;
mod watch;
