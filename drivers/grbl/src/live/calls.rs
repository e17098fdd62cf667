//! The calls of the program.

use std::time::Duration;

use wirebend_driver_api::{Axis, Batch, DriverError, Event, Motion, Run, Sent};

use super::cutting::not_homed;
use super::jog_row::JogRow;
use super::phase::Phase;
use super::protocol::Protocol;
use super::status::State;
use super::wire_run::{Hold, Stage, WireRun};
use crate::program::{MAX_POSITION, digits, pin_in_lines, trimmed};
use crate::settings::Homing;

const HOLD: u8 = b'!';
const RESUME: u8 = b'~';
/// What the speeds of a dry run are divided by.
const DRY_SLOWER: f64 = 4.0;

impl Protocol {
    /// `$H`, or zero where the axes are, once a person has confirmed it.
    pub fn home(&mut self, now: Duration) -> Result<(), DriverError> {
        self.now = now;
        self.ready()?;
        let locked = match self.machine.state {
            Some(State::Alarm) => true,
            Some(State::Idle) => false,
            state => return Err(not_idle(state)),
        };
        let zero = self.settings.axes().map(|(_, axis)| format!(" {}0", axis.letter())).concat();
        match self.settings.homing {
            Homing::Switches => self.stream.take(["$H".to_owned()]),
            Homing::None if locked => self.stream.take(["$X".to_owned(), format!("G92{zero}")]),
            Homing::None => self.stream.take([format!("G92{zero}")]),
        }
        self.machine.homed = false;
        self.phase = Phase::Homing { since: now };
        self.poller.pause(now);
        self.feed();
        Ok(())
    }

    /// Nothing of the wire is sent. It begins at full speed.
    pub fn arm(&mut self, run: &Run, now: Duration) -> Result<(), DriverError> {
        self.now = now;
        self.ready()?;
        self.interrupted = None;
        self.at_rest()?;
        self.has_axes()?;
        if !self.machine.homed {
            return Err(not_homed());
        }
        self.garbled = 0;
        self.restore_full_speed();
        self.phase = Phase::Running(Box::new(WireRun::new(&self.settings, run)?));
        Ok(())
    }

    pub fn send(&mut self, batch: &Batch, now: Duration) -> Result<Sent, DriverError> {
        self.now = now;
        let Phase::Running(run) = &mut self.phase else {
            let what = "the machine is not armed for a wire";
            return Err(DriverError::new("not-armed", what, "arm it first"));
        };
        let sent = run.take(batch)?;
        if run.hold == Hold::No {
            self.send_next();
        }
        Ok(sent)
    }

    /// One axis by an amount, as a grbl jog: the controller refuses targets beyond its travel and can cancel it.
    pub fn jog(&mut self, motion: Motion, now: Duration) -> Result<(), DriverError> {
        self.now = now;
        self.ready()?;
        self.at_rest()?;
        self.has_axes()?;
        let (line, end) = self.jog_line(motion)?;
        let Some(line) = line else {
            if motion.dry {
                // Of a wire: the rest of it is made all the same.
                self.event(Event::Jogged);
                return Ok(());
            }
            let what = format!("a jog by {} is less than the last digit that is written", motion.by);
            return Err(DriverError::new("jog", what, "jog farther, or raise 'decimals' in the settings"));
        };
        let mut row = JogRow::new(self.machine.reported(&self.settings));
        if motion.dry {
            row.push(pin_in_lines(&self.settings).collect(), [0.0; 3]);
        }
        row.push(vec![line], end);
        if motion.dry && motion.axis == Axis::Bend {
            let (back, _) = self.jog_line(Motion { by: -motion.by, ..motion })?;
            row.push(back.into_iter().collect(), [0.0; 3]);
        }
        self.phase = Phase::Jogging { stopping: None, row };
        self.row_on();
        Ok(())
    }

    /// The line of a jog, and where the axes are after it, in units of the machine. No line where it is less than the last digit.
    pub(super) fn jog_line(&self, motion: Motion) -> Result<(Option<String>, [f64; 3]), DriverError> {
        let s = &self.settings;
        let (axis, letter, units, rate) = match motion.axis {
            Axis::Feed => (0, s.feed_axis, s.feed_units_per_mm, s.feed_rate_mm_per_min),
            Axis::Rotate => (1, s.rotate_axis, s.rotate_units_per_deg, s.rotate_rate_deg_per_min),
            Axis::Bend => (2, s.bend_axis, s.bend_units_per_deg, s.bend_rate_deg_per_min),
        };
        let by = motion.by * units;
        if by.is_nan() || by.abs() > MAX_POSITION {
            let what = format!("a jog by {} is too far; the most is {}", motion.by, MAX_POSITION / units);
            return Err(DriverError::new("jog", what, "jog in smaller parts"));
        }
        let last_digits = 10f64.powi(i32::from(s.decimals));
        #[allow(clippy::cast_possible_truncation)] // at most a million with four digits
        let written = (by * last_digits).round() as i64;
        let mut end = [0.0; 3];
        #[allow(clippy::cast_precision_loss)] // at most a million with four digits
        let units_by = written as f64 / last_digits;
        end[axis] = units_by;
        let rate = if motion.dry { rate / DRY_SLOWER } else { rate };
        let line = || {
            format!(
                "$J=G91 G21 {}{} F{}",
                letter.letter(),
                digits(written, s.decimals),
                trimmed(rate * units)
            )
        };
        Ok(((written != 0).then(line), end))
    }

