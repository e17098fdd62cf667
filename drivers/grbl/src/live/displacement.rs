//! Whether the axes stand where the lines that were sent end. grbl's lines carry no checksum: one of which a byte was
//! changed on its way is answered `ok` when it still makes sense.

use wirebend_driver_api::DriverError;

use crate::program::trimmed;
use crate::settings::Settings;

/// Where the axes stand at rest, as the machine reports it, with what the reports show of that. All in its units: feed,
/// rotation, bend.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ReportedPosition {
    pub at: [f64; 3],
    /// Steps for each unit, from `$100` on; nothing where the machine does not report them.
    pub steps: [Option<f64>; 3],
    /// The last digit of a report.
    pub digit: f64,
}

/// An axis that stands elsewhere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Displaced {
    axis: usize,
    at: f64,
    expected: f64,
}

/// The first axis that stands farther from where it should than can be distinguished. Both counted from where the program began;
/// `moves` lines have been sent since.
pub(super) fn displaced(
    began: &ReportedPosition,
    now: &ReportedPosition,
    expected: [f64; 3],
    moves: u32,
) -> Option<Displaced> {
    (0..3).find_map(|axis| {
        let at = now.at[axis] - began.at[axis];
        let farthest = began.at[axis].abs().max(now.at[axis].abs());
        let tolerance = tolerance(now.steps[axis], now.digit, farthest, moves);
        let expected = expected[axis];
        ((at - expected).abs() > tolerance).then_some(Displaced { axis, at, expected })
    })
}

impl ReportedPosition {
    /// What cannot be distinguished of each axis after so many moves, units of the machine.
    pub fn tolerance(&self, moves: u32) -> [f64; 3] {
        std::array::from_fn(|axis| tolerance(self.steps[axis], self.digit, self.at[axis].abs(), moves))
    }
}

/// How far a place that is reported may be from the one that was commanded, units of the machine. Both the place where the
/// program began and this one are up to half a step from where the controller counts, since it moves whole steps, and are
/// reported up to half a last digit off. It counts in single precision, of which each move, and each report, may take half
/// of the last bit.
fn tolerance(steps: Option<f64>, digit: f64, farthest: f64, moves: u32) -> f64 {
    // A machine that does not report its steps: a whole unit.
    let step = steps.filter(|steps| *steps > 0.0).map_or(1.0, |steps| 1.0 / steps);
    let bit = farthest * f64::from(f32::EPSILON);
    step + digit + bit * (f64::from(moves) + 4.0) / 2.0
}

impl Displaced {
    /// For a person, in mm and degrees.
    pub fn error(&self, during: &str, settings: &Settings) -> DriverError {
        let (axis, units, unit) = [
            ("feed", settings.feed_units_per_mm, " mm"),
            ("rotation", settings.rotate_units_per_deg, "\u{b0}"),
            ("bend axis", settings.bend_units_per_deg, "\u{b0}"),
        ][self.axis];
        let shown = |value: f64| trimmed(((value / units) * 1000.0).round() / 1000.0);
        DriverError::new(
            "displaced",
            format!(
                "{during} the {axis} stands at {}{unit}, and the lines that were sent end at {}{unit}, counted from where the \
                 wire began: a line was changed on its way to the machine",
                shown(self.at),
                shown(self.expected)
            ),
            "the wire is not as planned: see whether the USB cable is short, shielded, and away from motor cables, then begin \
             a new one",
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const fn standing(at: [f64; 3]) -> ReportedPosition {
        ReportedPosition { at, steps: [Some(250.0); 3], digit: 0.001 }
    }

    /// A difference of what steps and digits cannot show would end wires that are as planned.
    #[test]
    fn what_can_be_told_is_a_step_and_a_digit() {
        let began = standing([-199.0, -199.0, -1.0]);
        let axis =
            |at, expected| displaced(&began, &standing(at), expected, 10).map(|displaced| displaced.axis);
        // grbl feeds 36.113 mm for 9028 steps of 0.004 mm, which it reports as 36.112.
        assert_eq!(axis([-162.888, -199.0, -1.0], [36.113, 0.0, 0.0]), None);
        assert_eq!(axis([-162.888, -199.0, -1.0], [36.123, 0.0, 0.0]), Some(0));
        assert_eq!(axis([-199.0, -109.0, -1.0], [0.0, 90.0, 0.0]), None);
        assert_eq!(axis([-199.0, -199.0, -81.0], [0.0; 3]), Some(2));
    }

    /// Single precision has 24 bits: at 100 m its last is 0.008 mm, which a thousand moves may each have taken half of.
    #[test]
    fn far_away_less_can_be_told() {
        let far = standing([100_000.0, 0.0, 0.0]);
        let off = |by: f64| displaced(&standing([0.0; 3]), &far, [100_000.0 - by, 0.0, 0.0], 1000).is_some();
        assert!(!off(4.0) && off(9.0));
    }

    #[test]
    fn a_machine_that_does_not_tell_its_steps_is_compared_all_the_same() {
        let unknown = ReportedPosition { steps: [None; 3], ..standing([0.0; 3]) };
        assert_eq!(displaced(&unknown, &unknown, [0.9, 0.0, 0.0], 1), None);
        assert!(displaced(&unknown, &unknown, [0.0, -1.1, 0.0], 1).is_some());
    }
}
