//! A step in doubt: what is known of it, and what a person says.

use wirebend_core::units::Mm;
use wirebend_driver_host::jobs::{JobRun, Part, StepOutcome};

use super::making::Making;
use super::task::Task;
use crate::{Decided, Decision, Doubt, LiveProblem, OperationError};
use wirebend_planning::report::SHOWN_AS_ZERO;

impl Task<'_> {
    /// The user looks whether a step was done, or how much of it.
    pub(super) fn decide(
        &self,
        making: &mut Making,
        step: u32,
        last: u32,
        decided: Option<Decided>,
    ) -> Result<(), OperationError> {
        if let Some(said) = decided.filter(|said| said.step != step) {
            return Err(self.not_in_doubt(making, said).into());
        }
        let doubt = self.doubt(making, step, last)?;
        let said = decided.map(|decided| decided.what).or_else(|| self.progress.decide(&doubt));
        let outcome = match said {
            Some(Decision::Made) => StepOutcome::Made,
            Some(Decision::NotMade) => StepOutcome::NotMade,
            Some(Decision::Part(part)) => StepOutcome::Part(self.told_part(part)),
            Some(Decision::AsCounted) => {
                let counted = doubt.counted.ok_or(LiveProblem::NotCounted { step })?;
                StepOutcome::Part(self.told_part(counted))
            }
            None => {
                let run = self.target(making.wire);
                return Err(LiveProblem::InDoubt { doubt: Box::new(doubt), run }.into());
            }
        };
        making.run.decide(step, outcome).map_err(LiveProblem::from)?;
        Ok(())
    }

    fn doubt(&self, making: &Making, step: u32, last: u32) -> Result<Doubt, OperationError> {
        let (designed, commanded) = self.step(making.wire, step)?;
        let state = making.run.journal_state();
        let (of, before) = (state.heading.steps, self.part(state.part));
        let counted = making.run.doubtful().and_then(|doubtful| doubtful.counted);
        let in_step = counted.map_or(0.0, |part| self.time_part(making.wire, step, part));
        let counted = counted.map(|part| self.part(part));
        Ok(Doubt { wire: making.wire, step, of, last, designed, commanded, before, counted, in_step })
    }

    /// What is left of a step that was ended in its middle, for a person to read.
    pub(super) fn rest_of(&self, making: &Making, step: u32) -> Result<Option<String>, OperationError> {
        let counted = making.run.doubtful().and_then(|doubtful| doubtful.counted);
        let part = counted.unwrap_or(making.run.journal_state().part);
        if counted.is_none() && part == Part::default() {
            return Ok(None);
        }
        let (designed, commanded) = self.step(making.wire, step)?;
        // Where the axis stops before zero its sign is not the side of the bend.
        let bend = if commanded.approach_deg.is_some() { designed } else { commanded }.bend_deg;
        let part = self.part(part);
        let left = |whole: f64, part: f64, amount: fn(f64) -> String| {
            let rest = whole - part;
            if rest.abs() < SHOWN_AS_ZERO {
                "nothing".to_owned()
            } else {
                format!("{} of {}", amount(rest), amount(whole))
            }
        };
        Ok(Some(format!(
            "step {step} was stopped in its middle; what is left of it: {} to feed, {} to turn, and its bend of {:.1}° from the beginning",
            left(commanded.feed_mm, part.feed_mm, |mm| format!("{:.1}", Mm(mm))),
            left(commanded.rotate_deg, part.rotate_deg, |deg| format!("{deg:.1}°")),
            bend
        )))
    }

    /// What was said is about a step that is in no doubt.
    pub(super) fn not_in_doubt(&self, making: &Making, said: Decided) -> LiveProblem {
        let state = making.run.journal_state();
        let in_doubt = making.run.doubtful().map(|doubtful| doubtful.step);
        let run = self.target(making.wire);
        LiveProblem::OtherStep { step: said.step, in_doubt, made: state.done, run }
    }
}

/// Whether the journal says the same already: an answer that is given again changes nothing.
pub(super) fn is_settled(task: &Task, run: &JobRun, Decided { step, what }: Decided) -> bool {
    let state = run.journal_state();
    let next = step == state.done + 1 && state.in_doubt().is_none();
    match what {
        Decision::Made => step <= state.done,
        Decision::NotMade => next && state.part == Part::default(),
        Decision::AsCounted => next && run.counted_before(step) == Some(state.part),
        Decision::Part(part) => next && state.part.is_measured_as(task.told_part(part)),
    }
}

/// What a person has said of steps, as a question whether it is so.
pub(super) fn said_before(task: &Task, run: &JobRun) -> Option<(u32, String)> {
    let said = |(step, outcome)| match outcome {
        StepOutcome::Made => format!("step {step} was done"),
        StepOutcome::NotMade => format!("nothing of step {step} was done"),
        StepOutcome::Part(part) => {
            let part = task.part(part);
            format!("of step {step} {:.1} were fed and {:.1}° turned", Mm(part.feed_mm), part.rotate_deg)
        }
    };
    let (first, _) = run.said().next()?;
    let all: Vec<String> = run.said().map(said).collect();
    Some((first, format!("You have said before: {}. Is that so?", all.join("; "))))
}
