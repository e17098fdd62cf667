//! A step that was ended in its middle: how much of it is in the wire, and whether that is sure.

use std::ops::RangeInclusive;

use wirebend_driver_api::Step;

use super::entry::{EntryKind, ToldBy};

/// Closer than this an axis stands at an end of its way: more than a motor step, less than anybody sees on a wire.
const FEED_AT_MM: f64 = 0.05;
const ROTATE_AT_DEG: f64 = 0.3;
/// A person measures no better than this: what is so much more than a step has, or less than nothing, is all or nothing of it.
const MEASURED_MM: f64 = 1.0;
const MEASURED_DEG: f64 = 2.0;
/// A bend axis that stands farther past its bend than this has bent the wire too far.
const BENT_TOO_FAR_DEG: f64 = 2.0;

/// What is said of the first step in doubt.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StepOutcome {
    /// It is done.
    Made,
    /// Nothing of what was sent of it was done.
    NotMade,
    /// So much of it is in the wire.
    Part(Part),
}

/// How much of a step is in the wire, in the machine's signs. Its bend starts from the beginning in any case: bends count
/// from the zero of their axis.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Part {
    /// Fed, mm.
    pub feed_mm: f64,
    /// Turned, degrees.
    pub rotate_deg: f64,
}

/// How far the machine says that it is with what was sent of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PartMade {
    /// Fed and turned, and where the bend axis stands, in the machine's signs; nothing where it does not count that.
    pub made: Option<Step>,
    /// The axis that was on its way stands exactly there.
    pub exact: bool,
}

/// The first step in doubt, and what is known of it. All in the machine's signs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Doubtful {
    pub step: u32,
    pub last: u32,
    pub whole: Step,
    /// How much of it was in the wire before it was sent last.
    pub before: Part,
    /// How much of it is in the wire as the machine counts; nothing where it does not count that.
    pub counted: Option<Part>,
    /// The axis that was on its way when it was stopped may stand elsewhere than counted: a person has to measure.
    pub measure: bool,
}

impl Doubtful {
    /// Of the steps in doubt: the first of them, how much of it was in the wire before, and what the machine counts of it.
    pub(super) fn of(steps: RangeInclusive<u32>, whole: Step, before: Part, made: Option<PartMade>) -> Self {
        let rest = before.rest(whole);
        let told = made.and_then(|told| Some((told.made?, told.exact)));
        let counted = told.filter(|(made, _)| is_of(rest, *made)).map(|(made, exact)| {
            let part = Part {
                feed_mm: before.feed_mm + made.feed_mm,
                rotate_deg: before.rotate_deg + made.rotate_deg,
            };
            (part.within(whole), exact || is_at_rest(rest, made))
        });
        let measure = counted.is_some_and(|(_, sure)| !sure);
        let counted = counted.map(|(part, _)| part);
        Self { step: *steps.start(), last: *steps.end(), whole, before, counted, measure }
    }
}

/// More of a step than it has, or less than nothing of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Excess {
    /// Feed or rotation.
    pub what: &'static str,
    pub part: f64,
    pub whole: f64,
    pub unit: &'static str,
}

impl Part {
    /// Whether a step cannot have this part, within what a person measures.
    pub(super) fn excess(self, step: Step) -> Option<Excess> {
        [
            ("feed", self.feed_mm, step.feed_mm, " mm", MEASURED_MM),
            ("rotation", self.rotate_deg, step.rotate_deg, "\u{b0}", MEASURED_DEG),
        ]
        .into_iter()
        .find(|&(_, part, whole, _, at)| !is_between(part, whole, at))
        .map(|(what, part, whole, unit, _)| Excess { what, part, whole, unit })
    }

    /// What is left of a step.
    #[must_use]
    pub fn rest(self, step: Step) -> Step {
        Step { feed_mm: step.feed_mm - self.feed_mm, rotate_deg: step.rotate_deg - self.rotate_deg, ..step }
    }

    /// Whether it is the same as far as a person can measure.
    #[must_use]
    pub fn is_measured_as(self, other: Self) -> bool {
        (self.feed_mm - other.feed_mm).abs() < MEASURED_MM
            && (self.rotate_deg - other.rotate_deg).abs() < MEASURED_DEG
    }

    /// No more than all of a step, and no less than nothing.
    pub(super) fn within(self, whole: Step) -> Self {
        let within = |part: f64, whole: f64| part.clamp(whole.min(0.0), whole.max(0.0));
        Self {
            feed_mm: within(self.feed_mm, whole.feed_mm),
            rotate_deg: within(self.rotate_deg, whole.rotate_deg),
        }
    }

    /// The entry of a journal.
    pub(super) const fn told_by(self, n: u32, by: ToldBy) -> EntryKind {
        EntryKind::Part { n, feed_mm: self.feed_mm, rotate_deg: self.rotate_deg, by }
    }
}

/// Whether an axis stands between the ends of its way.
fn is_between(part: f64, whole: f64, at: f64) -> bool {
    part >= whole.min(0.0) - at && part <= whole.max(0.0) + at
}

/// Whether a machine that runs this can stand there. No step corrects a wire that is bent too far.
fn is_of(step: Step, made: Step) -> bool {
    let side = step.approach_deg.map_or(step.bend_deg.signum(), |comes_out| -comes_out.signum());
    // With its peg in the axis returns to zero, also where the bend was before it.
    let most = (side * step.bend_deg).max(0.0);
    is_between(made.feed_mm, step.feed_mm, FEED_AT_MM)
        && is_between(made.rotate_deg, step.rotate_deg, ROTATE_AT_DEG)
        && side * made.bend_deg <= most + BENT_TOO_FAR_DEG
}

/// Whether feed and head stood when the step was ended: each has not begun or is done. Where the bend axis stands
/// does not matter, since its bend starts again.
fn is_at_rest(step: Step, made: Step) -> bool {
    let at_an_end = |made: f64, whole: f64, at: f64| made.abs() < at || (made - whole).abs() < at;
    at_an_end(made.feed_mm, step.feed_mm, FEED_AT_MM)
        && at_an_end(made.rotate_deg, step.rotate_deg, ROTATE_AT_DEG)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A step of which nothing but the bend is left.
    fn bend(bend_deg: f64, approach_deg: Option<f64>) -> Step {
        Step { bend_deg, approach_deg, ..Step::default() }
    }

    #[test]
    fn a_machine_stands_within_its_bend_to_the_side_to_which_it_bends() {
        for (step, stands, too_far) in [
            (bend(40.0, None), [-18.0, 0.0, 41.0], 43.0),
            (bend(-40.0, Some(26.0)), [26.0, 0.0, -41.0], -43.0),
            // To the positive side, at zero or before it: with its peg in the axis returns to zero.
            (bend(-5.0, Some(-18.25)), [-18.25, -5.0, 0.0], 3.0),
            (bend(0.0, Some(18.25)), [18.25, 0.0, -1.0], -3.0),
        ] {
            assert!(stands.iter().all(|at| is_of(step, bend(*at, None))), "{step:?}");
            assert!(!is_of(step, bend(too_far, None)), "{step:?}");
        }
    }
}
