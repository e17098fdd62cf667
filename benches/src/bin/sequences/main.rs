//! How long it takes to find in which order a frame is built, what that is made of, how joints are closed, and what a frame of 6427 struts
//! takes. Every sequence is confirmed by brute force. Usage: `sequences PEER-PYTHON`.

#![allow(clippy::print_stdout, reason = "its output is the table")]
mod closings;
mod large;
mod prefixes;
mod searching;

use anyhow::{Result, bail};

fn main() -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match &arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [large::PART, part] => large::part(part),
        [python] => {
            searching::measure()?;
            println!();
            prefixes::measure(python)?;
            println!();
            closings::measure()?;
            println!();
            large::measure()
        }
        _ => bail!("name the peers' Python"),
    }
}
