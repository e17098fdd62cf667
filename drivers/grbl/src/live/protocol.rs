//! The conversation with the controller: bytes and time in, bytes and events out. No port, no clock.

use std::collections::VecDeque;
use std::rc::Rc;
use std::time::Duration;

use wirebend_driver_api::{Direction, DriverError, Event};

use super::asking::{Asking, Turn};
use super::connecting::{Greeting, Reading};
use super::cut::Cut;
use super::ending::Reset;
use super::incoming::{Incoming, Line};
use super::machine::Machine;
use super::making::{Hold, Making};
use super::reply::Reply;
use super::status::{State, Status};
use super::stream::Stream;
use crate::settings::Settings;

/// So many lines in one run may be none of grbl's. One or two are a spark; more are a bad cable.
const MOST_GARBLED: u32 = 5;

/// What goes on.
#[derive(Debug)]
pub(super) enum Phase {
    /// Nothing has been heard that is grbl's.
    Greeting(Greeting),
    /// It is asked what it is.
    Reading(Reading),
    /// Connected, nothing goes on.
    Ready,
    /// It looks for its reference, or is told that it stands there.
    Homing { since: Duration },
    /// One axis moves; since when it is to stop.
    Jogging { stopping: Option<Duration> },
    /// A wire is made, or about to be.
    Making(Box<Making>),
    /// Something went wrong and it slows down, so that it can be reset without losing its place.
    Halting { since: Duration },
    /// It has been reset and is to greet.
    Resetting(Reset),
    /// It does not answer. It can still be told to stop.
    Mute,
    /// The port is closed, or about to be.
    Over,
}

/// See the module.
#[derive(Debug)]
pub(crate) struct Protocol {
    pub(super) settings: Rc<Settings>,
    pub(super) phase: Phase,
    pub(super) now: Duration,
    pub(super) incoming: Incoming,
    output: Vec<u8>,
    events: VecDeque<Event>,
    pub(super) stream: Stream,
    pub(super) asking: Asking,
    pub(super) machine: Machine,
    pub(super) garbled: u32,
    /// The step that an end has met in its middle, until the machine stands.
    pub(super) cut: Option<Cut>,
}

impl Protocol {
    /// The port has just been opened.
    pub fn new(settings: Rc<Settings>) -> Self {
        Self {
            stream: Stream::new(settings.streaming),
            settings,
            phase: Phase::Greeting(Greeting::at(Duration::ZERO)),
            now: Duration::ZERO,
            incoming: Incoming::default(),
            output: Vec::new(),
            events: VecDeque::new(),
            asking: Asking::default(),
            machine: Machine::default(),
            garbled: 0,
            cut: None,
        }
    }

    /// Bytes have come.
    pub fn receive(&mut self, bytes: &[u8], now: Duration) {
        self.now = now;
        for line in self.incoming.lines(bytes) {
            match line {
                _ if self.is_over() => return,
                Line::Text(text) => self.line(&text),
                Line::Garbled(text) => self.noise(&text),
            }
        }
        self.feed();
    }

    /// Time has passed.
    pub fn pass(&mut self, now: Duration) {
        self.now = now;
        match self.phase {
            Phase::Greeting(_) => self.greeting_late(),
            Phase::Reading(_) => self.reading_late(),
            Phase::Homing { since } => self.homing_late(since),
            Phase::Jogging { stopping: Some(since) } => self.jog_late(since),
            Phase::Halting { since } => self.halting_late(since),
            Phase::Resetting(_) => self.reset_late(),
            _ => {}
        }
        self.feed();
        self.ask();
    }

