//! A step in doubt: what is known of it, and what a person says.

use wirebend_driver_host::jobs::{JobRun, Part, Verdict};

use super::making::Making;
use super::task::Task;
use crate::drivers::Signs;
use crate::{AppError, Decided, Decision, Doubt, LiveProblem};

/// Less than this is left of a feed or a turn that is made, mm and degrees.
const NOTHING: f64 = 0.05;

impl Task<'_> {
    /// A person looks whether a step was made, or how much of it.
    pub(super) fn decide(
        &self,
        making: &mut Making,
        step: u32,
        last: u32,
        decided: Option<Decided>,
    ) -> Result<(), AppError> {
        if let Some(said) = decided.filter(|said| said.step != step) {
            return Err(self.not_in_doubt(making, said).into());
        }
        let doubt = self.doubt(making, step, last)?;
        let signs = self.setup.signs;
        let said = decided.map(|decided| decided.what).or_else(|| self.progress.decide(&doubt));
        let verdict = match said {
            Some(Decision::Made) => Verdict::Made,
            Some(Decision::NotMade) => Verdict::NotMade,
            Some(Decision::Part(part)) => Verdict::Part(signs.told_part(part)),
            Some(Decision::AsCounted) => {
                let counted = doubt.counted.ok_or(LiveProblem::NotCounted { step })?;
                Verdict::Part(signs.told_part(counted))
            }
            None => {
                let command = self.command(making.wire, "--resume");
                return Err(LiveProblem::InDoubt { doubt: Box::new(doubt), command }.into());
            }
        };
        making.run.decide(step, verdict).map_err(LiveProblem::from)?;
        Ok(())
    }

    fn doubt(&self, making: &Making, step: u32, last: u32) -> Result<Doubt, AppError> {
        let (designed, told) = self.step(making.wire, step)?;
        let account = making.run.account();
        let (of, before) = (account.heading.steps, self.setup.signs.part(account.part));
        let counted = making.run.doubtful().and_then(|doubtful| doubtful.counted);
        let counted = counted.map(|part| self.setup.signs.part(part));
        Ok(Doubt { wire: making.wire, step, of, last, designed, told, before, counted })
    }

    /// What is left of a step that was ended in its middle, for a person to read.
    pub(super) fn rest_of(&self, making: &Making, step: u32) -> Result<Option<String>, AppError> {
        let counted = making.run.doubtful().and_then(|doubtful| doubtful.counted);
        let part = counted.unwrap_or(making.run.account().part);
        if counted.is_none() && part == Part::default() {
            return Ok(None);
        }
        let (_, told) = self.step(making.wire, step)?;
        let part = self.setup.signs.part(part);
        let left = |whole: f64, part: f64, unit: &str| {
            let rest = whole - part;
            if rest.abs() < NOTHING {
                "nothing".to_owned()
            } else {
                format!("{rest:.1}{unit} of {whole:.1}{unit}")
            }
        };
        Ok(Some(format!(
            "step {step} was stopped in its middle; what is left of it: {} to feed, {} to turn, and its bend of {:.1}° from the beginning",
            left(told.feed_mm, part.feed_mm, " mm"),
            left(told.rotate_deg, part.rotate_deg, "°"),
            told.bend_deg
        )))
    }

    /// What was said is about a step that is in no doubt.
    pub(super) fn not_in_doubt(&self, making: &Making, said: Decided) -> LiveProblem {
        let account = making.run.account();
        let in_doubt = making.run.doubtful().map(|doubtful| doubtful.step);
        let command = self.command(making.wire, "--resume");
        LiveProblem::OtherStep { step: said.step, in_doubt, made: account.done, command }
    }
}

/// Whether the journal says the same already: an answer that is given again changes nothing.
pub(super) fn is_settled(run: &JobRun, signs: Signs, Decided { step, what }: Decided) -> bool {
    let account = run.account();
    let next = step == account.done + 1 && account.in_doubt().is_none();
    match what {
        Decision::Made => step <= account.done,
        Decision::NotMade => next && account.part == Part::default(),
        Decision::AsCounted => next && run.counted_before(step) == Some(account.part),
        Decision::Part(part) => next && account.part.is_measured_as(signs.told_part(part)),
    }
}

/// What a person has said of steps, as a question whether it is so.
pub(super) fn said_before(run: &JobRun, signs: Signs) -> Option<(u32, String)> {
    let said = |(step, verdict)| match verdict {
        Verdict::Made => format!("step {step} was made"),
        Verdict::NotMade => format!("nothing of step {step} was made"),
        Verdict::Part(part) => {
            let part = signs.part(part);
            format!("of step {step} {:.1} mm were fed and {:.1}° turned", part.feed_mm, part.rotate_deg)
        }
    };
    let (first, _) = run.said().next()?;
    let all: Vec<String> = run.said().map(said).collect();
    Some((first, format!("You have said before: {}. Is that so?", all.join("; "))))
}
