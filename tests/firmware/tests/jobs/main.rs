//! A job from the program to the wire: `wirebend` and its driver as they are shipped, the firmware behind a port.

#![cfg(target_os = "linux")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a test may stop at what cannot be
#![allow(clippy::print_stdout)] // figures, for --nocapture

mod at_port;
mod bender;
mod cube;
mod head;
mod interrupted;
mod limits;
mod lost;
mod refused;
mod shop;
mod standing;
mod stop;
mod wrong;
