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
    let (mut feeds, mut turns) = (Sum::default(), Sum::default());
    for (step, told) in steps.iter().enumerate() {
        let &Step { feed_mm, rotate_deg, bend_deg, .. } = told;
        if told.ends_before_zero() {
            return Err(no_side(index, step, bend_deg));
        }
        let _ = writeln!(text, "F {}", feeds.next(feed_mm));
        for (letter, angle) in [("R", turns.next(rotate_deg)), ("B", fixed(bend_deg, DECIMALS))] {
            if !is_zero(&angle) {
                let _ = writeln!(text, "{letter} {angle}");
            }
        }
    }
    Ok(EncodedFile { text })
}

/// Numbers that add up, each written so that the sum of those before is right to half of the last digit: rounded alone, 110 turns of
/// 360/110 degrees would be more than a whole one. Bends do not add up: each is a place of the axis.
#[derive(Default)]
struct Sum {
    /// What is not written yet of those before.
    left: f64,
}

impl Sum {
    fn next(&mut self, value: f64) -> String {
        let alone = fixed(value, DECIMALS);
        let exact = value + self.left;
        // What is nothing by itself gets no line for what others have left.
        if is_zero(&alone) {
            self.left = exact;
            return alone;
        }
        let text = fixed(exact, DECIMALS);
        self.left = exact - text.parse::<f64>().unwrap_or(exact);
        text
    }
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

#[cfg(test)]
mod tests {
    use super::{DECIMALS, Sum};

    /// The firmware and the program refuse a head that has turned by more than its limit.
    #[test]
    fn turns_add_up_to_what_they_are_together() {
        let (mut turns, mut sum) = (Sum::default(), 0.0);
        for k in 1..=110 {
            sum += turns.next(360.0 / 110.0).parse::<f64>().unwrap();
            let meant = 360.0 / 110.0 * f64::from(k);
            assert!((sum - meant).abs() < 0.5005 * 10.0_f64.powi(-i32::from(DECIMALS)), "{sum} of {meant}");
        }
        assert!((sum - 360.0).abs() < 1e-9, "{sum}");
        assert_eq!([1e-9, -0.0, 0.0].map(|none| turns.next(none)), ["0.000", "0.000", "0.000"]);
    }
}
