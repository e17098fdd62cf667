//! From the job's steps to whole millimetres and degrees. What rounding takes from a feed or a rotation is given
//! to the next, so that neither is ever off by more than half a unit in all; what it takes from a bend is given
//! to the next in the same plane.

use wirebend_driver_api::{DriverError, Step};

use crate::command::Command;

/// What arithmetic may leave of a feed of zero, mm.
const NOTHING_MM: f64 = 1e-6;
/// A bend below this is none, degrees: the noise of computing with floats.
const NO_BEND_DEG: f64 = 1e-9;
/// More wire than any coil has, mm.
pub(crate) const MAX_FEED_MM: f64 = 1e6;
/// The sketch counts 16 steps a degree in 16 bits: 32767 / 16.
pub(crate) const MAX_ANGLE_DEG: f64 = 2047.0;

/// The three axes with what they still owe.
#[derive(Debug, Clone, Default)]
pub(crate) struct Axes {
    pub feed: Axis,
    pub rotate: Axis,
    pub bend: Bends,
}

/// What rounding did to an axis.
#[derive(Debug, Clone, Default)]
pub(crate) struct Axis {
    /// What was asked for and not written yet: between minus a half and a half.
    pub carry: f64,
    /// The largest difference between a step and what was written for it.
    pub max_error: f64,
    /// How many steps were written as something else than they are.
    pub changed: usize,
}

impl Axis {
    /// The whole number for a value that is no larger than the limits above.
    #[allow(clippy::cast_possible_truncation)] // the limits are far inside i32
    fn next(&mut self, value: f64) -> i32 {
        let exact = value + self.carry;
        // Halves go to the even side: what is left over is a half at most, and so a step of zero stays zero
        // and a feed never turns back.
        let whole = exact.round_ties_even();
        self.carry = exact - whole;
        let error = (value - whole).abs();
        // What the last bits of a float do is no change that a person has to hear of.
        self.changed += usize::from(error > NOTHING_MM);
        self.max_error = self.max_error.max(error);
        whole as i32
    }
}

/// The bend axis, which rotations turn. Bends in one plane add up, so there the error of one is given to the
/// next; out of the plane it would only make the next bend worse.
#[derive(Debug, Clone, Default)]
pub(crate) struct Bends {
    /// Its carry is about the axis of the last bend.
    axis: Axis,
    /// How far the axis was turned since the last bend, as written, degrees: below a whole turn.
    turned: i32,
    /// The most that the bends of a plane lacked together when another plane began.
    left_behind: f64,
}

impl Bends {
    /// `rotated` is what was written for the rotation before this bend.
    fn next(&mut self, rotated: i32, bend_deg: f64) -> i32 {
        self.turned = (self.turned + rotated) % 360;
        if bend_deg.abs() < NO_BEND_DEG {
            return 0;
        }
        match self.turned {
            0 => {}
            // The axis points the other way: a bend below zero continues the same way round.
            180 | -180 => self.axis.carry = -self.axis.carry,
            _ => {
                self.left_behind = self.together();
                self.axis.carry = 0.0;
            }
        }
        self.turned = 0;
        self.axis.next(bend_deg)
    }

    /// What rounding did to each bend.
    pub const fn each(&self) -> &Axis {
        &self.axis
    }

    /// The most that the bends of a plane lack together, degrees.
    pub fn together(&self) -> f64 {
        self.left_behind.max(self.axis.carry.abs())
    }
}

impl Axes {
    /// The commands of a step: feed, rotate, bend, each only where it is not zero. A feed above
    /// `most_feed_mm` becomes several. `place` names the step in a refusal, after which nothing has changed.
    pub fn commands(
        &mut self,
        step: &Step,
        place: &str,
        most_feed_mm: i32,
    ) -> Result<Vec<Command>, DriverError> {
        check(step, place)?;
        let mut feed = self.feed.next(step.feed_mm.max(0.0));
        let mut commands = Vec::new();
        while feed > 0 {
            let part = feed.min(most_feed_mm);
            commands.push(Command::Feed(part));
            feed -= part;
        }
        let rotate = self.rotate.next(step.rotate_deg);
        let bend = self.bend.next(rotate, step.bend_deg);
        if rotate != 0 {
            commands.push(Command::Rotate(rotate));
        }
        if bend != 0 {
            commands.push(Command::Bend(bend));
        }
        Ok(commands)
    }
}

