//! The line to a controller: a session, numbered lines that are run once, requests that are repeated until
//! their effect is seen, and a stop that is repeated until it is answered.
//!
//! Pure: bytes and times go in, bytes and news come out. Whatever the line does to the bytes, no line is run
//! twice, none is run out of order, and none is reported as done that was not.

mod opening;
mod queue;
mod request;

use std::time::Duration;

use crate::protocol::{
    Alarm, Lines, NO_SESSION, Refusal, ReplyFrame, Reset, STOP, State, Status, Versions, sealed,
};
use opening::{Greeting, Opening};
use queue::Queue;
pub use request::Request;
use request::Requests;

/// Time since any moment, always the same one.
pub type Time = Duration;

/// What was sent is repeated when nothing is heard of it for so long.
const PATIENCE: Time = Duration::from_millis(40);
/// How often the status is asked for; the controller holds when it hears nothing for a second.
const QUERY_EVERY: Time = Duration::from_millis(250);
/// A STOP that is not answered is repeated.
const STOP_EVERY: Time = Duration::from_millis(20);
/// A controller that says nothing for so long is gone.
const LOST_AFTER: Time = Duration::from_millis(1500);
/// And for so many questions.
const LOST_QUESTIONS: u32 = 5;

/// What has become known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MachineEvent {
    /// The session is open. `resumed` when it is one of before: lines taken and done in it.
    Open {
        /// Lines taken and lines done.
        resumed: Option<(u32, u32)>,
        /// What the controller is, and how often it has started; a session that is resumed was asked before.
        fresh: Option<(Versions, u32)>,
    },
    /// The controller has started, for this reason.
    Boot(Reset),
    /// It has lost the session: it was reset, and its boot frame was not heard.
    SessionLost,
    /// Lines up to this one are taken.
    Accepted(u32),
    /// Lines up to this one are done.
    Done(u32),
    Status(Status),
    /// The speed override, percent: set, or asked for.
    Speed(u8),
    /// A request has had its effect.
    Answered(Request),
    Setting {
        id: u8,
        value: i32,
    },
    /// A command was refused: the letter, and why.
    Refused {
        /// The letter of the command.
        command: u8,
        error: Refusal,
        /// The request, where it was one.
        ask: Option<Request>,
    },
    /// It has stopped, or holds.
    Alarm(Alarm),
    /// Nothing is heard of it any more.
    Silent,
}

#[derive(Debug)]
pub struct Link {
    session: u16,
    lines: Lines,
    opening: Option<Opening>,
    queue: Queue,
    requests: Requests,
    stopping: Option<Time>,
    heard_at: Time,
    queried_at: Time,
    /// How it stands is asked at once.
    query_now: bool,
    /// The first question that was not answered, and how many there were.
    unanswered: Option<(Time, u32)>,
    /// The controller is in no session any more; it is spoken to when a new one is opened.
    lost: bool,
    silent: bool,
    out: Vec<u8>,
    events: Vec<MachineEvent>,
}

impl Link {
    /// A line that has just been opened: waits up to `boot` for the controller's boot frame, then looks
    /// whether it still is in the session `resume`, then opens the session `id`.
    #[must_use]
    pub fn new(id: u16, resume: Option<u16>, boot: Time, now: Time) -> Self {
        Self {
            session: NO_SESSION,
            lines: Lines::default(),
            opening: Some(Opening::begin(id, resume, now + boot)),
            queue: Queue::default(),
            requests: Requests::default(),
            stopping: None,
            heard_at: now,
            queried_at: now,
            query_now: false,
            unanswered: None,
            lost: false,
            silent: false,
            out: Vec::new(),
            events: Vec::new(),
        }
    }

    /// The session, once it is open.
    #[must_use]
    pub fn session(&self) -> Option<u16> {
        self.opening.is_none().then_some(self.session)
    }

    /// Opens a new session: numbers begin anew, and whatever of the old one is on its way fails its seal.
    pub fn renew(&mut self, id: u16, now: Time) {
        self.queue = Queue::default();
        self.requests = Requests::default();
        (self.lost, self.unanswered) = (false, None);
        self.opening = Some(Opening::anew(id, now));
    }

