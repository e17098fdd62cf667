//! From an open port to an open session.

use super::Time;
use crate::protocol::{NO_SESSION, Refusal, ReplyFrame, Versions, sealed};

/// How often it is tried.
const EVERY: Time = Time::from_millis(60);
const PROBES: u32 = 6;
const TRIES: u32 = 40;

/// There is no answer.
#[derive(Debug)]
pub(super) struct NoAnswer;

#[derive(Debug)]
enum Step {
    /// A port that is opened resets most boards; they say so when they have started.
    AwaitBoot {
        until: Time,
    },
    /// Whether the session of before is still there. Changes nothing.
    Probe {
        session: u16,
        tries: u32,
        at: Time,
    },
    Open {
        tries: u32,
        at: Time,
    },
}

#[derive(Debug)]
pub(super) struct Opening {
    id: u16,
    resume: Option<u16>,
    step: Step,
}

/// What a frame means for the opening.
pub(super) enum Greeting {
    Wait,
    Open { session: u16, resumed: Option<(u32, u32)>, fresh: Option<(Versions, u32)> },
    Refused(Refusal),
}

impl Opening {
    pub fn begin(id: u16, resume: Option<u16>, until: Time) -> Self {
        Self { id, resume, step: Step::AwaitBoot { until } }
    }

    /// In a controller that is known to be there.
    pub fn anew(id: u16, now: Time) -> Self {
        Self { id, resume: None, step: Step::Open { tries: 0, at: now } }
    }

    /// What status frames are sealed with that are listened to.
    pub fn session(&self) -> Option<u16> {
        match self.step {
            Step::Probe { session, .. } => Some(session),
            _ => None,
        }
    }

    fn after_boot(&self, booted: bool, now: Time) -> Step {
        match self.resume {
            Some(session) if !booted => Step::Probe { session, tries: 0, at: now },
            _ => Step::Open { tries: 0, at: now },
        }
    }

    pub fn hear(&mut self, heard: &ReplyFrame, now: Time) -> Greeting {
        match (heard, &self.step) {
            (ReplyFrame::Boot { .. }, _) => {
                self.step = self.after_boot(true, now);
                Greeting::Wait
            }
            (ReplyFrame::Status(status), &Step::Probe { session, .. }) => {
                Greeting::Open { session, resumed: Some((status.last, status.done)), fresh: None }
            }
            (ReplyFrame::Refused { error: Refusal::NoSession, .. }, Step::Probe { .. }) => {
                self.step = Step::Open { tries: 0, at: now };
                Greeting::Wait
            }
            (&ReplyFrame::Open { id, last: 0, done: 0, versions, boots }, Step::Open { .. })
                if id == self.id =>
            {
                Greeting::Open { session: id, resumed: None, fresh: Some((versions, boots)) }
            }
            (&ReplyFrame::Refused { error, command: Some(b'S'), .. }, Step::Open { .. }) => {
                Greeting::Refused(error)
            }
            _ => Greeting::Wait,
        }
    }

    /// The frame that is to be sent now.
    pub fn due(&mut self, now: Time) -> Result<Option<Vec<u8>>, NoAnswer> {
        if let Step::AwaitBoot { until } = self.step
            && until <= now
        {
            self.step = self.after_boot(false, now);
        }
        if let Step::Probe { tries: PROBES, at, .. } = self.step
            && at <= now
        {
            self.step = Step::Open { tries: 0, at: now };
        }
        match &mut self.step {
            Step::Probe { session, tries, at } if *at <= now => {
                (*tries, *at) = (*tries + 1, now + EVERY);
                Ok(Some(sealed("Q", *session)))
            }
            Step::Open { tries: TRIES, at } if *at <= now => Err(NoAnswer),
            Step::Open { tries, at } if *at <= now => {
                (*tries, *at) = (*tries + 1, now + EVERY);
                Ok(Some(sealed(&format!("S{}", self.id), NO_SESSION)))
            }
            _ => Ok(None),
        }
    }
}
