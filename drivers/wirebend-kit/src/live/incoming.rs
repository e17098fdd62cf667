//! Frames from the controller, and the events that follow from them.

use std::time::Duration;

use wirebend_driver_api::{DoneBy, Event, HeadBy, Limits, PausedBy, ReferenceBy, ResumeState, SettingCheck};

use super::calls::BEFORE_ZERO_SINCE;
use super::fault;
use super::machine::{Activity, FASTEST, Halt, HeadReference, Homing, Machine};
use super::wire_progress::WireProgress;
use crate::limits;
use crate::link::{MachineEvent, Request};
use crate::protocol::{Alarm, Refusal, State, Status, VERSION, Versions};
use crate::settings::{Difference, differences};

impl Machine {
    /// Handles received bytes.
    pub fn advance(&mut self, bytes: &[u8], now: Duration) {
        self.console.hear(bytes, &mut self.events);
        self.link.advance(bytes, now);
        for event in self.link.take_events() {
            self.hear(event, now);
        }
        if self.ending.as_ref().is_some_and(|ending| ending.until <= now) {
            self.report_ending();
        }
        self.conclude();
    }

    fn hear(&mut self, event: MachineEvent, now: Duration) {
        match event {
            MachineEvent::Open { resumed, fresh } => self.opened(resumed, fresh),
            MachineEvent::Boot(_) | MachineEvent::SessionLost => self.restarted(),
            MachineEvent::Accepted(n) => {
                if let Activity::Homing(Homing::Searching { line, accepted }) = &mut self.activity {
                    *accepted |= n >= *line;
                }
            }
            MachineEvent::Done(n) => self.done(n, now),
            MachineEvent::Status(status) => self.stands(status),
            MachineEvent::Answered(Request::Head(_)) => {
                self.head = HeadReference::Unknown;
                if self.activity == Activity::Homing(Homing::SettingHead) {
                    self.search();
                }
            }
            MachineEvent::Answered(Request::Write(id, _)) => drop(self.unwritten.remove(&id)),
            MachineEvent::Speed(percent) => self.speed_changed(percent),
            MachineEvent::Answered(_) => {}
            MachineEvent::Setting { id, value } => {
                let index = usize::from(id).wrapping_sub(1);
                self.read.get_mut(index).into_iter().for_each(|read| *read = Some(value));
            }
            // In the first of two rounds it may be.
            MachineEvent::Refused { error, ask: Some(Request::Write(id, value)), .. } => {
                self.unwritten.insert(id, (value, error));
            }
            MachineEvent::Refused { command, error, .. } => self.refused(command, error, now),
            MachineEvent::Alarm(alarm) => self.alarmed(alarm, now),
            MachineEvent::Silent => self.lose(fault::silent(self.activity == Activity::Connecting)),
        }
    }

    /// The speed override.
    pub(super) fn speed_changed(&mut self, percent: u8) {
        if std::mem::replace(&mut self.speed, percent) != percent {
            self.report(Event::Speed { percent });
        }
    }

    fn opened(&mut self, resumed: Option<(u32, u32)>, fresh: Option<(Versions, u32)>) {
        if let Some((versions, boots)) = fresh {
            (self.versions, self.boots) = (Some(versions), boots);
            if versions.protocol != VERSION {
                return self.lose(fault::other_version(versions));
            }
            if versions.machine != self.built_for {
                return self.lose(fault::other_machine(versions.machine, self.built_for));
            }
        }
        match self.activity {
            Activity::Connecting => {
                match (resumed, self.token) {
                    (Some((last, done)), Some(token)) => {
                        (self.boots, self.head) = (token.boots, HeadReference::Kept);
                        self.wire = Some(WireProgress::resumed(token, last, done));
                        // It may be bent more slowly since before.
                        self.link.request(Request::Speed(0));
                    }
                    // It may have started while no program was there to hear it.
                    (_, token) => {
                        self.head = self.head.since(token.map(|token| token.boots == self.boots));
                        self.token = None;
                    }
                }
                self.read_settings();
            }
            // The alarm of a stop that was sent meanwhile is on its way, and ends it.
            Activity::Homing(Homing::Opening) if self.halt == Halt::Requested => {}
            Activity::Homing(Homing::Opening) => match self.head_at.take() {
                Some(steps) => {
                    self.link.request(Request::Head(steps));
                    self.activity = Activity::Homing(Homing::SettingHead);
                }
                None => self.search(),
            },
            _ => {}
        }
    }

    fn search(&mut self) {
        // Homing clears the alarm of a stop.
        if self.halt == Halt::Requested {
            return;
        }
        let line = self.link.line(b'H', &[]);
        self.activity = Activity::Homing(Homing::Searching { line, accepted: false });
    }

