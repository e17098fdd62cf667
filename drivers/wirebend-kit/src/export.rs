//! WireBend-kit text: `F 30.000`, `R -90.000`, `B 45.000`, a command a line, R before its B.

use std::fmt::Write as _;

use wirebend_driver_api::{DriverError, EncodedFile, Job, Note, Step, fixed, is_zero};

/// Digits behind the decimal point: a tenth of a step or less.
const DECIMALS: u8 = 3;

/// The program of one wire, with the hash of its design in the first line. Every feed is written; rotations and
/// bends that are zero in these digits are not.
pub(crate) fn wire(job: &Job, index: usize) -> Result<EncodedFile, DriverError> {
    let steps = job.wires[index].machine_steps(index)?;
    let mut text = String::new();
    let hash: String = job.design_hash.chars().filter(|c| !c.is_control()).collect();
    if !hash.is_empty() {
        let _ = writeln!(text, "# design {hash}");
    }
    for (step, told) in steps.iter().enumerate() {
        let &Step { feed_mm, rotate_deg, bend_deg, .. } = told;
        if told.ends_before_zero() {
            return Err(no_side(index, step, bend_deg));
        }
        let _ = writeln!(text, "F {}", fixed(feed_mm, DECIMALS));
        for (letter, angle) in [("R", rotate_deg), ("B", bend_deg)] {
            let angle = fixed(angle, DECIMALS);
            if !is_zero(&angle) {
                let _ = writeln!(text, "{letter} {angle}");
            }
        }
    }
    Ok(EncodedFile { text })
}

/// The peg comes out farther from the wire than it does by itself where that is bent already; a line has no place for it.
pub(crate) fn approaches_left_out(job: &Job) -> Result<Option<Note>, DriverError> {
    let mut count = 0;
    for (index, wire) in job.wires.iter().enumerate() {
        let steps = wire.machine_steps(index)?;
        count += steps.iter().filter(|step| step.approach_deg.is_some()).count();
    }
    let bends = if count == 1 { "1 bend needs".to_owned() } else { format!("{count} bends need") };
    Ok((count > 0).then(|| Note {
        code: "approach-not-carried".to_owned(),
        count,
        message: format!(
            "{bends} the peg to come out farther from the wire than it does by itself, and WireBend-kit text cannot say so: the peg \
             may hit wire that was bent before; run the job itself, which has it"
        ),
    }))
}

/// The format is that of the machine's authors: a line has one angle, and its sign is the side.
fn no_side(wire: usize, step: usize, bend_deg: f64) -> DriverError {
    DriverError::new(
        "no-side",
        format!(
            "wire {}, step {}: the bend axis stops before zero, at {bend_deg:.2}°, and WireBend-kit text has no place for the side of a \
             bend",
            wire + 1,
            step + 1
        ),
        "run the job itself, which has it; or enlarge the bend",
    )
}
