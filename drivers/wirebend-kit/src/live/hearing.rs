//! What is heard of the machine, and what follows from it.

use std::time::Duration;

use wirebend_driver_api::{DoneBy, Event, GoingOn, HeadBy, Limits, PausedBy, ReferenceBy, SettingCheck};

use super::fault;
use super::machine::{Counts, Doing, Halt, Homing, Machine};
use super::wire::Wire;
use crate::limits;
use crate::link::{Ask, News};
use crate::protocol::{Alarm, Refusal, State, Status, VERSION, Versions};
use crate::settings::{Difference, differences};

impl Machine {
    /// Takes what has come.
    pub fn advance(&mut self, bytes: &[u8], now: Duration) {
        self.console.hear(bytes, &mut self.events);
        self.link.advance(bytes, now);
        for news in self.link.take_news() {
            self.hear(news, now);
        }
        if self.ending.as_ref().is_some_and(|ending| ending.until <= now) {
            self.tell_end();
        }
        self.conclude();
    }

    fn hear(&mut self, news: News, now: Duration) {
        match news {
            News::Open { going_on, fresh } => self.opened(going_on, fresh),
            News::Boot(_) | News::SessionLost => self.restarted(),
            News::Accepted(n) => {
                if let Doing::Homing(Homing::Searching { line, accepted }) = &mut self.doing {
                    *accepted |= n >= *line;
                }
            }
            News::Done(n) => self.done(n),
            News::Status(status) => self.stands(status),
            News::Answered(Ask::Head(_)) => {
                self.head = Counts::Itself;
                if self.doing == Doing::Homing(Homing::Placing) {
                    self.search();
                }
            }
            News::Answered(Ask::Write(id, _)) => drop(self.unwritten.remove(&id)),
            News::Answered(_) => {}
            News::Setting { id, value } => {
                let index = usize::from(id).wrapping_sub(1);
                self.read.get_mut(index).into_iter().for_each(|read| *read = Some(value));
            }
            // In the first of two rounds it may be.
            News::Refused { error, ask: Some(Ask::Write(id, value)), .. } => {
                self.unwritten.insert(id, (value, error));
            }
            News::Refused { command, error, .. } => self.refused(command, error, now),
            News::Alarm(alarm) => self.alarmed(alarm, now),
            News::Silent => self.lose(fault::silent(self.doing == Doing::Connecting)),
        }
    }

    fn opened(&mut self, going_on: Option<(u32, u32)>, fresh: Option<(Versions, u32)>) {
        if let Some((versions, boots)) = fresh {
            (self.versions, self.boots) = (Some(versions), boots);
            if versions.protocol != VERSION {
                return self.lose(fault::other_version(versions));
            }
            if versions.machine != self.built_for {
                return self.lose(fault::other_machine(versions.machine, self.built_for));
            }
        }
        match self.doing {
            Doing::Connecting => {
                match (going_on, self.token) {
                    (Some((last, done)), Some(token)) => {
                        (self.boots, self.head) = (token.boots, Counts::Kept);
                        self.wire = Some(Wire::going_on(token, last, done));
                    }
                    // It may have started while nobody was there to hear it.
                    (_, token) => {
                        self.head = self.head.since(token.map(|token| token.boots == self.boots));
                        self.token = None;
                    }
                }
                self.read_settings();
            }
            Doing::Homing(Homing::Opening) => match self.head_at.take() {
                Some(steps) => {
                    self.link.ask(Ask::Head(steps));
                    self.doing = Doing::Homing(Homing::Placing);
                }
                None => self.search(),
            },
            _ => {}
        }
    }

    fn search(&mut self) {
        let line = self.link.line(b'H', &[]);
        self.doing = Doing::Homing(Homing::Searching { line, accepted: false });
    }

    /// The controller counts the head from where it was when it started; the program from the wire's start.
    fn place_head(&mut self, status: Status) {
        let Some(wire) = self.wire.as_mut().filter(|wire| !wire.placed) else { return };
        wire.placed = true;
        wire.begins_at(status.position[0]);
        if self.head == Counts::Lost {
            self.link.ask(Ask::Head(wire.rotate_at));
        } else {
            wire.turn = wire.rotate_at - status.position[1];
        }
    }

