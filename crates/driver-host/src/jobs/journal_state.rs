//! What a journal comes to: how far a wire is, and which steps are in doubt.

use std::ops::RangeInclusive;

use super::entry::{EntryKind, Heading, ToldBy};
use super::part::{Part, PartMade, StepOutcome};

/// How far a wire is.
#[derive(Debug, Clone, PartialEq)]
pub struct JournalState {
    pub heading: Heading,
    /// The last step that was sent, or was about to be.
    pub sent: u32,
    /// The last step that the driver is known to have taken.
    pub accepted: u32,
    /// The last step that is done.
    pub done: u32,
    /// The last step after which a person has said that the wire goes on past a pause point.
    pub confirmed: u32,
    /// What the driver called the machine's session when it was armed last.
    pub token: Option<String>,
    /// What happened last.
    pub standing: JobState,
    /// It was stopped since it was armed last: the machine's session is over.
    pub stopped: bool,
    /// How much of the first step that is not done is in the wire, as far as that is settled.
    pub part: Part,
    /// How far the machine says that it is with the first step in doubt.
    pub part_made: Option<PartMade>,
    /// What a person has said of steps since the machine was stopped. As long as nothing is bent after it, they may take it
    /// back.
    pub(super) said: Vec<Said>,
}

/// What a person has said of a step.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Said {
    pub outcome: StepOutcome,
    pub step: u32,
    /// The last step that was sent, taken and done before that was said, and what was known of the next.
    before: (u32, u32, u32, Part, Option<PartMade>),
}

/// What happened last to a wire.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum JobState {
    /// Nothing yet.
    Begun,
    /// The machine has answered, and is not armed since.
    Connected,
    /// The machine is armed.
    Armed,
    /// Steps were sent.
    Running,
    /// It holds.
    Paused,
    Stopped,
    /// The machine, its line or its driver failed.
    Faulted,
    /// The wire is finished.
    Finished,
    /// A person has given it up.
    Abandoned,
}

impl JournalState {
    pub(super) fn new(heading: Heading) -> Self {
        Self {
            heading,
            sent: 0,
            accepted: 0,
            done: 0,
            confirmed: 0,
            token: None,
            standing: JobState::Begun,
            stopped: false,
            part: Part::default(),
            part_made: None,
            said: Vec::new(),
        }
    }

    /// Keeps how all was before a person says something of a step.
    fn keep_said(&mut self, step: u32, outcome: StepOutcome) {
        let before = (self.sent, self.accepted, self.done, self.part, self.part_made);
        self.said.push(Said { outcome, step, before });
    }

    /// As it was before a person has said something of a step.
    pub(super) fn before(&self, step: u32) -> Option<Self> {
        let at = self.said.iter().position(|said| said.step == step)?;
        let (sent, accepted, done, part, part_made) = self.said[at].before;
        let said = self.said[..at].to_vec();
        Some(Self { sent, accepted, done, part, part_made, said, ..self.clone() })
    }

    /// Steps that were sent and not reported as done. While a wire is being bent they are in hand; after an
    /// interruption they are in doubt: none, some of the first, or all of them were done.
    #[must_use]
    pub fn in_doubt(&self) -> Option<RangeInclusive<u32>> {
        (self.sent > self.done && !self.is_over()).then(|| self.done + 1..=self.sent)
    }

    /// Whether nothing of it is made, so that a new one can take its place: no step was sent, or none of what was sent was done,
    /// and no part of the first step is in the wire.
    #[must_use]
    pub fn is_blank(&self) -> bool {
        self.sent == 0 && self.part == Part::default()
    }

    /// Whether nothing more is to come.
    #[must_use]
    pub const fn is_over(&self) -> bool {
        matches!(self.standing, JobState::Finished | JobState::Abandoned)
    }

    /// A wire that was reattached works without anything new being sent.
    fn works(&mut self) {
        if self.standing == JobState::Armed {
            self.standing = JobState::Running;
        }
    }

    fn is_made(&mut self, n: u32) {
        (self.done, self.accepted) = (n, self.accepted.max(n));
        (self.part, self.part_made) = (Part::default(), None);
    }

    /// The machine has stopped, and does none of the steps after this one.
    fn not_begun_after(&mut self, n: u32) {
        (self.sent, self.accepted) = (n, self.accepted.min(n));
    }

    fn take_back(&mut self, at_work: bool, n: u32) -> Result<(), String> {
        let before = self.before(n).filter(|_| !at_work);
        *self = before.ok_or_else(|| format!("nothing was said of step {n} that can be taken back"))?;
        Ok(())
    }

