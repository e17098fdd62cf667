//! The end of a call or a connection: done, refused, alarm, stop, no answer, unplugged.

use std::time::Duration;

use wirebend_driver_api::{DriverError, Event, PausedBy};

use super::interrupted::StoppedBy;
use super::phase::{Phase, Reset};
use super::protocol::Protocol;
use super::status::State;
use super::wire_run::Stage;
use crate::codes;

const RESET: u8 = 0x18;
const HOLD: u8 = b'!';
const JOG_CANCEL: u8 = 0x85;
/// A homing cycle of long axes at grbl's default rates takes half a minute.
const HOME_WITHIN: Duration = Duration::from_mins(1);
/// A jog that has been given up stops within a few tenths of a second.
const JOG_ENDS_WITHIN: Duration = Duration::from_secs(1);
/// A feed hold at grbl's default acceleration takes about one second.
const HALT_WITHIN: Duration = Duration::from_secs(2);
/// A reset takes a few ms; after an alarm the controller does nothing for half a second first
/// (`report_alarm_message` in `report.c`).
const GREET_WITHIN: Duration = Duration::from_secs(1);
const MAX_RESETS: u32 = 4;
/// A greeting so soon after a reset was asked for is the answer to it, though another came first.
const ECHO: Duration = Duration::from_secs(2);

impl Protocol {
    /// Homing is done.
    pub(super) fn homed(&mut self) {
        self.phase = Phase::Ready;
        self.machine.set_homed();
        self.event(Event::Homed);
        // Positions count from the new zero now.
        self.tell_position();
    }

    pub(super) fn homing_late(&mut self, since: Duration) {
        if self.now.saturating_sub(since) >= HOME_WITHIN {
            let what = "homing has not ended within a minute";
            self.fault(DriverError::new(
                "homing",
                what,
                "raise $24 and $25, or see whether a switch is missed",
            ));
            self.reset(false);
        }
    }

    pub(super) fn jogged(&mut self) {
        if let Phase::Jogging { stopping: None, row } = &mut self.phase
            && let Err(error) = row.arrived(&self.machine, &self.settings)
        {
            // A report may have been damaged itself: wait for the next one.
            if std::mem::replace(&mut row.displaced, true) {
                (self.phase, self.machine.homed) = (Phase::Ready, false);
                self.fault(error);
            }
            return;
        }
        if self.row_on() {
            return;
        }
        let stopping = matches!(self.phase, Phase::Jogging { stopping: Some(_), .. });
        self.phase = Phase::Ready;
        self.event(if stopping { Event::Stopped { homed: self.machine.homed } } else { Event::Jogged });
    }

    /// A feed hold between the parts of a jog, or an open door: it does not end by itself.
    pub(super) fn jog_held(&mut self, state: State) {
        let (Phase::Jogging { row, .. } | Phase::Cutting(row)) = &mut self.phase else { return };
        let holds = matches!(state, State::Hold { at_rest: true } | State::Door { at_rest: true });
        if holds && !std::mem::replace(&mut row.held, true) {
            self.event(Event::Paused { by: PausedBy::Machine });
        }
    }

    /// Sends the next part of a jog or of a cut, if there is one.
    pub(super) fn row_on(&mut self) -> bool {
        let (Phase::Jogging { row, .. } | Phase::Cutting(row)) = &mut self.phase else { return false };
        let Some(lines) = row.next() else { return false };
        self.stream.take(lines);
        self.poller.outdated();
        self.feed();
        true
    }

    /// grbl accepts this only while it jogs (`serial.c`), and ignores it before it has taken the line of the jog. So it is
    /// sent again until the jog has stopped.
    pub(super) fn cancel_jog(&mut self) {
        if matches!(self.phase, Phase::Jogging { stopping: Some(_), .. }) {
            self.send_realtime(JOG_CANCEL);
        }
    }

    pub(super) fn jog_late(&mut self, since: Duration) {
        if self.now.saturating_sub(since) >= JOG_ENDS_WITHIN {
            self.reset(true);
        }
    }