    fn done(&mut self, n: u32) {
        match self.doing {
            Doing::Homing(Homing::Searching { line, .. }) if n >= line => {
                self.doing = Doing::Homing(Homing::Asking);
            }
            Doing::Homing(Homing::Returning { line }) if n >= line => self.homed(),
            Doing::Jogging(line) if n >= line => {
                self.doing = Doing::Nothing;
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
        (self.doing, self.homed) = (Doing::Nothing, true);
        self.report(Event::Homed);
    }

    fn stands(&mut self, status: Status) {
        let first = self.status.replace(status).is_none();
        // It stands: no step is made after an alarm.
        if self.ending.is_some() && status.state == State::Alarm {
            self.told = None;
            self.tell_position(status);
            self.tell_part(status);
            self.tell_end();
        }
        if self.doing == Doing::Homing(Homing::Asking) {
            let back = -status.position[1];
            if back == 0 {
                return self.homed();
            }
            let line = self.link.line(b'M', &[0, back, 0]);
            self.doing = Doing::Homing(Homing::Returning { line });
        }
        // One of before may tell of a head that was on its way.
        if self.doing == Doing::Arming && self.link.session().is_some() {
            self.place_head(status);
        }
        if self.doing == Doing::Connecting || first {
            return;
        }
        self.tell_position(status);
        self.tell_hold(status);
        self.tell_release(status);
    }

    /// At rest it has let its motors go, and does not know any more where its axes are.
    fn tell_release(&mut self, status: Status) {
        if self.homed && !status.homed && status.state == State::Idle && self.doing == Doing::Nothing {
            self.give_up();
            self.report(Event::Warning(fault::released()));
            self.report(Event::Stopped { homed: false });
        }
    }

    fn tell_position(&mut self, status: Status) {
        if self.told == Some(status.position) {
            return;
        }
        self.told = Some(status.position);
        self.report(Event::Position(self.in_units(status.position)));
    }

    fn tell_hold(&mut self, status: Status) {
        let held = status.state == State::Held;
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
        // A stop ends a hold without going on.
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

    /// The controller has started anew, or is in nobody's session.
    fn restarted(&mut self) {
        self.tell_end();
        self.head = Counts::Lost;
        // What it was busy with is over.
        self.status = None;
        if self.doing == Doing::Connecting {
            return;
        }
        let in_doubt = self.in_doubt();
        self.give_up();
        self.report(Event::Fault { error: fault::restarted(), in_doubt, disconnected: false });
    }

    fn refused(&mut self, command: u8, error: Refusal, now: Duration) {
        match (command, self.doing) {
            // Told with the settings.
            (b'C', _) if error == Refusal::Settings => {}
            // It holds on.
            (b'G', _) if error == Refusal::HoldInput => self.report(Event::Warning(fault::hold_input())),
            // It has fewer settings than this driver knows.
            (b'C', Doing::Connecting) if error == Refusal::Unknown => {
                self.lose(fault::older_firmware(self.versions));
            }
            (b'S', Doing::Homing(Homing::Opening)) if error == Refusal::NotIdle => {
                self.link.stop(now);
                self.doing = Doing::Homing(Homing::Stopping);
            }
            (b'S', Doing::Connecting) if error == Refusal::NotIdle => self.lose(fault::other_host()),
            _ => {
                let homing = matches!(self.doing, Doing::Homing(_));
                self.give_up();
                let error = fault::refused(command, error, homing);
                // It makes on what it has.
                self.report(Event::Fault { error, in_doubt: None, disconnected: false });
            }
        }
    }

    /// Whether the port is of no use any more.
    pub fn is_over(&self) -> bool {
        self.doing == Doing::Over
    }

    fn conclude(&mut self) {
        let read = self.link.session().is_some() && self.link.is_answered();
        match self.doing {
            Doing::Connecting if read && self.halt == Halt::No => {
                if let Some(status) = self.status {
                    self.connected(status);
                }
            }
            Doing::Writing if read => {
                self.doing = Doing::Nothing;
                for (id, (value, error)) in std::mem::take(&mut self.unwritten) {
                    self.report(Event::Warning(fault::not_stored(id, value, error)));
                }
                let settings = self.checks();
                self.report(Event::SettingsWritten { settings, limits: self.limits() });
            }
            Doing::Arming if read && self.wire.as_ref().is_some_and(|wire| wire.placed) => {
                self.head = Counts::Itself;
                self.doing = Doing::Making;
            }
            _ => {}
        }
    }

    fn connected(&mut self, status: Status) {
        self.doing = Doing::Nothing;
        if status.state == State::Alarm {
            // What was not made of the wire is forgotten.
            (self.wire, self.token) = (None, None);
        }
        self.homed = status.homed && self.token.is_some();
        let going_on = self.wire.as_ref().map(|wire| GoingOn { accepted: wire.given, done: wire.done });
        let event = Event::Connected {
            identity: fault::identity(self.versions),
            settings: self.checks(),
            homed: self.homed,
            going_on,
            reference: ReferenceBy::Machine,
            done_by: DoneBy::Machine,
            // Its switch is that of the bend axis alone.
            head: if self.head == Counts::Kept { HeadBy::Kept } else { HeadBy::Program },
            limits: self.limits(),
        };
        self.report(event);
        if status.state == State::Alarm {
            self.report(Event::Warning(fault::alarm(status.alarm)));
            self.halt = Halt::Told(status.alarm);
        }
        self.tell_position(status);
        self.tell_hold(status);
    }

    fn checks(&self) -> Vec<SettingCheck> {
        if self.read.contains(&None) {
            return vec![fault::settings_damaged()];
        }
        let read = self.read.map(Option::unwrap_or_default);
        differences(&self.settings, &read).into_iter().map(Difference::told).collect()
    }

    /// What the board itself holds steps against.
    fn limits(&self) -> Limits {
        // One that cannot read its settings moves nothing.
        self.read
            .iter()
            .copied()
            .collect::<Option<Vec<i32>>>()
            .map(|read| limits::of_board(&read))
            .unwrap_or_default()
    }

    /// Whether the last step of the wire is made.
    pub fn has_made(&self) -> bool {
        self.doing == Doing::Making && self.wire.as_ref().is_some_and(Wire::is_made)
    }

    /// Ends what is over.
    pub fn settle(&mut self) {
        if self.has_made() {
            (self.doing, self.wire) = (Doing::Nothing, None);
            self.report(Event::Finished);
        }
    }
}