    /// The controller counts the head from where it was at its reset, the program from the start of the wire.
    fn place_head(&mut self, status: Status) {
        let Some(wire) = self.wire.as_mut().filter(|wire| !wire.placed) else { return };
        wire.placed = true;
        wire.begins_at(status.position[0]);
        if self.head == HeadReference::Lost {
            self.link.request(Request::Head(wire.rotate_at));
        } else {
            wire.turn = wire.rotate_at - status.position[1];
        }
    }

    fn done(&mut self, n: u32, now: Duration) {
        match self.activity {
            Activity::Homing(Homing::Searching { line, .. }) if n >= line => {
                self.activity = Activity::Homing(Homing::ReadingHead);
            }
            Activity::Homing(Homing::Returning { line }) if n >= line => self.homed(),
            Activity::Turning { line, session } if n >= line => {
                let wanted = self.wanted_speed;
                self.open_for_wire(session, now);
                if wanted != FASTEST {
                    // It was set while the head turned.
                    self.wanted_speed = wanted;
                    self.link.request(Request::Speed(wanted));
                }
            }
            Activity::Jogging(line) if n >= line => {
                self.activity = Activity::Idle;
                self.report(Event::Jogged);
            }
            _ => {
                let done = self.wire.as_mut().map(|wire| wire.made(n)).into_iter().flatten();
                let events: Vec<Event> = done.map(|n| Event::Done { n }).collect();
                self.events.extend(events);
            }
        }
    }

    fn homed(&mut self) {
        (self.activity, self.homed) = (Activity::Idle, true);
        self.report(Event::Homed);
    }

    fn stands(&mut self, status: Status) {
        let first = self.status.replace(status).is_none();
        // At rest: no step runs after an alarm.
        if self.ending.is_some() && status.state == State::Alarm {
            self.told = None;
            self.report_position(status);
            self.report_part(status);
            self.report_ending();
        }
        if self.activity == Activity::Homing(Homing::ReadingHead) {
            let back = -status.position[1];
            if back == 0 {
                return self.homed();
            }
            let line = self.link.line(b'M', &[0, back, 0]);
            self.activity = Activity::Homing(Homing::Returning { line });
        }
        if let Activity::ToTurn { at, .. } = &mut self.activity {
            at.get_or_insert(status.position[1]);
        }
        // One of before may report a head that was on its way.
        if self.activity == Activity::Arming && self.link.session().is_some() {
            self.place_head(status);
        }
        if self.activity == Activity::Connecting || first {
            return;
        }
        self.report_position(status);
        self.report_hold(status);
        self.report_release(status);
    }

    /// The controller has released its motors when idle, so the position of its axes is unknown.
    fn report_release(&mut self, status: Status) {
        if self.homed && !status.homed && status.state == State::Idle && self.activity == Activity::Idle {
            self.give_up();
            self.report(Event::Warning(fault::released()));
            self.report(Event::Stopped { homed: false });
        }
    }

    fn report_position(&mut self, status: Status) {
        if self.told == Some(status.position) {
            return;
        }
        self.told = Some(status.position);
        self.report(Event::Position(self.in_units(status.position)));
    }

    fn report_hold(&mut self, status: Status) {
        let held = status.state == State::Hold;
        if held == self.held {
            return;
        }
        self.held = held;
        let silence = status.alarm == Alarm::HostLost;
        let input = status.alarm == Alarm::HoldInput;
        if held && silence {
            self.report(Event::Warning(fault::host_lost()));
        }
        if held && input {
            self.report(Event::Warning(fault::hold_input()));
        }
        // A stop ends a hold without a resume.
        if held {
            let by = match status.alarm {
                Alarm::HostLost => PausedBy::Silence,
                Alarm::HoldInput => PausedBy::Machine,
                _ => PausedBy::Program,
            };
            self.report(Event::Paused { by });
        } else if status.state != State::Alarm {
            self.report(Event::Resumed);
        }
    }

    /// The controller was reset, or is in no session.
    fn restarted(&mut self) {
        self.report_ending();
        self.head = HeadReference::Lost;
        // What it was busy with is over.
        self.status = None;
        if self.activity == Activity::Connecting {
            return;
        }
        let in_doubt = self.in_doubt();
        self.give_up();
        self.report(Event::Fault { error: fault::restarted(), in_doubt, disconnected: false });
    }

