//! A step that was ended in its middle: how much of it is in the wire, and whether that is sure.

use wirebend_driver_api::Step;

use super::error::JobError;
use super::journal::{EntryKind, ToldBy};
use super::journal_state::{JournalState, Part};
use super::resume::Resume;
use super::run::JobRun;

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

impl JobRun {
    /// The first step in doubt.
    #[must_use]
    pub fn doubtful(&self) -> Option<Doubtful> {
        self.doubtful_in(self.journal_state())
    }

    fn doubtful_in(&self, state: &JournalState) -> Option<Doubtful> {
        let (step, last) = state.in_doubt().map(|steps| (*steps.start(), *steps.end()))?;
        let whole = self.step(step)?;
        let before = state.part;
        let told = state.part_made.and_then(|told| Some((told.made?, told.exact)));
        let rest = before.rest(whole);
        let counted = told.filter(|(made, _)| is_of(rest, *made)).map(|(made, exact)| {
            let part = Part {
                feed_mm: before.feed_mm + made.feed_mm,
                rotate_deg: before.rotate_deg + made.rotate_deg,
            };
            (part.within(whole), exact || is_at_rest(rest, made))
        });
        let measure = counted.is_some_and(|(_, sure)| !sure);
        Some(Doubtful { step, last, whole, before, counted: counted.map(|(part, _)| part), measure })
    }

    /// How much of the first step in doubt is in the wire, where the machine counts that and nobody has to look.
    pub(super) fn sure_part(&self) -> Option<(u32, Part)> {
        let doubtful = self.doubtful()?;
        Some((doubtful.step, doubtful.counted.filter(|_| !doubtful.measure)?))
    }

    /// Writes down what is said of the first step in doubt, and gives what may be done then.
    ///
    /// # Errors
    /// [`JobError::NotInDoubt`] for another step, [`JobError::NotOfStep`] for more than the step has,
    /// [`JobError::AtWork`] while the machine may still run it.
    pub fn decide(&mut self, n: u32, outcome: StepOutcome) -> Result<Resume, JobError> {
        self.may_decide(n, outcome)?;
        let what = match outcome {
            StepOutcome::Made => EntryKind::Decided { n, made: true },
            StepOutcome::NotMade => EntryKind::Decided { n, made: false },
            StepOutcome::Part(part) => {
                part.within(self.step(n).unwrap_or_default()).told_by(n, ToldBy::Person)
            }
        };
        self.note(what)?;
        Ok(self.resume_from())
    }

    /// What a person has said of steps since the machine was stopped, in order; nothing was bent since.
    pub fn said(&self) -> impl Iterator<Item = (u32, StepOutcome)> {
        self.journal_state().said.iter().map(|said| (said.step, said.outcome))
    }

    /// How much of a step the machine counted, of which a person has said something since.
    #[must_use]
    pub fn counted_before(&self, n: u32) -> Option<Part> {
        self.doubtful_in(&self.journal_state().before(n)?)?.counted
    }

    /// A person takes back what they have said of a step: it, and those after it, are in doubt again. Gives what may be
    /// done then.
    ///
    /// # Errors
    /// [`JobError::NotInDoubt`] where nothing was said of it, or something was bent since.
    pub fn take_back(&mut self, n: u32) -> Result<Resume, JobError> {
        if self.is_in_hand() || self.journal_state().before(n).is_none() {
            let in_doubt = self.journal_state().in_doubt().map(|steps| *steps.start());
            return Err(JobError::NotInDoubt { step: n, in_doubt });
        }
        self.note(EntryKind::TakenBack { n })?;
        Ok(self.resume_from())
    }

    /// Whether something can be said of a step.
    ///
    /// # Errors
    /// As [`JobRun::decide`]; nothing is written down.
    pub fn may_decide(&self, n: u32, outcome: StepOutcome) -> Result<(), JobError> {
        if self.is_in_hand() {
            return Err(JobError::AtWork);
        }
        let in_doubt = self.journal_state().in_doubt().map(|steps| *steps.start());
        if in_doubt != Some(n) {
            return Err(JobError::NotInDoubt { step: n, in_doubt });
        }
        let StepOutcome::Part(Part { feed_mm, rotate_deg }) = outcome else { return Ok(()) };
        let whole = self.step(n).unwrap_or_default();
        for (what, part, whole, unit, at) in [
            ("feed", feed_mm, whole.feed_mm, " mm", MEASURED_MM),
            ("rotation", rotate_deg, whole.rotate_deg, "\u{b0}", MEASURED_DEG),
        ] {
            if !is_between(part, whole, at) {
                return Err(JobError::NotOfStep { step: n, what, part, whole, unit });
            }
        }
        Ok(())
    }

    /// A step of the wire, from 1, whole.
    fn step(&self, n: u32) -> Option<Step> {
        let index = usize::try_from(n).ok()?.checked_sub(1)?;
        self.work.steps.get(index).copied()
    }

    /// What is to be sent of a step.
    pub(super) fn to_send(&self, n: u32, step: Step) -> Step {
        let state: &JournalState = self.journal_state();
        if n == state.done + 1 { state.part.rest(step) } else { step }
    }
}

impl Part {
    /// Whether it is the same as far as a person can measure.
    #[must_use]
    pub fn is_measured_as(self, other: Self) -> bool {
        (self.feed_mm - other.feed_mm).abs() < MEASURED_MM
            && (self.rotate_deg - other.rotate_deg).abs() < MEASURED_DEG
    }

    /// No more than all of a step, and no less than nothing.
    fn within(self, whole: Step) -> Self {
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
    let past = if step.bend_deg < 0.0 { -made.bend_deg } else { made.bend_deg };
    is_between(made.feed_mm, step.feed_mm, FEED_AT_MM)
        && is_between(made.rotate_deg, step.rotate_deg, ROTATE_AT_DEG)
        && past <= step.bend_deg.abs() + BENT_TOO_FAR_DEG
}

/// Whether feed and head stood when the step was ended: each has not begun or is done. Where the bend axis stands
/// does not matter, since its bend starts again.
fn is_at_rest(step: Step, made: Step) -> bool {
    let at_an_end = |made: f64, whole: f64, at: f64| made.abs() < at || (made - whole).abs() < at;
    at_an_end(made.feed_mm, step.feed_mm, FEED_AT_MM)
        && at_an_end(made.rotate_deg, step.rotate_deg, ROTATE_AT_DEG)
}
