//! What is known of the first step in doubt, and what a person says of it.

use wirebend_driver_api::Step;

use super::super::entry::{EntryKind, ToldBy};
use super::super::error::JobError;
use super::super::journal_state::JournalState;
use super::super::part::{Doubtful, Excess, Part, StepOutcome};
use super::super::resume::Resume;
use super::JobRun;

impl JobRun {
    /// The first step in doubt.
    #[must_use]
    pub fn doubtful(&self) -> Option<Doubtful> {
        self.doubtful_in(self.journal_state())
    }

    fn doubtful_in(&self, state: &JournalState) -> Option<Doubtful> {
        let steps = state.in_doubt()?;
        let whole = self.step(*steps.start())?;
        Some(Doubtful::of(steps, whole, state.part, state.part_made))
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
        let StepOutcome::Part(told) = outcome else { return Ok(()) };
        match told.excess(self.step(n).unwrap_or_default()) {
            Some(Excess { what, part, whole, unit }) => {
                Err(JobError::NotOfStep { step: n, what, part, whole, unit })
            }
            None => Ok(()),
        }
    }

    /// A step of the wire, from 1, whole.
    fn step(&self, n: u32) -> Option<Step> {
        let index = usize::try_from(n).ok()?.checked_sub(1)?;
        self.work.steps.get(index).copied()
    }

    /// What is to be sent of a step.
    pub(super) fn to_send(&self, n: u32, step: Step) -> Step {
        let state: &JournalState = self.journal_state();
        let rest = if n == state.done + 1 { state.part.rest(step) } else { step };
        Step { rotate_deg: rest.rotate_deg + self.turns_more_in(n), ..rest }
    }
}
