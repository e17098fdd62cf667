//! The whole bunny on both controllers, which takes minutes: `make firmware-soak`.

#![cfg(target_os = "linux")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // it may stop at what cannot be
#![allow(clippy::print_stdout)] // figures
#![allow(dead_code)] // shared with the tests, which use all of it

#[path = "../tests/controller/board/mod.rs"]
mod board;
#[path = "../tests/controller/job.rs"]
mod job;
#[path = "../tests/controller/lockstep.rs"]
mod lockstep;
#[path = "../tests/controller/table.rs"]
mod table;

fn main() {
    lockstep::in_lockstep("bunny", &lockstep::lines(include_str!("../tests/controller/steps/bunny.csv")));
}
