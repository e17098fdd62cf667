//! What is to be bent, and whether it fits to a journal.

use std::time::Duration;

use wirebend_driver_api::{Run, Step};

use super::entry::Heading;
use super::error::JobError;
use super::part::Part;

/// A step after which the machine waits until a person has done something.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PauseAfter {
    /// The step, from 1; never the last of the wire.
    pub after: u32,
    /// What they have to do.
    pub note: String,
}

/// How long a step takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct StepTime {
    /// To feed.
    pub feed: Duration,
    /// To turn the head.
    pub rotate: Duration,
    /// For all the rest.
    pub bend: Duration,
}

impl StepTime {
    /// All together.
    #[must_use]
    pub fn total(&self) -> Duration {
        self.feed + self.rotate + self.bend
    }
}

#[derive(Debug, Clone, PartialEq)]
pub struct WireJob {
    /// The wire; `after` and `rotate_at_deg` are filled in from the journal and the play.
    pub run: Run,
    /// All of its steps, in the machine's signs.
    pub steps: Vec<Step>,
    /// How long each is estimated to take; may be empty.
    pub estimates: Vec<StepTime>,
    /// The play of the head that the steps make up for, degrees.
    pub head_play_deg: f64,
    /// From where to where the head turns, degrees from its zero.
    pub head_range_deg: [f64; 2],
    /// Where the machine waits for a person, in order.
    pub pauses: Vec<PauseAfter>,
}

impl WireJob {
    /// How long a part of the step after the first `done` takes.
    pub(super) fn time_of(&self, done: u32, part: Part) -> Duration {
        let at = usize::try_from(done).unwrap_or(usize::MAX);
        let (Some(time), Some(step)) = (self.estimates.get(at), self.steps.get(at)) else {
            return Duration::ZERO;
        };
        let share = |part: f64, whole: f64| if whole == 0.0 { 0.0 } else { (part / whole).clamp(0.0, 1.0) };
        time.feed.mul_f64(share(part.feed_mm, step.feed_mm))
            + time.rotate.mul_f64(share(part.rotate_deg, step.rotate_deg))
    }

    /// Whether it is what a journal is of, and can be sent.
    pub(super) fn fits(&self, heading: &Heading) -> Result<(), JobError> {
        let run = &self.run;
        let number = |wire: usize| wire.saturating_add(1).to_string();
        let pairs = [
            ("job", heading.job_hash.clone(), run.job_hash.clone()),
            ("number", number(heading.wire), number(run.wire)),
            ("number of steps", heading.steps.to_string(), run.steps.to_string()),
            ("machine", heading.machine.clone(), run.machine.clone()),
        ];
        if let Some((what, journal, job)) = pairs.into_iter().find(|(_, journal, job)| journal != job) {
            return Err(JobError::OtherWire { what, journal, job });
        }
        if usize::try_from(run.steps) != Ok(self.steps.len()) {
            let what = format!("the wire has {} steps, and {} are there", run.steps, self.steps.len());
            return Err(JobError::Steps { what });
        }
        let ascending = self.pauses.is_sorted_by(|one, next| one.after < next.after);
        if !ascending || self.pauses.iter().any(|pause| !(1..run.steps).contains(&pause.after)) {
            let what = "a pause point does not come after a step of the wire before its last";
            return Err(JobError::Steps { what: what.to_owned() });
        }
        let finite =
            |step: &Step| [step.feed_mm, step.rotate_deg, step.bend_deg].iter().all(|v| v.is_finite());
        match self.steps.iter().position(|step| !finite(step)) {
            Some(at) => {
                Err(JobError::Steps { what: format!("step {} has a value that is no number", at + 1) })
            }
            None => Ok(()),
        }
    }
}
