//! A machine that stays connected, as a window has it: on the simulated machine of the kit, on one that misbehaves, and
//! on boards at a terminal.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a test may stop at what cannot be
#![cfg(unix)] // the driver that misbehaves is

#[cfg(target_os = "linux")]
#[path = "../../../cli/tests/command_line/machine/bender.rs"]
#[allow(dead_code)] // the command line's tests use the rest
mod bender;
#[cfg(target_os = "linux")]
#[path = "../../../cli/tests/command_line/machine/board.rs"]
#[allow(dead_code)] // the command line's tests use the rest
mod board;
#[cfg(target_os = "linux")]
mod boards;
#[cfg(target_os = "linux")]
mod console;
mod cutting;
mod faults;
#[cfg(target_os = "linux")]
#[path = "../../../../drivers/grbl/tests/all/pty/model/mod.rs"]
#[allow(dead_code)] // the driver's own tests use the rest
mod grbl_model;
mod hand;
mod pauses;
mod sequence;
mod shop;
mod stops;
#[cfg(target_os = "linux")]
mod under_way;
mod wires;
#[cfg(target_os = "linux")]
mod zeroed;