    fn refused(&mut self, command: u8, error: Refusal, now: Duration) {
        match (command, self.activity) {
            // That is its answer.
            (_, Activity::Typing(_)) => self.report(Event::Warning(fault::refused(command, error, false))),
            // Reported with the settings.
            (b'C', _) if error == Refusal::Settings => {}
            // It holds on.
            (b'G', _) if error == Refusal::HoldInput => self.report(Event::Warning(fault::hold_input())),
            // That of an older firmware cannot be changed.
            (b'U', Activity::Connecting) => {}
            // It goes on as fast as before.
            (b'U', _) => self.report(Event::Warning(fault::refused(command, error, false))),
            // It has fewer settings than this driver knows.
            (b'C', Activity::Connecting) if error == Refusal::Unknown => {
                self.lose(fault::older_firmware(self.versions));
            }
            (b'S', Activity::Homing(Homing::Opening)) if error == Refusal::NotIdle => {
                self.link.stop(now);
                self.activity = Activity::Homing(Homing::Stopping);
            }
            (b'S', Activity::Connecting) if error == Refusal::NotIdle => self.lose(fault::other_host()),
            _ => {
                let homing = matches!(self.activity, Activity::Homing(_));
                self.give_up();
                let error = fault::refused(command, error, homing);
                // It continues with what it has.
                self.report(Event::Fault { error, in_doubt: None, disconnected: false });
            }
        }
    }

    /// Whether the port is of no use any more.
    pub fn is_closed(&self) -> bool {
        self.activity == Activity::Closed
    }

    fn conclude(&mut self) {
        let read = self.link.session().is_some() && self.link.is_answered();
        match self.activity {
            Activity::Connecting if read && self.halt == Halt::No => {
                if let Some(status) = self.status {
                    self.connected(status);
                }
            }
            Activity::StoringSettings if read => {
                self.activity = Activity::Idle;
                self.report_stored();
            }
            Activity::Typing(typed) if read => self.answered(typed),
            Activity::Arming if read && self.wire.as_ref().is_some_and(|wire| wire.placed) => {
                self.head = HeadReference::Unknown;
                self.activity = Activity::Running;
            }
            _ => {}
        }
    }

    /// The settings were read again after some were written.
    pub(super) fn report_stored(&mut self) {
        for (id, (value, error)) in std::mem::take(&mut self.unwritten) {
            self.report(Event::Warning(fault::not_stored(id, value, error)));
        }
        let settings = self.checks();
        self.report(Event::SettingsWritten { settings, limits: self.limits() });
    }

    fn connected(&mut self, status: Status) {
        self.activity = Activity::Idle;
        if status.state == State::Alarm {
            // What was not bent of the wire is forgotten.
            (self.wire, self.token) = (None, None);
        }
        self.homed = status.homed && self.token.is_some();
        let resume = self.wire.as_ref().map(|wire| ResumeState { accepted: wire.given, done: wire.done });
        let event = Event::Connected {
            identity: fault::identity(self.versions),
            settings: self.checks(),
            homed: self.homed,
            resume,
            reference: ReferenceBy::Machine,
            done_by: DoneBy::Machine,
            // Its switch is that of the bend axis alone.
            head: if self.head == HeadReference::Kept { HeadBy::Kept } else { HeadBy::Program },
            limits: self.limits(),
        };
        self.report(event);
        if status.state == State::Alarm {
            self.report(Event::Warning(fault::alarm(status.alarm)));
            self.halt = Halt::Reported(status.alarm);
        }
        self.report_position(status);
        self.report_hold(status);
    }

    fn checks(&self) -> Vec<SettingCheck> {
        if self.read.contains(&None) {
            return vec![fault::settings_damaged()];
        }
        let read = self.read.map(Option::unwrap_or_default);
        differences(&self.settings, &read).into_iter().map(Difference::told).collect()
    }

    /// The limits that the board checks.
    fn limits(&self) -> Limits {
        // A board with damaged settings does not move.
        let read = self.read.iter().copied().collect::<Option<Vec<i32>>>();
        let limits = read.map(|read| limits::of_board(&read)).unwrap_or_default();
        let older = self.versions.filter(|versions| versions.firmware < BEFORE_ZERO_SINCE);
        Limits { lacks: older.map(fault::lacks_before_zero).into_iter().collect(), ..limits }
    }

    /// Whether the last step of the wire is done.
    pub fn has_finished(&self) -> bool {
        self.activity == Activity::Running && self.wire.as_ref().is_some_and(WireProgress::is_finished)
    }

    /// Ends the wire when its last step is done.
    pub fn settle(&mut self) {
        if self.has_finished() {
            (self.activity, self.wire) = (Activity::Idle, None);
            // The answer to what was asked for last may still be on its way.
            if self.speed != FASTEST || self.wanted_speed != FASTEST {
                self.wanted_speed = FASTEST;
                self.link.request(Request::Speed(FASTEST));
            }
            self.report(Event::Finished);
        }
    }
}

#[cfg(test)]
mod tests;