    /// A feed hold: the axes decelerate and keep their position.
    pub fn pause(&mut self, now: Duration) -> Result<(), DriverError> {
        self.now = now;
        match &mut self.phase {
            Phase::Running(run)
                if run.stage != Stage::Armed && matches!(run.hold, Hold::No | Hold::Asked) =>
            {
                run.hold = Hold::Asked;
            }
            _ => return Err(DriverError::new("not-running", "nothing runs that could be held", "")),
        }
        self.send_realtime(HOLD);
        Ok(())
    }

    pub fn resume(&mut self, now: Duration) -> Result<(), DriverError> {
        self.now = now;
        match &mut self.phase {
            Phase::Running(run) if matches!(run.hold, Hold::Held | Hold::Resuming) => {
                run.hold = Hold::Resuming;
            }
            _ => return Err(DriverError::new("not-paused", "the machine does not hold", "pause it first")),
        }
        self.send_realtime(RESUME);
        Ok(())
    }

    /// At once, in any phase. A jog is cancelled, which keeps the position; anything else is reset.
    pub fn stop(&mut self, now: Duration) -> Result<(), DriverError> {
        self.now = now;
        match self.phase {
            Phase::Closed => return Err(over()),
            Phase::Greeting(_) | Phase::Reading(_) => self.stop_first(),
            Phase::Jogging { stopping: None, .. } => {
                // What is not sent yet is not sent any more.
                self.stream.drop_waiting();
                self.phase = Phase::Jogging { stopping: Some(now), row: JogRow::default() };
                self.cancel_jog();
            }
            _ => self.reset(true),
        }
        Ok(())
    }

    /// Whether a new call may begin. A wire that was armed and not begun is dropped.
    pub(super) fn ready(&mut self) -> Result<(), DriverError> {
        let busy = match &self.phase {
            Phase::Ready => return Ok(()),
            Phase::Running(run) if run.is_armed_only() => {
                self.phase = Phase::Ready;
                return Ok(());
            }
            Phase::Closed => return Err(over()),
            Phase::NotResponding => {
                return Err(DriverError::new(
                    "silent",
                    "the machine does not answer",
                    "stop it, or connect again",
                ));
            }
            Phase::Greeting(_) | Phase::Reading(_) => "the machine has not answered yet",
            Phase::Homing { .. } => "the machine is homing",
            Phase::Jogging { .. } => "an axis moves",
            Phase::Cutting(_) => "the wire is being cut",
            Phase::Console(_) => "a typed line is not answered yet",
            Phase::Running(_) => "a job is running",
            Phase::Halting { .. } | Phase::Resetting(_) => "the machine is being stopped",
        };
        Err(DriverError::new("busy", busy, "wait until it is over, or stop it"))
    }

    pub(super) fn at_rest(&self) -> Result<(), DriverError> {
        match self.machine.state {
            Some(State::Idle) => Ok(()),
            Some(State::Alarm) => {
                let what = "the machine is locked by an alarm";
                Err(DriverError::new("alarm", what, "see what has happened, then home the machine"))
            }
            state => Err(not_idle(state)),
        }
    }

    pub(super) fn has_axes(&self) -> Result<(), DriverError> {
        let axes = self.machine.axes;
        match self.settings.axes().into_iter().find(|(_, letter)| letter.index() >= axes) {
            None => Ok(()),
            Some((key, letter)) => {
                let what = format!("'{key}' is {}; the machine reports {axes} axes", letter.letter());
                Err(DriverError::new(
                    "no-such-axis",
                    what,
                    "set a letter that the machine has; stock grbl has X, Y, Z",
                ))
            }
        }
    }
}

fn over() -> DriverError {
    DriverError::new("disconnected", "the connection is over", "connect again")
}

pub(super) fn not_idle(state: Option<State>) -> DriverError {
    let (name, help) = match state {
        Some(State::Check) => ("Check", "it only pretends to move: leave check mode with $C, or press stop"),
        Some(State::Door { .. }) => ("Door", "close the safety door, then press stop"),
        Some(state) => (state.name(), "press stop, which resets it"),
        None => ("unknown", "wait a moment"),
    };
    DriverError::new("not-idle", format!("the machine is not at rest: its state is {name}"), help)
}
