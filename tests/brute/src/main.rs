//! `wirebend-brute DESIGN.wirebend SEQUENCE.json`: what is wrong with a sequence, as `wirebend sequence --json` prints it, of a design in
//! ABS of 1.5 mm with FrameFab's extruder. For tests that are not in Rust. Ends with 1 where anything is wrong.

use std::io::Write;
use std::process::ExitCode;

use serde_json::Value;
use wirebend_tests_brute::{Step, Task};

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().collect();
    let [_, design, sequence] = arguments.as_slice() else {
        return Err("expected a design and a sequence".into());
    };
    let read = |file: &String| -> Result<Value, Box<dyn std::error::Error>> {
        Ok(serde_json::from_slice(&std::fs::read(file)?)?)
    };
    let steps = Step::printed(&read(sequence)?);
    let faults = Task::framefab(&read(design)?).faults(&steps);
    let mut out = std::io::stdout().lock();
    for fault in &faults {
        writeln!(out, "{fault:?}")?;
    }
    writeln!(out, "{} steps, {} faults", steps.len(), faults.len())?;
    Ok(ExitCode::from(u8::from(!faults.is_empty())))
}