fn check(step: &Step, place: &str) -> Result<(), DriverError> {
    let Step { feed_mm, rotate_deg, bend_deg, .. } = *step;
    let axes = [
        ("feed", "mm", feed_mm, MAX_FEED_MM),
        ("rotate", "degrees", rotate_deg, MAX_ANGLE_DEG),
        ("bend", "degrees", bend_deg, MAX_ANGLE_DEG),
    ];
    for (name, unit, value, max) in axes {
        if !value.is_finite() || value.abs() > max {
            let message =
                format!("{place}: {name} is {value} {unit}; this machine counts up to {max} {unit}");
            return Err(DriverError::new("too-large", message, "divide the design, or look at its scale"));
        }
    }
    if feed_mm < -NOTHING_MM {
        let message = format!("{place}: feed is {feed_mm} mm; on this machine a feed below zero never ends");
        let help = "make the straight part before this step longer, or its bends smaller";
        return Err(DriverError::new("negative-feed", message, help));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn commands(axes: &mut Axes, step: (f64, f64, f64)) -> String {
        let step = Step { feed_mm: step.0, rotate_deg: step.1, bend_deg: step.2, approach_deg: None };
        let commands = axes.commands(&step, "step 1", 682).unwrap();
        commands.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
    }

    /// 0.4 is nothing, 0.8 is one with 0.2 too much, and then 0.2 are left. The bends are in one plane.
    #[test]
    fn what_rounds_to_zero_is_made_later() {
        let mut axes = Axes::default();
        let made = [(); 3].map(|()| commands(&mut axes, (0.4, 0.0, 0.4)));
        assert_eq!(made, ["", "f1 b1", ""]);
        let twisted = [(); 3].map(|()| commands(&mut axes, (0.0, -0.4, 0.0)));
        assert_eq!(twisted, ["", "z-1", ""]);
        let left = [axes.feed.carry - 0.2, axes.rotate.carry + 0.2, axes.bend.together() - 0.2];
        assert!(left.iter().all(|error| error.abs() < 1e-9), "{axes:?}");
    }

    /// After 1.5 mm as 2 there is half a millimetre too much; a feed of -1 to correct it would never end.
    #[test]
    fn a_step_of_zero_stays_zero() {
        let mut axes = Axes::default();
        let made = [(1.5, 0.5, -1.5), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)].map(|step| commands(&mut axes, step));
        assert_eq!(made, ["f2 b-2", "", ""]);
    }

    /// What the wire turns by is what the bends of its plane add up to, worked out beside each row.
    #[test]
    fn bends_in_one_plane_make_up_for_each_other_and_others_do_not() {
        let made = |steps: &[(f64, f64)]| {
            let mut axes = Axes::default();
            let words = |&(rotate, bend): &(f64, f64)| commands(&mut axes, (0.0, rotate, bend));
            steps.iter().map(words).collect::<Vec<_>>().join(", ")
        };
        for (steps, expected) in [
            // 45.4 + 45.6 = 91: after half a turn a bend below zero continues the same way round.
            (&[(0.0, 45.4), (180.0, -45.6)] as &[_], "b45, z180 b-46"),
            (&[(0.0, 45.4), (-180.0, -45.6)], "b45, z-180 b-46"),
            // 45.4 - 45.4 = 0: a bend above zero takes the first one back.
            (&[(0.0, 45.4), (180.0, 45.4)], "b45, z180 b45"),
            // 45.4 + 45.4 = 90.8: a whole turn is none.
            (&[(0.0, 45.4), (360.0, 45.4)], "b45, z360 b46"),
            // In two parts, and by what is written: 179.6 is 180.
            (&[(0.0, 45.4), (90.0, 0.0), (90.0, -45.6)], "b45, z90, z90 b-46"),
            (&[(0.0, 45.4), (179.6, -45.6)], "b45, z180 b-46"),
            // Other planes: each the nearest number, also in a plane that the wire has been in before.
            (&[(0.0, 45.4), (90.0, 45.4)], "b45, z90 b45"),
            (&[(0.0, 45.4), (90.0, 45.4), (-90.0, 45.4)], "b45, z90 b45, z-90 b45"),
            // A bend that is too small to be written is added to the next of its plane, and lost otherwise.
            (&[(0.0, 0.4), (180.0, -0.4)], ", z180 b-1"),
            (&[(0.0, 0.4), (90.0, 0.4)], ", z90"),
        ] {
            assert_eq!(made(steps), expected, "{steps:?}");
        }
    }

    /// 32767 / 48 = 682.6: a longer feed runs over in the sketch's 16 bits and never ends.
    #[test]
    fn a_long_feed_is_divided() {
        assert_eq!(commands(&mut Axes::default(), (1500.0, 0.0, 0.0)), "f682 f682 f136");
        assert_eq!(commands(&mut Axes::default(), (682.0, 0.0, 0.0)), "f682");
    }

    #[test]
    fn what_the_machine_cannot_do_is_refused_and_changes_nothing() {
        let mut axes = Axes::default();
        commands(&mut axes, (0.4, 0.4, 0.4));
        let before = format!("{axes:?}");
        for (step, code) in [
            ((-0.1, 0.0, 0.0), "negative-feed"),
            ((2e6, 0.0, 0.0), "too-large"),
            ((1.0, -2048.0, 0.0), "too-large"),
            ((1.0, 0.0, f64::NAN), "too-large"),
        ] {
            let step = Step { feed_mm: step.0, rotate_deg: step.1, bend_deg: step.2, approach_deg: None };
            let error = axes.commands(&step, "wire 1, step 2", 682).unwrap_err();
            assert_eq!(error.code, code);
            assert!(error.message.starts_with("wire 1, step 2: "), "{error}");
        }
        assert_eq!(format!("{axes:?}"), before);
        // What is left of zero by arithmetic is no feed backwards.
        assert_eq!(commands(&mut Axes::default(), (-1e-12, 90.0, 0.0)), "z90");
    }
}
