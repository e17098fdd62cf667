//! From the machine's steps to the lines of a script.

use std::fmt::Write as _;

use wirebend_driver_api::{DriverError, Step, fixed, is_zero};

use crate::rounding::Rounding;
use crate::settings::{Comments, Settings};

/// Pin out of the way, and back at the wire: the heights that published programs give.
const PIN_DOWN: &str = "-5";
const PIN_UP: &str = "0";

/// Writes a wire. Every feed is written; rotations and bends that are written as zero are left out, and so
/// is a rotation at the end, which turns nothing.
pub(crate) fn write(
    wire: usize,
    steps: &[Step],
    design_hash: &str,
    settings: &Settings,
    rounding: &mut Rounding,
) -> Result<String, DriverError> {
    if steps.is_empty() {
        let message = format!("wire {} has no steps, expected one at least", wire + 1);
        return Err(DriverError::new("empty-wire", message, "plan the design again"));
    }
    let mut script = Script { settings, text: String::new(), pin: None };
    if settings.comments == Comments::Parentheses {
        script.comment(&format!("design {design_hash}"));
    }
    for (n, step) in steps.iter().enumerate() {
        for (what, value) in [("feed", step.feed_mm), ("rotate", step.rotate_deg), ("bend", step.bend_deg)] {
            if !value.is_finite() {
                let message =
                    format!("wire {}, step {}: {what} is {value}, expected a number", wire + 1, n + 1);
                return Err(DriverError::new("not-a-number", message, "plan the design again"));
            }
        }
        let [feed, rotate, bend] =
            [step.feed_mm, step.rotate_deg, step.bend_deg].map(|value| fixed(value, settings.decimals));
        let (turns, bends) = (!is_zero(&rotate), !is_zero(&bend));
        rounding.feed(step.feed_mm, &feed);
        rounding.angle(step.bend_deg, &bend);
        script.pin(PIN_DOWN);
        script.command("FEED", &feed);
        if turns && (bends || n + 1 < steps.len()) {
            script.command("ROTATE", &rotate);
        }
        if n + 1 < steps.len() || bends {
            rounding.angle(step.rotate_deg, &rotate);
        }
        if bends {
            script.pin(PIN_UP);
            script.command("BEND", &bend);
        }
    }
    Ok(script.text)
}

/// Whether no feed follows the last bend.
pub(crate) fn ends_on_bend(script: &str) -> bool {
    script.lines().last().is_some_and(|line| line.to_ascii_uppercase().starts_with("BEND"))
}

struct Script<'a> {
    settings: &'a Settings,
    text: String,
    /// Where the script has put the pin; unknown at the start.
    pin: Option<&'static str>,
}

impl Script<'_> {
    fn command(&mut self, command: &str, value: &str) {
        let _ = writeln!(self.text, "{} {value}", self.settings.case.spell(command));
    }

    /// Moves the pin where a person wants that and it is not there yet.
    fn pin(&mut self, height: &'static str) {
        if self.settings.pin_between && self.pin != Some(height) {
            self.command("PINZ", height);
            self.pin = Some(height);
        }
    }

    /// A comment of one line: what would end it early is replaced.
    fn comment(&mut self, text: &str) {
        let text = text.replace('(', "[").replace(')', "]").replace(|c: char| c.is_control(), " ");
        let _ = writeln!(self.text, "({text})");
    }
}
