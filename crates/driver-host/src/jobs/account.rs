//! What a journal comes to: how far a wire is, and of which steps nobody knows.

use std::ops::RangeInclusive;

use wirebend_driver_api::Step;

use super::journal::{Heading, ToldBy, What};
use super::part::Verdict;

/// How far a wire is.
#[derive(Debug, Clone, PartialEq)]
pub struct Account {
    /// What is to be made.
    pub heading: Heading,
    /// The last step that was sent, or was about to be.
    pub sent: u32,
    /// The last step that the driver is known to have taken.
    pub accepted: u32,
    /// The last step that was made.
    pub done: u32,
    /// What the driver called the machine's session when it was armed last.
    pub token: Option<String>,
    /// What happened last.
    pub standing: Standing,
    /// It was stopped since it was armed last: the machine's session is over.
    pub stopped: bool,
    /// How much of the first step that is not made is in the wire, as far as that is settled.
    pub part: Part,
    /// How far the machine says that it is with the first step in doubt.
    pub part_made: Option<PartMade>,
    /// What a person has said of steps since the machine was stopped. As long as nothing is made after it, they may take it
    /// back.
    pub(super) said: Vec<Said>,
}

/// What a person has said of a step.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Said {
    pub verdict: Verdict,
    pub step: u32,
    /// The last step that was sent, taken and made before that was said, and what was known of the next.
    before: (u32, u32, u32, Part, Option<PartMade>),
}

/// How much of a step is in the wire, in the machine's signs. Its bend is made from the beginning in any case: bends count
/// from the zero of their axis.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Part {
    /// Fed, mm.
    pub feed_mm: f64,
    /// Turned, degrees.
    pub rotate_deg: f64,
}

impl Part {
    /// What is left of a step.
    #[must_use]
    pub fn rest(self, step: Step) -> Step {
        let Step { feed_mm, rotate_deg, bend_deg } = step;
        Step { feed_mm: feed_mm - self.feed_mm, rotate_deg: rotate_deg - self.rotate_deg, bend_deg }
    }
}

/// How far the machine says that it is with what was sent of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PartMade {
    /// Fed and turned, and where the bend axis stands, in the machine's signs; nothing where it cannot tell.
    pub made: Option<Step>,
    /// The axis that was on its way stands exactly there.
    pub exact: bool,
}

/// What happened last to a wire.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Standing {
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
    /// It was stopped.
    Stopped,
    /// The machine, its line or its driver failed.
    Faulted,
    /// The wire is made.
    Finished,
    /// A person has given it up.
    Abandoned,
}

impl Account {
    pub(super) fn new(heading: Heading) -> Self {
        Self {
            heading,
            sent: 0,
            accepted: 0,
            done: 0,
            token: None,
            standing: Standing::Begun,
            stopped: false,
            part: Part::default(),
            part_made: None,
            said: Vec::new(),
        }
    }

    /// Keeps how all was before a person says something of a step.
    fn keep_said(&mut self, step: u32, verdict: Verdict) {
        let before = (self.sent, self.accepted, self.done, self.part, self.part_made);
        self.said.push(Said { verdict, step, before });
    }

    /// As it was before a person has said something of a step.
    pub(super) fn before(&self, step: u32) -> Option<Self> {
        let at = self.said.iter().position(|said| said.step == step)?;
        let (sent, accepted, done, part, part_made) = self.said[at].before;
        let said = self.said[..at].to_vec();
        Some(Self { sent, accepted, done, part, part_made, said, ..self.clone() })
    }

    /// Steps that were sent and not reported as made. While a wire is being made they are in hand; after an
    /// interruption nobody knows of them: none, some of the first, or all of them were made.
    #[must_use]
    pub fn in_doubt(&self) -> Option<RangeInclusive<u32>> {
        (self.sent > self.done && !self.is_over()).then(|| self.done + 1..=self.sent)
    }

    /// Whether nothing more is to come.
    #[must_use]
    pub const fn is_over(&self) -> bool {
        matches!(self.standing, Standing::Finished | Standing::Abandoned)
    }

    /// A wire that was taken up works without anything new being sent.
    fn works(&mut self) {
        if self.standing == Standing::Armed {
            self.standing = Standing::Running;
        }
    }

    fn is_made(&mut self, n: u32) {
        (self.done, self.accepted) = (n, self.accepted.max(n));
        (self.part, self.part_made) = (Part::default(), None);
    }

