//! Requests that are no lines: repeated until their effect is seen, one after the other.

use std::collections::VecDeque;

use super::{PATIENCE, Time};
use crate::protocol::{State, Status};

/// What stores something is repeated when nothing is heard of it for so long.
const STORED_WITHIN: Time = Time::from_millis(1200);

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Request {
    /// Slow down and hold.
    Pause,
    /// Leave the hold.
    Resume,
    /// The speed override, percent; 0 asks for it.
    Speed(u8),
    /// The head stands here, steps.
    Head(i32),
    Read(u8),
    /// A setting's new value.
    Write(u8, i32),
    /// The settings that were compiled in.
    LoadDefaults,
    /// How it stands, for a person.
    Status,
    /// What it is: the session that is open is opened once more, which changes nothing.
    Version(u16),
    /// The motors are turned off.
    Release,
}

impl Request {
    /// What is stored takes some milliseconds a byte, all of the settings, twice, three quarters of a second. A repetition would
    /// be answered too, and its refusal be taken for that of the next request.
    const fn patience(self) -> Time {
        match self {
            Self::Write(..) | Self::LoadDefaults => STORED_WITHIN,
            _ => PATIENCE,
        }
    }

    fn payload(self) -> String {
        match self {
            Self::Pause => "P".to_owned(),
            Self::Resume => "G".to_owned(),
            Self::Speed(0) => "U".to_owned(),
            Self::Speed(percent) => format!("U{percent}"),
            Self::Head(steps) => format!("Z{steps}"),
            Self::Read(id) => format!("C{id}"),
            Self::Write(id, value) => format!("W{id},{value}"),
            Self::LoadDefaults => "L".to_owned(),
            Self::Status => "Q".to_owned(),
            Self::Version(session) => format!("S{session}"),
            Self::Release => "R".to_owned(),
        }
    }
}

#[derive(Debug, Default)]
pub(super) struct Requests {
    waiting: VecDeque<Request>,
    again_at: Option<Time>,
    /// A status was heard since the first was sent.
    status_heard: bool,
}

impl Requests {
    pub fn push(&mut self, ask: Request) {
        self.waiting.push_back(ask);
    }

    pub fn is_empty(&self) -> bool {
        self.waiting.is_empty()
    }

    /// The payload that is to be sent now.
    pub fn due(&mut self, now: Time) -> Option<String> {
        let first = self.waiting.front()?;
        if self.again_at.is_some_and(|at| at > now) {
            return None;
        }
        self.again_at = Some(now + first.patience());
        Some(first.payload())
    }

    fn answered(&mut self, is_answer: impl FnOnce(Request) -> bool) -> Option<Request> {
        // Only what was sent can be answered.
        self.again_at?;
        let first = *self.waiting.front()?;
        is_answer(first).then(|| {
            self.waiting.pop_front();
            (self.again_at, self.status_heard) = (None, false);
            first
        })
    }

    /// The request whose effect this status shows.
    pub fn status(&mut self, status: &Status) -> Option<Request> {
        // The first may have been on its way already: of a machine that was not homed before, it would show nothing.
        let later = self.again_at.is_some() && std::mem::replace(&mut self.status_heard, true);
        self.answered(|ask| match ask {
            Request::Pause => status.state == State::Hold,
            Request::Resume => matches!(status.state, State::Idle | State::Run),
            Request::Head(steps) => status.position[1] == steps,
            Request::Status => true,
            Request::Release => !status.homed && later,
            Request::Speed(_)
            | Request::Read(_)
            | Request::Write(..)
            | Request::LoadDefaults
            | Request::Version(_) => false,
        })
    }

    /// The request that this value answers.
    pub fn value(&mut self, id: u8, value: i32) -> Option<Request> {
        self.answered(|ask| match ask {
            Request::Read(asked) => asked == id,
            Request::Write(asked, wanted) => asked == id && wanted == value,
            // Answered with the first one.
            Request::LoadDefaults => id == 1,
            _ => false,
        })
    }

    /// The request that this speed answers.
    pub fn speed(&mut self, percent: u8) -> Option<Request> {
        self.answered(|ask| ask == Request::Speed(percent) || ask == Request::Speed(0))
    }

    /// The request that an opened session answers.
    pub fn opened(&mut self, id: u16) -> Option<Request> {
        self.answered(|ask| ask == Request::Version(id))
    }

    /// The request with this letter that waits for its answer; it is not repeated any more.
    pub fn refused(&mut self, command: u8) -> Option<Request> {
        self.answered(|ask| ask.payload().as_bytes().first() == Some(&command))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::Alarm;

    /// Both would be answered, and a refusal of the second be taken for one of the request after it.
    #[test]
    fn what_is_being_stored_is_not_asked_for_again() {
        let mut requests = Requests::default();
        requests.push(Request::Write(3, 5));
        requests.push(Request::Write(4, 6));
        assert!(requests.due(Time::ZERO).is_some());
        assert_eq!(requests.due(STORED_WITHIN / 2), None);
        assert_eq!(requests.due(STORED_WITHIN).as_deref(), Some("W3,5"));
        assert_eq!(requests.refused(b'W'), Some(Request::Write(3, 5)));
        assert_eq!(requests.refused(b'W'), None, "the next has not been sent");
    }

    /// A status that was on its way already shows nothing of a machine that was not homed before.
    #[test]
    fn the_motors_are_off_once_a_status_after_that_says_so() {
        let status = Status {
            state: State::Idle,
            alarm: Alarm::None,
            position: [0; 3],
            last: 0,
            done: 0,
            peg_out: None,
            switch: false,
            homed: false,
        };
        let mut requests = Requests::default();
        requests.push(Request::Release);
        assert_eq!(requests.status(&status), None, "it was not sent");
        assert!(requests.due(Time::ZERO).is_some());
        assert_eq!(requests.status(&status), None, "it may be from before");
        assert_eq!(requests.status(&status), Some(Request::Release));
    }
}