    pub(super) fn refused(&mut self, code: u32, line: &str) {
        let (meaning, help) = codes::error(code);
        let name = if code == 0 { "error".to_owned() } else { format!("error {code}") };
        let what = format!("the machine refuses the line '{line}' with {name}: {meaning}");
        let error = DriverError::new(&format!("grbl-error-{code}"), what, help);
        match self.phase {
            Phase::Reading(_) => self.question_refused(error),
            Phase::Console(_) => self.console_refused(code, line),
            // Nothing moves, and the lines behind it make no sense without it.
            Phase::Homing { .. } | Phase::Jogging { stopping: None, .. } => {
                self.fault(error);
                self.stream.clear();
                self.phase = Phase::Ready;
            }
            _ => self.fail(error),
        }
    }

    /// Ends the run: reports the fault at once, then decelerates and resets the machine, which empties its buffers.
    pub(super) fn fail(&mut self, error: DriverError) {
        match self.phase {
            Phase::Greeting(_) | Phase::Reading(_) => self.close(error),
            Phase::Ready => self.fault(error),
            // The first reason is the one that counts.
            Phase::Halting { .. } | Phase::Resetting(_) | Phase::NotResponding | Phase::Closed => {}
            Phase::Homing { .. }
            | Phase::Jogging { .. }
            | Phase::Cutting(_)
            | Phase::Console(_)
            | Phase::Running(_) => {
                self.fault(error);
                // What it has done of the lines may not be what it was sent: a position says nothing of the wire then.
                self.interrupt(StoppedBy::Fault);
                self.stream.clear();
                self.send_realtime(HOLD);
                self.phase = Phase::Halting { since: self.now };
            }
        }
    }

    /// A status report after the feed hold.
    pub(super) fn halted(&mut self, state: State) {
        let moving = matches!(
            state,
            State::Run
                | State::Jog
                | State::Home
                | State::Hold { at_rest: false }
                | State::Door { at_rest: false }
        );
        if !moving {
            self.reset(false);
        }
    }

    pub(super) fn halting_late(&mut self, since: Duration) {
        if self.now.saturating_sub(since) >= HALT_WITHIN {
            self.reset(false);
        }
    }

    /// `ALARM:`, or 0 for an alarm that only a status report shows.
    pub(super) fn alarm(&mut self, code: u32) {
        // Alarm 2 comes before anything moves; all others may have lost steps.
        if code != 2 {
            self.machine.homed = false;
        }
        self.machine.state = Some(State::Alarm);
        match self.phase {
            Phase::Ready
            | Phase::Homing { .. }
            | Phase::Jogging { .. }
            | Phase::Cutting(_)
            | Phase::Console(_)
            | Phase::Running(_) => {}
            Phase::Halting { .. } => return self.reset(false),
            _ => return,
        }
        let (meaning, help) = codes::alarm(code);
        let (name, meaning) =
            if code == 0 { (String::new(), "the machine is locked") } else { (format!(" {code}"), meaning) };
        let what = format!("alarm{name}: {meaning}");
        self.fault(DriverError::new(&format!("grbl-alarm-{code}"), what, help));
        self.interrupt(StoppedBy::Fault);
        if matches!(code, 3 | 6..=9) {
            // The controller resets by itself now. Another reset would be greeted a second time.
            self.stream.clear();
            self.phase = Phase::Resetting(Reset { stop: false, since: self.now, tries: 0, greeted: false });
        } else {
            self.reset(false);
        }
    }

    /// Stops the machine at once with a soft reset. In motion it loses steps and raises an alarm.
    pub(super) fn reset(&mut self, stop: bool) {
        self.in_doubt();
        if self.interrupted.is_none() {
            self.interrupt(StoppedBy::Reset);
        }
        let stop = stop || matches!(self.phase, Phase::Resetting(Reset { stop: true, .. }));
        self.stream.clear();
        self.discard_output();
        self.send_realtime(RESET);
        self.machine.reset_at = Some(self.now);
        self.phase = Phase::Resetting(Reset { stop, since: self.now, tries: 1, greeted: false });
    }

    /// After a limit the controller waits for a reset, and has forgotten those that came before it said so
    /// (`EXEC_ALARM_HARD_LIMIT` in `protocol.c`).
    pub(super) fn waits_for_reset(&mut self) {
        if let Phase::Resetting(reset) = &mut self.phase
            && !reset.greeted
        {
            reset.since = self.now;
            self.machine.reset_at = Some(self.now);
            self.send_realtime(RESET);
        }
    }

