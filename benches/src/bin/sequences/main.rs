//! How long it takes to find in which order a frame is built, what that is made of, how joints are closed, and what a frame of 6427 struts
//! takes. Every sequence is confirmed by brute force. Usage: `sequences PEER-PYTHON`.

#![allow(clippy::print_stdout, reason = "its output is the table")]
#![allow(clippy::unwrap_used, clippy::panic)] // a benchmark may stop at what cannot be

#[path = "../../../../crates/core/tests/all/sequence/brute.rs"]
mod brute;
mod closings;
#[path = "../../../../crates/core/tests/all/sequence/frames.rs"]
#[allow(dead_code)] // the tests of the sequence use the rest
mod frames;
mod large;
#[path = "../frames/models.rs"]
#[allow(dead_code)] // the benchmark of frames uses the rest
mod models;
#[path = "../frames/peer.rs"]
#[allow(dead_code)] // the benchmark of frames uses the rest
mod peer;
mod prefixes;
mod searching;
#[path = "../../../../crates/core/tests/all/accuracy/truss.rs"]
#[allow(dead_code)] // the tests of accuracy use the rest
mod truss;

use anyhow::{Context, Result};

fn main() -> Result<()> {
    let mut arguments = std::env::args().skip(1);
    let python = arguments.next().context("name the peers' Python")?;
    if python == large::CHILD {
        return large::part(&arguments.next().context("name the part")?);
    }
    searching::measure()?;
    println!();
    prefixes::measure(&python)?;
    println!();
    closings::measure()?;
    println!();
    large::measure()
}