    /// Puts a line into the queue: a command letter and its numbers after `n`. Gives n.
    pub fn line(&mut self, letter: u8, numbers: &[i32]) -> u32 {
        self.queue.push(letter, numbers)
    }

    /// Lines that are done and lines that were given.
    #[must_use]
    pub const fn progress(&self) -> (u32, u32) {
        self.queue.progress()
    }

    /// Whether lines were sent that are not done, as far as is known.
    #[must_use]
    pub const fn is_outstanding(&self) -> bool {
        self.queue.is_outstanding()
    }

    /// Requests for something that is no line.
    pub fn request(&mut self, request: Request) {
        self.requests.push(request);
    }

    /// Requests at once how it stands.
    pub fn query(&mut self) {
        self.query_now = true;
    }

    /// Whether every request has had its effect.
    #[must_use]
    pub fn is_answered(&self) -> bool {
        self.requests.is_empty()
    }

    /// Stops the machine at once, and forgets what has not been sent.
    pub fn stop(&mut self, now: Time) {
        self.queue.forget();
        self.requests = Requests::default();
        self.stopping = Some(now + STOP_EVERY);
        self.out.push(STOP);
    }

    /// A hold, for when no program will be there to hear whether it came.
    #[must_use]
    pub fn hold(&self) -> Vec<u8> {
        sealed("P", self.session)
    }

    /// Whether a stop was not answered yet.
    #[must_use]
    pub const fn is_stopping(&self) -> bool {
        self.stopping.is_some()
    }

    /// Takes what has come, and does what is due.
    pub fn advance(&mut self, bytes: &[u8], now: Time) {
        for &byte in bytes {
            if let Some(line) = self.lines.feed(byte)
                && let Some(heard) = ReplyFrame::of(&line, self.listening_to())
            {
                (self.heard_at, self.silent, self.unanswered) = (now, false, None);
                self.hear(heard, now);
            }
        }
        self.due(now);
    }

