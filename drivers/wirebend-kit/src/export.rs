//! WireBend-kit text: `F 30.000`, `R -90.000`, `B 45.000`, a command a line, R before its B.

use std::fmt::Write as _;

use wirebend_driver_api::{DriverError, EncodedFile, Job, Step};

/// Digits behind the decimal point: a tenth of a step or less.
const DECIMALS: usize = 3;

/// The program of one wire, with the hash of its design in the first line. Every feed is written; rotations and
/// bends that are zero in these digits are not.
pub(crate) fn wire(job: &Job, index: usize) -> Result<EncodedFile, DriverError> {
    let steps = job.wires[index].machine_steps(index)?;
    let mut text = String::new();
    let hash: String = job.design_hash.chars().filter(|c| !c.is_control()).collect();
    if !hash.is_empty() {
        let _ = writeln!(text, "# design {hash}");
    }
    for &Step { feed_mm, rotate_deg, bend_deg } in steps {
        let _ = writeln!(text, "F {}", fixed(feed_mm));
        for (letter, angle) in [("R", rotate_deg), ("B", bend_deg)] {
            let angle = fixed(angle);
            if angle.bytes().any(|byte| (b'1'..=b'9').contains(&byte)) {
                let _ = writeln!(text, "{letter} {angle}");
            }
        }
    }
    Ok(EncodedFile { text })
}

/// Without a minus in front of zero.
fn fixed(value: f64) -> String {
    let text = format!("{value:.DECIMALS$}");
    let is_zero = !text.bytes().any(|byte| (b'1'..=b'9').contains(&byte));
    if is_zero { text.trim_start_matches('-').to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_is_no_negative_zero() {
        assert_eq!([fixed(-0.0004), fixed(-0.000_500_1), fixed(30.0)], ["0.000", "-0.001", "30.000"]);
    }
}