    /// The machine has stopped, and makes none of the steps after this one.
    fn not_begun_after(&mut self, n: u32) {
        (self.sent, self.accepted) = (n, self.accepted.min(n));
    }

    fn require_first_in_doubt(&self, at_work: bool, n: u32) -> Result<(), String> {
        if at_work || n != self.done + 1 || n > self.sent {
            return Err(format!("step {n} is not the first in doubt"));
        }
        Ok(())
    }

    /// Counts one more entry; what is wrong when it cannot be.
    pub(super) fn count(&mut self, what: &What) -> Result<(), String> {
        let Self { sent, accepted, done, standing, .. } = *self;
        let steps = self.heading.steps;
        let at_work = matches!(standing, Standing::Armed | Standing::Running | Standing::Paused);
        if self.is_over() && !matches!(what, What::Made { .. }) {
            return Err("the wire was over before".to_owned());
        }
        match what {
            What::Job(_) => return Err("a journal has one job".to_owned()),
            What::Connected { .. } => self.standing = Standing::Connected,
            What::Armed { token, after, going_on } => {
                if *after != done {
                    return Err(format!("it was armed after step {after}, and {done} were made"));
                }
                if !going_on && sent > done {
                    return Err(format!("it was armed anew with step {} in doubt", done + 1));
                }
                self.token.clone_from(token);
                (self.standing, self.stopped, self.part_made) = (Standing::Armed, false, None);
                self.said.clear();
            }
            What::Intent { from, to } => {
                if !at_work || *from != sent + 1 || to < from || *to > steps {
                    return Err(format!("steps {from} to {to} cannot follow step {sent} of {steps}"));
                }
                (self.sent, self.standing) = (*to, Standing::Running);
            }
            What::Accepted { n } => {
                if *n > sent || *n < accepted {
                    return Err(format!("step {n} was taken, after {accepted} and with {sent} sent"));
                }
                self.accepted = *n;
                self.works();
            }
            What::NotTaken { after } => {
                if *after > sent || *after < accepted.max(done) {
                    return Err(format!(
                        "no step after {after} was taken, with {accepted} taken and {sent} sent"
                    ));
                }
                self.sent = *after;
            }
            What::Done { n } => {
                if *n != done + 1 || *n > sent {
                    return Err(format!("step {n} was made, after {done} and with {sent} sent"));
                }
                self.is_made(*n);
                self.works();
            }
            What::PartMade { n, made, exact } => {
                if *n != done + 1 || *n > sent {
                    return Err(format!("step {n} was begun, after {done} and with {sent} sent"));
                }
                self.not_begun_after(*n);
                self.part_made = Some(PartMade { made: *made, exact: *exact });
            }
            What::Decided { n, made } => {
                self.require_first_in_doubt(at_work, *n)?;
                self.keep_said(*n, if *made { Verdict::Made } else { Verdict::NotMade });
                if *made {
                    self.is_made(*n);
                } else {
                    self.not_begun_after(done);
                }
                self.part_made = None;
            }
            What::Part { n, feed_mm, rotate_deg, by } => {
                self.require_first_in_doubt(at_work, *n)?;
                let part = Part { feed_mm: *feed_mm, rotate_deg: *rotate_deg };
                if *by == ToldBy::Person {
                    self.keep_said(*n, Verdict::Part(part));
                }
                self.not_begun_after(done);
                (self.part, self.part_made) = (part, None);
            }
            What::TakenBack { n } => {
                let before = self.before(*n).filter(|_| !at_work);
                *self =
                    before.ok_or_else(|| format!("nothing was said of step {n} that can be taken back"))?;
            }
            What::Paused if at_work => self.standing = Standing::Paused,
            What::Resumed if at_work => self.standing = Standing::Running,
            What::Paused | What::Resumed | What::Made { .. } | What::Standstill { .. } => {}
            What::Stopped { .. } => (self.standing, self.stopped) = (Standing::Stopped, true),
            What::Fault { in_doubt, .. } => {
                if let Some(n) = in_doubt.filter(|n| self.heading.version > 2 && *n == done + 1 && *n <= sent)
                {
                    self.not_begun_after(n);
                }
                self.standing = Standing::Faulted;
            }
            What::Finished if done < steps => {
                return Err(format!("it was finished with {done} of {steps} steps made"));
            }
            What::Finished => self.standing = Standing::Finished,
            What::Abandoned => self.standing = Standing::Abandoned,
        }
        Ok(())
    }
}