    /// The bytes that are to be sent.
    pub fn take_bytes(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.out)
    }

    /// What has become known since the last time.
    pub fn take_events(&mut self) -> Vec<MachineEvent> {
        std::mem::take(&mut self.events)
    }

    fn listening_to(&self) -> u16 {
        self.opening.as_ref().map_or(self.session, |opening| opening.session().unwrap_or(self.session))
    }

    fn hear(&mut self, heard: ReplyFrame, now: Time) {
        if let Some(opening) = &mut self.opening {
            match opening.hear(&heard, now) {
                Greeting::Open { session, resumed, fresh } => {
                    (self.session, self.opening) = (session, None);
                    let (last, done) = resumed.unwrap_or_default();
                    self.queue = Queue::after(last, done);
                    // How it stands is asked at once.
                    self.queried_at = now.saturating_sub(QUERY_EVERY);
                    self.events.push(MachineEvent::Open { resumed, fresh });
                }
                Greeting::Refused(error) => {
                    self.events.push(MachineEvent::Refused { command: b'S', error, ask: None });
                }
                Greeting::Wait => {}
            }
        }
        match heard {
            ReplyFrame::Boot { reset, .. } => {
                self.lost = self.opening.is_none();
                self.events.push(MachineEvent::Boot(reset));
            }
            ReplyFrame::Alarm(alarm) => {
                // Only this answers a STOP: a status may have been sent before it came.
                if alarm == Alarm::Stop {
                    self.stopping = None;
                }
                self.alarmed(alarm);
            }
            _ if self.opening.is_some() || self.lost => {}
            ReplyFrame::Refused { error: Refusal::NoSession, .. } => {
                self.lost = true;
                self.events.push(MachineEvent::SessionLost);
            }
            ReplyFrame::Refused { error, next, command } => self.refused(error, next, command, now),
            ReplyFrame::Accepted { last } | ReplyFrame::Full { last } => {
                let full = matches!(heard, ReplyFrame::Full { .. });
                if let Some(last) = self.queue.accepted(last, full, now) {
                    self.events.push(MachineEvent::Accepted(last));
                }
            }
            ReplyFrame::Done { n } => self.done(n, now),
            ReplyFrame::Status(status) => self.stands(status, now),
            ReplyFrame::Speed { percent } => {
                self.events.extend(self.requests.speed(percent).map(|_| MachineEvent::Speed(percent)));
            }
            ReplyFrame::Value { id, value } => {
                self.events.push(MachineEvent::Setting { id, value });
                self.events.extend(self.requests.value(id, value).map(MachineEvent::Answered));
            }
            ReplyFrame::Open { id, .. } => {
                self.events.extend(self.requests.opened(id).map(MachineEvent::Answered));
            }
        }
    }

    fn done(&mut self, n: u32, now: Time) {
        if let Some(n) = self.queue.done(n, now) {
            self.events.push(MachineEvent::Done(n));
        }
    }

    fn stands(&mut self, status: Status, now: Time) {
        if status.state == State::Alarm {
            self.alarmed(status.alarm);
        }
        // A report that was lost on its way is in the status too.
        if let Some(last) = self.queue.accepted(status.last, false, now) {
            self.events.push(MachineEvent::Accepted(last));
        }
        self.done(status.done, now);
        self.events.push(MachineEvent::Status(status));
        self.events.extend(self.requests.status(&status).map(MachineEvent::Answered));
    }

    fn alarmed(&mut self, alarm: Alarm) {
        if !matches!(alarm, Alarm::HostLost | Alarm::HoldInput) {
            self.queue.alarmed();
        }
        self.events.push(MachineEvent::Alarm(alarm));
    }

    fn refused(&mut self, error: Refusal, next: u32, command: Option<u8>, now: Time) {
        match (error, command) {
            (Refusal::Damaged | Refusal::Gap, _) => self.queue.go_back(next, now),
            (_, Some(command)) => {
                let ask = self.requests.refused(command);
                // Else it answers a repetition of what has been answered.
                if ask.is_some() || self.queue.refused(command, next) {
                    self.events.push(MachineEvent::Refused { command, error, ask });
                }
            }
            (_, None) => {}
        }
    }

    fn due(&mut self, now: Time) {
        if self.stopping.is_some_and(|at| at <= now) {
            self.out.push(STOP);
            self.stopping = Some(now + STOP_EVERY);
        }
        if let Some(opening) = &mut self.opening {
            match opening.due(now) {
                Ok(frame) => self.out.extend(frame.unwrap_or_default()),
                Err(opening::NoAnswer) if !self.silent => {
                    self.silent = true;
                    self.events.push(MachineEvent::Silent);
                }
                Err(opening::NoAnswer) => {}
            }
            return;
        }
        if self.lost {
            return;
        }
        if let Some(payload) = self.requests.due(now) {
            // That belongs to no session.
            let seal = if payload.starts_with('S') { NO_SESSION } else { self.session };
            self.out.extend(sealed(&payload, seal));
        }
        for payload in self.queue.due(now) {
            self.out.extend(sealed(&payload, self.session));
        }
        // A controller that has been silent since it was asked is asked again before it thinks us gone.
        let unanswered = self.heard_at < self.queried_at && now >= self.queried_at + 2 * PATIENCE;
        if std::mem::take(&mut self.query_now) || unanswered || now >= self.queried_at + QUERY_EVERY {
            self.queried_at = now;
            self.out.extend(sealed("Q", self.session));
            let (since, asked) = self.unanswered.unwrap_or((now, 0));
            self.unanswered = Some((since, asked + 1));
        }
        // Only questions can go unanswered: the program may not have looked for a while.
        let gone =
            self.unanswered.is_some_and(|(since, asked)| now > since + LOST_AFTER && asked >= LOST_QUESTIONS);
        if gone && !self.silent {
            self.silent = true;
            self.events.push(MachineEvent::Silent);
        }
    }
}
