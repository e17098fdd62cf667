//! The wire that is made, in its own numbers and in those of the controller's session.

use std::fmt;

use wirebend_driver_api::Run;

/// A session and the steps of the wire that were made before it: what a journal keeps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Token {
    pub session: u16,
    /// How often the controller had started: it has lost nothing as long as that is so.
    pub boots: u32,
    pub after: u32,
}

impl Token {
    /// What this driver has written; `None` for what another has.
    pub fn parse(text: &str) -> Option<Self> {
        let mut parts = text.split('-');
        let session = parts.next()?.parse().ok().filter(|session| (1..u16::MAX).contains(session))?;
        let (boots, after) = (parts.next()?.parse().ok()?, parts.next()?.parse().ok()?);
        parts.next().is_none().then_some(Self { session, boots, after })
    }
}

impl fmt::Display for Token {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}-{}-{}", self.session, self.boots, self.after)
    }
}

/// Steps are counted from 1; line n of the session is step `after + n`.
#[derive(Debug)]
pub(super) struct Wire {
    after: u32,
    pub steps: u32,
    pub given: u32,
    pub done: u32,
    /// The last step was given.
    pub closed: bool,
    /// Where the head stands before the next step, steps.
    pub rotate_at: i32,
    /// What the head has to turn besides with the next step, steps.
    pub turn: i32,
    /// Where the head stands was told, or asked.
    pub placed: bool,
}

impl Wire {
    pub fn new(run: &Run, rotate_at: i32) -> Self {
        let Run { after, steps, .. } = *run;
        Self { after, steps, given: after, done: after, closed: false, rotate_at, turn: 0, placed: false }
    }

    /// In a session that has taken and made lines already.
    pub fn going_on(token: Token, last: u32, done: u32) -> Self {
        let after = token.after;
        Self {
            after,
            steps: u32::MAX,
            given: after.saturating_add(last),
            done: after.saturating_add(done),
            closed: false,
            rotate_at: 0,
            turn: 0,
            placed: true,
        }
    }

    /// The steps that are made by now and were not before.
    pub fn made(&mut self, line: u32) -> std::ops::RangeInclusive<u32> {
        let from = self.done + 1;
        self.done = self.done.max(self.after.saturating_add(line)).min(self.given);
        from..=self.done
    }

    pub fn is_made(&self) -> bool {
        self.closed && self.done == self.steps
    }

    /// The step of which nobody knows whether it was made.
    pub fn in_doubt(&self) -> Option<u32> {
        (self.given > self.done).then_some(self.done + 1)
    }
}
