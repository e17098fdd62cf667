//! The protocol without port and clock: bytes and time in, bytes and events out.

use std::collections::VecDeque;
use std::rc::Rc;
use std::time::Duration;

use wirebend_driver_api::{Direction, DriverError, Event};

use super::incoming::{Incoming, Line};
use super::interrupted::InterruptedStep;
use super::machine::Machine;
use super::phase::{Greeting, Phase, Reading, Reset};
use super::polling::{PollAction, StatusPoller};
use super::reply::Reply;
use super::speeds::SpeedOverride;
use super::status::{State, Status};
use super::stream::Stream;
use super::wire_run::Hold;
use crate::settings::Settings;

/// Garbled lines that one run may have: one or two are a disturbance, more are a bad cable.
const MAX_GARBLED: u32 = 5;

#[derive(Debug)]
pub(crate) struct Protocol {
    pub(super) settings: Rc<Settings>,
    pub(super) phase: Phase,
    pub(super) now: Duration,
    pub(super) incoming: Incoming,
    output: Vec<u8>,
    events: VecDeque<Event>,
    pub(super) stream: Stream,
    pub(super) poller: StatusPoller,
    pub(super) machine: Machine,
    pub(super) speed: SpeedOverride,
    pub(super) garbled: u32,
    /// The step that was interrupted, until the machine is at rest.
    pub(super) interrupted: Option<InterruptedStep>,
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
            poller: StatusPoller::default(),
            machine: Machine::default(),
            speed: SpeedOverride::default(),
            garbled: 0,
            interrupted: None,
        }
    }

    pub fn receive(&mut self, bytes: &[u8], now: Duration) {
        self.now = now;
        for line in self.incoming.lines(bytes) {
            match line {
                _ if self.is_closed() => return,
                Line::Text(text) => self.line(&text),
                Line::Garbled(text) => self.noise(&text),
            }
        }
        self.feed();
    }

    pub fn tick(&mut self, now: Duration) {
        self.now = now;
        match self.phase {
            Phase::Greeting(_) => self.greeting_late(),
            Phase::Reading(_) => self.reading_late(),
            Phase::Homing { since } => self.homing_late(since),
            Phase::Jogging { stopping: Some(since), .. } => self.jog_late(since),
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
    pub fn is_closed(&self) -> bool {
        matches!(self.phase, Phase::Closed)
    }

    /// Whether something moves or may move of what this program has asked for.
    pub fn is_moving(&self) -> bool {
        match &self.phase {
            Phase::Homing { .. }
            | Phase::Jogging { .. }
            | Phase::Cutting(_)
            | Phase::Halting { .. }
            | Phase::Resetting(_) => true,
            Phase::Running(run) => !run.is_armed_only(),
            Phase::Console(typed) => typed.may_move(),
            _ => false,
        }
    }

    fn line(&mut self, text: &str) {
        let reply = Reply::of(text);
        let old = matches!(&reply, Reply::Status(status) if self.machine.state == Some(status.state));
        if reply == Reply::Unknown {
            return self.noise(text);
        }
        if old {
            self.shows_report(text);
        } else {
            self.show(Direction::FromMachine, text);
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
        // Its answer is not awaited: it was sent before a reset.
        let Some(line) = self.stream.answered(self.now) else { return };
        match error {
            Some(code) => self.refused(code, &line),
            None if matches!(self.phase, Phase::Reading(_)) => self.read_on(),
            None if matches!(self.phase, Phase::Console(_)) => self.console_answered(),
            // The jog begins with this answer.
            None => self.cancel_jog(),
        }
    }

    fn report(&mut self, status: &Status) {
        let counts = self.poller.answered() && self.stream.is_empty();
        let state = status.state;
        let before = self.machine.state.replace(state);
        self.machine.reports(status);
        self.tell_position();
        self.report_speeds(status.speeds);
        let rests = counts && state == State::Idle;
        match &self.phase {
            Phase::Greeting(_) => self.found(),
            Phase::Reading(Reading::State { .. }) => self.connected(),
            Phase::Homing { .. } if rests => self.homed(),
            Phase::Jogging { .. } if rests => self.jogged(),
            Phase::Cutting(_) if rests => self.cut_rests(),
            Phase::Homing { .. } | Phase::Jogging { .. } | Phase::Cutting(_) | Phase::Running(_)
                if counts && state == State::Alarm =>
            {
                self.alarm(0);
            }
            Phase::Jogging { stopping: None, .. } | Phase::Cutting(_) => {
                self.jog_held(state);
                self.watch_answer(state);
            }
            Phase::Jogging { stopping: Some(_), .. } if state == State::Jog => self.cancel_jog(),
            &Phase::Console(typed) => self.console_reported(typed, state, counts),
            Phase::Running(_) => self.wire_reported(state, before, rests),
            Phase::Halting { .. } if counts => self.halted(state),
            Phase::Resetting(reset) if reset.greeted => self.settled(state),
            _ => {}
        }
        // After what the report leads to: a wire that ends with it has its speed restored.
        self.steer();
    }

    /// Reports where the axes are, where that is known and was not reported.
    pub(super) fn tell_position(&mut self) {
        if let Some(position) = self.machine.moved_to(&self.settings) {
            self.event(Event::Position(position));
        }
    }

    /// A line that is none of grbl's.
    fn noise(&mut self, text: &str) {
        self.show(Direction::FromMachine, text);
        // A boot loader may print anything, at any baud rate.
        if matches!(self.phase, Phase::Greeting(_)) {
            return;
        }
        self.garbled += 1;
        let what = format!("line {} that grbl does not write: '{text}'", self.garbled);
        let help = "see whether the USB cable is short, shielded, and away from motor cables";
        if self.garbled <= MAX_GARBLED {
            return self.event(Event::Warning(DriverError::new("garbled", what, help)));
        }
        self.garbled = 0;
        self.fail(DriverError::new("garbled", format!("too much noise on the line: {what}"), help));
    }

    /// Sends the lines that the machine has room for; none while it holds.
    pub(super) fn feed(&mut self) {
        if matches!(&self.phase, Phase::Running(run) if run.hold != Hold::No) {
            return;
        }
        while let Some(line) = self.stream.next(self.now) {
            self.poller.outdated();
            self.show(Direction::ToMachine, &line);
            self.output.extend_from_slice(line.as_bytes());
            self.output.push(b'\n');
        }
    }

    /// Asks for a report when it is time to.
    fn ask(&mut self) {
        let busy = match &self.phase {
            Phase::Ready => false,
            Phase::Jogging { .. }
            | Phase::Cutting(_)
            | Phase::Running(_)
            | Phase::Console(_)
            | Phase::Halting { .. }
            | Phase::Reading(Reading::State { .. })
            | Phase::Resetting(Reset { greeted: true, .. }) => true,
            // grbl sends no reports while it homes.
            Phase::Homing { .. } if self.stream.is_empty() => true,
            _ => return,
        };
        match self.poller.next_action(self.now, busy, self.stream.is_empty()) {
            PollAction::Ask => self.output.push(b'?'),
            PollAction::Wait => {}
            PollAction::Silent => self.silent(),
        }
    }

    pub(super) fn event(&mut self, event: Event) {
        self.events.push_back(event);
    }

    pub(super) fn show(&mut self, direction: Direction, text: &str) {
        self.event(Event::Console { direction, text: text.to_owned() });
    }

    /// Sends a real-time command, which grbl executes at once.
    pub(super) fn send_realtime(&mut self, byte: u8) {
        self.poller.outdated();
        self.show(Direction::ToMachine, &byte.escape_ascii().to_string());
        self.output.push(byte);
    }

    /// Discards bytes that were not written to the port yet.
    pub(super) fn discard_output(&mut self) {
        self.output.clear();
    }

    /// Sends bytes whose answer is not awaited.
    pub(super) fn send_raw(&mut self, bytes: &[u8]) {
        self.output.extend_from_slice(bytes);
    }
}
