//! The integration tests of this crate, one binary for all.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a test may stop at what cannot be

mod awake;
mod console;
mod isolation;
mod jobs;
mod killed;
mod permission;
mod permits;
mod refused;
mod sessions;
mod stop_line;
mod trust;