    fn confirm_pause(&mut self, at_work: bool, after: u32) -> Result<(), String> {
        let Self { done, confirmed, .. } = *self;
        if !at_work || after != done || after <= confirmed {
            return Err(format!("the pause after step {after} was confirmed, with {done} done"));
        }
        self.confirmed = after;
        Ok(())
    }

    fn require_first_in_doubt(&self, at_work: bool, n: u32) -> Result<(), String> {
        if at_work || n != self.done + 1 || n > self.sent {
            return Err(format!("step {n} is not the first in doubt"));
        }
        Ok(())
    }

    /// Counts one more entry; what is wrong when it cannot be.
    pub(super) fn count(&mut self, what: &EntryKind) -> Result<(), String> {
        let Self { sent, accepted, done, standing, .. } = *self;
        let steps = self.heading.steps;
        let at_work = matches!(standing, JobState::Armed | JobState::Running | JobState::Paused);
        if self.is_over() && !matches!(what, EntryKind::Made { .. }) {
            return Err("the wire was over before".to_owned());
        }
        match what {
            EntryKind::Job(_) => return Err("a journal has one job".to_owned()),
            EntryKind::Connected { .. } => self.standing = JobState::Connected,
            EntryKind::Armed { token, after, resumed } => {
                if *after != done {
                    return Err(format!("it was armed after step {after}, and {done} were done"));
                }
                if !resumed && sent > done {
                    return Err(format!("it was armed anew with step {} in doubt", done + 1));
                }
                self.token.clone_from(token);
                (self.standing, self.stopped, self.part_made) = (JobState::Armed, false, None);
                self.said.clear();
            }
            EntryKind::Intent { from, to } => {
                if !at_work || *from != sent + 1 || to < from || *to > steps {
                    return Err(format!("steps {from} to {to} cannot follow step {sent} of {steps}"));
                }
                (self.sent, self.standing) = (*to, JobState::Running);
            }
            EntryKind::Accepted { n } => {
                if *n > sent || *n < accepted {
                    return Err(format!("step {n} was taken, after {accepted} and with {sent} sent"));
                }
                self.accepted = *n;
                self.works();
            }
            EntryKind::NotTaken { after } => {
                if *after > sent || *after < accepted.max(done) {
                    return Err(format!(
                        "no step after {after} was taken, with {accepted} taken and {sent} sent"
                    ));
                }
                self.sent = *after;
            }
            EntryKind::Done { n } => {
                if *n != done + 1 || *n > sent {
                    return Err(format!("step {n} was done, after {done} and with {sent} sent"));
                }
                self.is_made(*n);
                self.works();
            }
            EntryKind::PartMade { n, made, exact } => {
                if *n != done + 1 || *n > sent {
                    return Err(format!("step {n} was begun, after {done} and with {sent} sent"));
                }
                self.not_begun_after(*n);
                self.part_made = Some(PartMade { made: *made, exact: *exact });
            }
            EntryKind::Decided { n, made } => {
                self.require_first_in_doubt(at_work, *n)?;
                self.keep_said(*n, if *made { StepOutcome::Made } else { StepOutcome::NotMade });
                if *made {
                    self.is_made(*n);
                } else {
                    self.not_begun_after(done);
                }
                self.part_made = None;
            }
            EntryKind::Part { n, feed_mm, rotate_deg, by } => {
                self.require_first_in_doubt(at_work, *n)?;
                let part = Part { feed_mm: *feed_mm, rotate_deg: *rotate_deg };
                if *by == ToldBy::Person {
                    self.keep_said(*n, StepOutcome::Part(part));
                }
                self.not_begun_after(done);
                (self.part, self.part_made) = (part, None);
            }
            EntryKind::TakenBack { n } => self.take_back(at_work, *n)?,
            EntryKind::PauseConfirmed { after, .. } => self.confirm_pause(at_work, *after)?,
            EntryKind::Paused if at_work => self.standing = JobState::Paused,
            EntryKind::Resumed if at_work => self.standing = JobState::Running,
            EntryKind::Paused
            | EntryKind::Resumed
            | EntryKind::Made { .. }
            | EntryKind::Standstill { .. } => {}
            EntryKind::Stopped { .. } => (self.standing, self.stopped) = (JobState::Stopped, true),
            EntryKind::Fault { in_doubt, .. } => {
                if let Some(n) = in_doubt.filter(|n| self.heading.version > 2 && *n == done + 1 && *n <= sent)
                {
                    self.not_begun_after(n);
                }
                self.standing = JobState::Faulted;
            }
            EntryKind::Finished if done < steps => {
                return Err(format!("it was finished with {done} of {steps} steps done"));
            }
            EntryKind::Finished => self.standing = JobState::Finished,
            EntryKind::Abandoned => self.standing = JobState::Abandoned,
        }
        Ok(())
    }
}