    /// What is to be sent.
    pub fn take_output(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.output)
    }

    /// What is to be reported next.
    pub fn next_event(&mut self) -> Option<Event> {
        self.events.pop_front()
    }

    /// Whether the port is of no more use.
    pub fn is_over(&self) -> bool {
        matches!(self.phase, Phase::Over)
    }

    /// Whether something moves or may move of what this program has asked for.
    pub fn is_moving(&self) -> bool {
        match &self.phase {
            Phase::Homing { .. } | Phase::Jogging { .. } | Phase::Halting { .. } | Phase::Resetting(_) => {
                true
            }
            Phase::Making(making) => !making.is_armed_only(),
            _ => false,
        }
    }

    fn line(&mut self, text: &str) {
        let reply = Reply::of(text);
        let old = matches!(&reply, Reply::Status(status) if self.machine.state == Some(status.state));
        if reply == Reply::Unknown {
            return self.noise(text);
        }
        if !old {
            self.console(Direction::FromMachine, text);
        }
        match reply {
            Reply::Greeting(name) => self.greeted(&name),
            Reply::Ok => self.answered(None),
            Reply::Error(code) => self.answered(Some(code.unwrap_or_default())),
            Reply::Alarm(code) => self.alarm(code.unwrap_or_default()),
            Reply::Status(status) => self.report(&status),
            Reply::Setting { key, value } => drop(self.machine.settings.insert(key, value)),
            Reply::Message(message) => self.message(&message),
            Reply::Startup | Reply::Unknown => {}
        }
    }

    fn message(&mut self, message: &str) {
        if let Some(build) = message.strip_prefix("VER:") {
            self.machine.build = Some(build.trim_end_matches(':').to_owned());
        } else if message.starts_with("MSG:'$H'") {
            self.machine.state = Some(State::Alarm);
        } else if message == "MSG:Reset to continue" {
            self.waits_for_reset();
        }
    }

    /// A line was taken, or refused with a code.
    fn answered(&mut self, error: Option<u32>) {
        if let Phase::Greeting(greeting) = &mut self.phase {
            greeting.line_answered = true;
            return self.found();
        }
        // An answer that nobody waits for is one of before a reset.
        let Some(line) = self.stream.answered(self.now) else { return };
        match error {
            Some(code) => self.refused(code, &line),
            None if matches!(self.phase, Phase::Reading(_)) => self.read_on(),
            // The jog begins with this answer.
            None => self.cancel_jog(),
        }
    }

    fn report(&mut self, status: &Status) {
        let counts = self.asking.answered() && self.stream.is_over();
        let state = status.state;
        let before = self.machine.state.replace(state);
        self.machine.reports(status);
        self.tell_position();
        let rests = counts && state == State::Idle;
        match &self.phase {
            Phase::Greeting(_) => self.found(),
            Phase::Reading(Reading::State { .. }) => self.connected(),
            Phase::Homing { .. } if rests => self.homed(),
            Phase::Jogging { .. } if rests => self.jogged(),
            Phase::Homing { .. } | Phase::Jogging { .. } | Phase::Making(_)
                if counts && state == State::Alarm =>
            {
                self.alarm(0);
            }
            Phase::Jogging { stopping: None } => self.watch_answer(state),
            Phase::Jogging { stopping: Some(_) } if state == State::Jog => self.cancel_jog(),
            Phase::Making(_) => self.making(state, before, rests),
            Phase::Halting { .. } if counts => self.halted(state),
            Phase::Resetting(reset) if reset.greeted => self.settled(state),
            _ => {}
        }
    }

    /// Tells where the axes are, where that is known and was not told.
    pub(super) fn tell_position(&mut self) {
        if let Some(position) = self.machine.moved_to(&self.settings) {
            self.event(Event::Position(position));
        }
    }

    /// A line that is none of grbl's.
    fn noise(&mut self, text: &str) {
        self.console(Direction::FromMachine, text);
        // While a board starts it may write what it likes, at whatever speed.
        if matches!(self.phase, Phase::Greeting(_)) {
            return;
        }
        self.garbled += 1;
        let what = format!("line {} that grbl does not write: '{text}'", self.garbled);
        let help = "see whether the USB cable is short, shielded, and away from motor cables";
        if self.garbled <= MOST_GARBLED {
            return self.event(Event::Warning(DriverError::new("garbled", what, help)));
        }
        self.garbled = 0;
        self.fail(DriverError::new("garbled", format!("too much noise on the line: {what}"), help));
    }

    /// Hands over what the machine has room for. Nothing while it holds.
    pub(super) fn feed(&mut self) {
        if matches!(&self.phase, Phase::Making(making) if making.hold != Hold::No) {
            return;
        }
        while let Some(line) = self.stream.next(self.now) {
            self.asking.outdated();
            self.console(Direction::ToMachine, &line);
            self.output.extend_from_slice(line.as_bytes());
            self.output.push(b'\n');
        }
    }

    /// Asks for a report when it is time to.
    fn ask(&mut self) {
        let busy = match &self.phase {
            Phase::Ready => false,
            Phase::Jogging { .. }
            | Phase::Making(_)
            | Phase::Halting { .. }
            | Phase::Reading(Reading::State { .. })
            | Phase::Resetting(Reset { greeted: true, .. }) => true,
            // The controller does not report while it looks for its switches.
            Phase::Homing { .. } if self.stream.is_over() => true,
            _ => return,
        };
        match self.asking.turn(self.now, busy, self.stream.is_over()) {
            Turn::Ask => self.output.push(b'?'),
            Turn::Wait => {}
            Turn::Silent => self.silent(),
        }
    }

    pub(super) fn event(&mut self, event: Event) {
        self.events.push_back(event);
    }

    fn console(&mut self, direction: Direction, text: &str) {
        self.event(Event::Console { direction, text: text.to_owned() });
    }

    /// Sends a byte that the controller takes out of the stream and acts on at once.
    pub(super) fn at_once(&mut self, byte: u8) {
        self.asking.outdated();
        self.console(Direction::ToMachine, &byte.escape_ascii().to_string());
        self.output.push(byte);
    }

    /// Forgets what was not handed to the port yet.
    pub(super) fn forget_output(&mut self) {
        self.output.clear();
    }

    /// Sends bytes that belong to no line that waits for its answer.
    pub(super) fn nudge(&mut self, bytes: &[u8]) {
        self.output.extend_from_slice(bytes);
    }
}
