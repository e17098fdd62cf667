//! What a journal comes to: how far a wire is, and of which steps nobody knows.

use std::ops::RangeInclusive;

use super::journal::{Heading, What};

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
    pub(super) const fn new(heading: Heading) -> Self {
        Self {
            heading,
            sent: 0,
            accepted: 0,
            done: 0,
            token: None,
            standing: Standing::Begun,
            stopped: false,
        }
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
                (self.standing, self.stopped) = (Standing::Armed, false);
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
                (self.done, self.accepted) = (*n, accepted.max(*n));
                self.works();
            }
            What::Decided { n, made } => {
                if at_work || *n != done + 1 || *n > sent {
                    return Err(format!("step {n} is not the first in doubt"));
                }
                if *made {
                    (self.done, self.accepted) = (*n, accepted.max(*n));
                } else {
                    (self.sent, self.accepted) = (done, done);
                }
            }
            What::Paused if at_work => self.standing = Standing::Paused,
            What::Resumed if at_work => self.standing = Standing::Running,
            What::Paused | What::Resumed | What::Made { .. } | What::Standstill { .. } => {}
            What::Stopped { .. } => (self.standing, self.stopped) = (Standing::Stopped, true),
            What::Fault { .. } => self.standing = Standing::Faulted,
            What::Finished if done < steps => {
                return Err(format!("it was finished with {done} of {steps} steps made"));
            }
            What::Finished => self.standing = Standing::Finished,
            What::Abandoned => self.standing = Standing::Abandoned,
        }
        Ok(())
    }
}