    pub(super) fn reset_late(&mut self) {
        let Phase::Resetting(reset) = &mut self.phase else { return };
        if reset.greeted || self.now.saturating_sub(reset.since) < GREET_WITHIN {
            return;
        }
        if reset.tries < MAX_RESETS {
            (reset.tries, reset.since) = (reset.tries + 1, self.now);
            self.machine.reset_at = Some(self.now);
            return self.send_realtime(RESET);
        }
        self.machine.homed = false;
        self.fault(DriverError::new(
            "no-stop",
            format!("the machine has not answered {MAX_RESETS} resets; it may still be moving"),
            "cut its power",
        ));
        self.phase = Phase::NotResponding;
    }

    pub(super) fn greeted(&mut self, name: &str) {
        let late = self.machine.reset_at.is_some_and(|at| self.now.saturating_sub(at) <= ECHO);
        self.speed.was_reset();
        let stop = match self.phase {
            Phase::Greeting(_) | Phase::Reading(_) => {
                self.machine.has_greeted();
                return self.greeted_first(name);
            }
            Phase::Closed => return,
            Phase::Resetting(reset) => {
                self.machine.was_reset(true);
                reset.stop
            }
            Phase::Halting { .. } | Phase::NotResponding => {
                self.machine.was_reset(false);
                self.machine.homed = false;
                false
            }
            Phase::Ready if late => {
                self.machine.was_reset(true);
                return self.poller.restart();
            }
            Phase::Ready
            | Phase::Homing { .. }
            | Phase::Jogging { .. }
            | Phase::Cutting(_)
            | Phase::Console(_)
            | Phase::Running(_) => {
                self.machine.was_reset(false);
                self.machine.homed = false;
                self.fault(DriverError::new(
                    "controller-reset",
                    "the controller has started anew, and no reset was sent",
                    "see whether its reset button was pressed, whether its power is strong enough, and whether \
                     motors disturb it; then home the machine",
                ));
                self.interrupt(StoppedBy::Fault);
                false
            }
        };
        self.stream.clear();
        self.poller.restart();
        self.phase = Phase::Resetting(Reset { stop, since: self.now, tries: 0, greeted: true });
    }

    /// The first report after a greeting.
    pub(super) fn settled(&mut self, state: State) {
        let Phase::Resetting(reset) = self.phase else { return };
        self.machine.homed &= state == State::Idle;
        self.phase = Phase::Ready;
        self.report_interrupted();
        if reset.stop {
            self.event(Event::Stopped { homed: self.machine.homed });
        }
    }

    /// The machine does not answer questions any more.
    pub(super) fn silent(&mut self) {
        let stopped = matches!(self.phase, Phase::Resetting(Reset { stop: true, greeted: true, .. }));
        let moving = !matches!(self.phase, Phase::Ready | Phase::Resetting(_));
        self.machine.homed = false;
        if stopped {
            self.event(Event::Stopped { homed: false });
        }
        self.fault(DriverError::new(
            "silent",
            "the machine has left three questions unanswered",
            "see whether it has power; cut it if something still moves, then connect again",
        ));
        if moving {
            self.reset(false);
        } else {
            self.phase = Phase::NotResponding;
        }
    }

    /// The port is gone.
    pub fn unplugged(&mut self, now: Duration) {
        self.now = now;
        if self.is_closed() {
            return;
        }
        let what = "the port is gone: the machine was unplugged or switched off";
        self.close(DriverError::new(
            "unplugged",
            what,
            "a controller that still has power continues with what it was sent: cut its power, then connect again",
        ));
    }

    /// A fault that leaves the port open.
    fn fault(&mut self, error: DriverError) {
        let in_doubt = self.in_doubt();
        self.event(Event::Fault { error, in_doubt, disconnected: false });
    }

    /// A fault that ends the connection.
    pub(super) fn close(&mut self, error: DriverError) {
        let in_doubt = self.in_doubt();
        self.machine.homed = false;
        self.stream.clear();
        self.phase = Phase::Closed;
        self.event(Event::Fault { error, in_doubt, disconnected: true });
    }

    /// The running step. The bend axis has stopped somewhere within it, where no wire can start, so the machine must be
    /// homed.
    fn in_doubt(&mut self) -> Option<u32> {
        let Phase::Running(run) = &self.phase else { return None };
        let step = match run.stage {
            Stage::Step(n) => Some(n),
            // The head has stopped somewhere within its turn.
            Stage::Turn => None,
            _ => return None,
        };
        self.machine.homed = false;
        step
    }
}
