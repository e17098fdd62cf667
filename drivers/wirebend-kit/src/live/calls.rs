//! The calls of the program.

use std::time::Duration;

use wirebend_driver_api::{ArmedReply, Axis, Batch, DriverError, Motion, Run, Sent, Step};

use super::fault;
use super::head_target::HeadTarget;
use super::machine::{Activity, FASTEST, Halt, HeadReference, Homing, Machine, session_id};
use super::wire_progress::{Token, WireProgress};
use crate::link::Request;
use crate::protocol::{SETTINGS, State};
use crate::settings::{expected, steps};

/// The firmware that takes where the peg comes out, 100 for 1.0.
const APPROACHES_SINCE: u32 = 111;

/// The firmware whose bends may end at zero or before it, 100 for 1.0.
pub(super) const BEFORE_ZERO_SINCE: u32 = 113;
/// The firmware that has dry-run moves, 100 for 1.0.
const DRY_SINCE: u32 = 112;
/// The firmware whose speed can be changed while it runs.
const SPEED_SINCE: u32 = 112;

/// Steps that are accepted ahead of the running one. The program writes each into its journal before.
const AHEAD: u32 = 12;

impl Machine {
    /// `head_at_deg`: the position of the head, if the program knows it.
    pub fn home(&mut self, head_at_deg: Option<f64>, now: Duration) -> Result<(), DriverError> {
        self.require_rest("home")?;
        let max = self.settings.rotate_limit_deg;
        if let Some(deg) = head_at_deg.filter(|deg| deg.is_nan() || deg.abs() > max + 1e-9) {
            return Err(fault::head_beyond(deg, max));
        }
        self.head_at = head_at_deg.map(|deg| steps(deg * self.rotate_steps_per_deg()));
        // A user who homes has seen that the machine is at rest.
        self.ending = None;
        (self.homed, self.halt, self.wire) = (false, Halt::No, None);
        self.head_target = HeadTarget::default();
        let busy = self.status.is_some_and(|status| matches!(status.state, State::Run | State::Hold));
        if busy {
            self.link.stop(now);
            self.activity = Activity::Homing(Homing::Stopping);
        } else {
            self.renew(session_id(self.link.session()), now);
            self.activity = Activity::Homing(Homing::Opening);
        }
        Ok(())
    }

    pub fn arm(&mut self, run: &Run, now: Duration) -> Result<ArmedReply, DriverError> {
        if let (Some(token), Some(wire)) = (self.token, &mut self.wire)
            && self.activity == Activity::Idle
        {
            wire.steps = run.steps;
            let taken_deg = run.rotate_taken_deg.unwrap_or(run.rotate_at_deg);
            self.head_target = HeadTarget::at(taken_deg, self.rotate_steps_per_deg());
            self.activity = Activity::Running;
            return Ok(ArmedReply { token: Some(token.to_string()) });
        }
        self.require_rest("run a job")?;
        self.require_homed()?;
        let token = Token { session: session_id(self.link.session()), boots: self.boots, after: run.after };
        self.head_target = HeadTarget::at(run.rotate_at_deg, self.rotate_steps_per_deg());
        let rotate_at = self.head_target.steps();
        self.wire = Some(WireProgress::new(run, rotate_at));
        // It was homed, and of a wire of which nothing is fed the head has turned nothing.
        let is_new = run.after == 0 && run.fed_mm == 0.0;
        if rotate_at == 0 || (self.head == HeadReference::Lost && !is_new) {
            self.open_for_wire(token.session, now);
        } else {
            self.activity = Activity::ToTurn { session: token.session, at: None };
            self.link.query();
        }
        self.token = Some(token);
        Ok(ArmedReply { token: Some(token.to_string()) })
    }

    /// The head goes to where a wire begins or goes on by a move of its own: its play is taken up by a turn there and back alone. The
    /// lines of the wire count in a session that is opened after it.
    fn turn_first(&mut self, now: Duration) {
        let (Activity::ToTurn { session, at: Some(at) }, Some(wire)) = (self.activity, &self.wire) else {
            return;
        };
        match wire.rotate_at - at {
            0 => self.open_for_wire(session, now),
            turn => {
                let line = self.link.line(b'M', &[0, turn, 0]);
                self.activity = Activity::Turning { line, session };
            }
        }
    }

    /// Opens the session of a wire.
    pub(super) fn open_for_wire(&mut self, session: u16, now: Duration) {
        let token = self.token;
        self.renew(session, now);
        (self.token, self.activity) = (token, Activity::Arming);
    }

    pub fn send(&mut self, batch: &Batch, now: Duration) -> Result<Sent, DriverError> {
        if !batch.steps.is_empty() {
            self.turn_first(now);
        }
        let (
            Some(wire),
            Activity::ToTurn { .. } | Activity::Turning { .. } | Activity::Arming | Activity::Running,
        ) = (&self.wire, self.activity)
        else {
            return Err(DriverError::new("not-armed", "the machine is not armed for a wire", "arm it"));
        };
        let (mut given, done, mut head) = (wire.given, wire.done, self.head_target);
        let mut lines = Vec::new();
        for step in &batch.steps {
            if step.n <= given {
                continue;
            }
            if step.n != given + 1 {
                return Err(fault::gap(given, step.n));
            }
            if self.activity != Activity::Running || step.n > done + AHEAD {
                break;
            }
            let line = self.line_of(step.n, step.step, &mut head)?;
            lines.push((step.step, line, self.approach_of(step.n, step.step)?));
            given = step.n;
        }
        self.head_target = head;
        let all = batch.steps.last().is_none_or(|last| last.n <= given);
        if let Some(wire) = &mut self.wire {
            for (n, (step, [feed, rotate, bend], approach)) in (wire.given + 1..).zip(lines) {
                let turn = std::mem::take(&mut wire.turn);
                let mut line = vec![feed, rotate + turn, bend];
                line.extend(approach);
                self.link.line(b'M', &line);
                wire.give(n, step, [feed, rotate]);
            }
            wire.closed |= batch.last && all && self.activity == Activity::Running;
        }
        let free = if self.activity == Activity::Running { (done + AHEAD).saturating_sub(given) } else { 0 };
        Ok(Sent { accepted: given, free })
    }

    pub fn jog(&mut self, motion: Motion) -> Result<(), DriverError> {
        self.require_rest("jog")?;
        self.require_homed()?;
        let mut step = Step::default();
        *match motion.axis {
            Axis::Feed => &mut step.feed_mm,
            Axis::Rotate => &mut step.rotate_deg,
            Axis::Bend => &mut step.bend_deg,
        } = motion.by;
        let mut head = self.head_target;
        let line = self.line_of(0, step, &mut head)?;
        if motion.dry {
            self.require_since(DRY_SINCE, "dry run")?;
        }
        self.head_target = head;
        let letter = if motion.dry { b'Y' } else { b'M' };
        self.activity = Activity::Jogging(self.link.line(letter, &line));
        Ok(())
    }

    pub fn pause(&mut self) {
        self.link.request(Request::Pause);
    }

    pub fn resume(&mut self) {
        self.link.request(Request::Resume);
    }

    /// From the next move of an axis on.
    pub fn set_speed(&mut self, percent: u8) -> Result<(), DriverError> {
        self.require_since(SPEED_SINCE, "speed override")?;
        if percent > FASTEST {
            return Err(fault::no_faster());
        }
        self.wanted_speed = percent;
        self.link.request(Request::Speed(percent));
        Ok(())
    }

    pub fn stop(&mut self, now: Duration) {
        self.link.stop(now);
        self.halt = Halt::Requested;
        if matches!(self.activity, Activity::StoringSettings | Activity::Typing(_)) {
            self.activity = Activity::Idle;
        }
    }

    pub fn write_settings(&mut self) -> Result<(), DriverError> {
        self.require_rest("store settings")?;
        if self.read.contains(&None) {
            self.link.request(Request::LoadDefaults);
        }
        // Twice: some values are accepted only after others.
        for _ in 0..2 {
            for (setting, value) in SETTINGS.iter().zip(expected(&self.settings)) {
                self.link.request(Request::Write(setting.id, value));
            }
        }
        self.unwritten.clear();
        self.read_settings();
        self.homed = false;
        self.activity = Activity::StoringSettings;
        Ok(())
    }

    pub(super) fn read_settings(&mut self) {
        self.read = [None; SETTINGS.len()];
        for setting in &SETTINGS {
            self.link.request(Request::Read(setting.id));
        }
    }

    pub(super) fn renew(&mut self, id: u16, now: Duration) {
        self.link.renew(id, now);
        self.token = None;
        self.wanted_speed = FASTEST;
        self.speed_changed(FASTEST);
    }

    pub(super) fn rotate_steps_per_deg(&self) -> f64 {
        f64::from(self.settings.rotate_steps_per_turn) / 360.0
    }

    /// A step in motor steps, if it is within the limits.
    fn line_of(&self, n: u32, step: Step, head: &mut HeadTarget) -> Result<[i32; 3], DriverError> {
        let settings = &self.settings;
        let per_deg = f64::from(settings.bend_steps_per_turn) / 360.0;
        let within = |value: f64, max: f64| value.is_finite() && value.abs() <= max + 1e-9;
        for (what, value, max, unit) in [
            ("feed", step.feed_mm, settings.feed_most_mm, " mm"),
            ("rotation", step.rotate_deg, 2.0 * settings.rotate_limit_deg, "°"),
            ("bend", step.bend_deg, settings.bend_limit_deg, "°"),
        ] {
            if !within(value, max) {
                return Err(fault::beyond(n, what, value, max, unit));
            }
        }
        Ok([
            steps(step.feed_mm * settings.feed_steps_per_mm),
            head.turn(step.rotate_deg, self.rotate_steps_per_deg()),
            steps(step.bend_deg * per_deg),
        ])
    }

    /// Where the peg comes out, in motor steps, where that is farther from zero than it does by itself, or tells the side of the bend.
    fn approach_of(&self, n: u32, step: Step) -> Result<Option<i32>, DriverError> {
        let settings = &self.settings;
        let per_deg = f64::from(settings.bend_steps_per_turn) / 360.0;
        // A place that is rounded to zero has no side either.
        let before_zero = step.ends_before_zero() || steps(step.bend_deg * per_deg) == 0;
        let says = |deg: &f64| before_zero || deg.is_nan() || deg.abs() > settings.near_side_deg;
        let Some(deg) = step.approach_deg.filter(says) else { return Ok(None) };
        let max = settings.bend_limit_deg;
        if deg.abs() > max + 1e-9 {
            return Err(fault::beyond(n, "approach of the peg", deg, max, "°"));
        }
        let comes_out = deg.abs().max(settings.near_side_deg);
        if deg.is_nan() || deg == 0.0 || (before_zero && step.bend_deg.abs() >= comes_out) {
            return Err(fault::bends_nothing(n, deg, step.bend_deg));
        }
        let older = |than: u32| self.versions.filter(|versions| versions.firmware < than);
        if let Some(versions) = older(BEFORE_ZERO_SINCE).filter(|_| before_zero) {
            return Err(fault::cannot_end_before_zero(n, step.bend_deg, versions));
        }
        if let Some(versions) = older(APPROACHES_SINCE) {
            return Err(fault::cannot_approach(n, deg, versions));
        }
        Ok(Some(steps(deg * per_deg)))
    }

    pub(super) fn require_rest(&self, what: &str) -> Result<(), DriverError> {
        match self.activity {
            Activity::Idle => Ok(()),
            Activity::Connecting => Err(fault::busy(what, "it is connecting")),
            Activity::Closed => Err(fault::busy(what, "the connection is lost")),
            Activity::Homing(_) => Err(fault::busy(what, "it is homing")),
            Activity::ToTurn { .. } | Activity::Turning { .. } | Activity::Arming | Activity::Running => {
                Err(fault::busy(what, "it is running a job"))
            }
            Activity::Jogging(_) => Err(fault::busy(what, "it is jogging")),
            Activity::StoringSettings => Err(fault::busy(what, "it is storing settings")),
            Activity::Typing(_) => Err(fault::busy(what, "a typed line is not answered yet")),
        }
    }

    fn require_since(&self, firmware: u32, what: &str) -> Result<(), DriverError> {
        match self.versions.filter(|versions| versions.firmware < firmware) {
            Some(versions) => Err(fault::firmware_lacks(what, versions)),
            None => Ok(()),
        }
    }

    fn require_homed(&self) -> Result<(), DriverError> {
        if self.homed {
            return Ok(());
        }
        Err(DriverError::new("not-homed", "the machine is not homed", "home it"))
    }
}

#[cfg(test)]
mod tests {
    use std::rc::Rc;

    use super::*;
    use crate::protocol::Versions;
    use crate::settings::Settings;

    #[test]
    fn an_older_firmware_has_no_dry_run() {
        let mut machine = Machine::new(Rc::new(Settings::default()), None, Duration::ZERO);
        (machine.homed, machine.activity) = (true, Activity::Idle);
        let mut jog = |firmware, dry| {
            machine.activity = Activity::Idle;
            machine.versions = Some(Versions { protocol: 1, firmware, machine: 1 });
            machine.jog(Motion { dry, ..Motion::new(Axis::Bend, 30.0) })
        };
        assert_eq!(jog(111, true).unwrap_err().code, "older-firmware");
        assert!(jog(111, false).is_ok() && jog(112, true).is_ok());
    }

    /// 22.5° are 1028.56 steps: sixteen times 1029 are seven more than a turn, which the firmware refuses.
    #[test]
    fn turns_in_whole_steps_add_up_to_what_the_exact_ones_do() {
        let machine = Machine::new(Rc::new(Settings::default()), None, Duration::ZERO);
        let per_deg = machine.rotate_steps_per_deg();
        for rotate_deg in [22.5, 1.0, -0.004, 0.0] {
            let (mut head, mut told, mut exact) = (HeadTarget::default(), 0, 0.0);
            for n in 1..=16 {
                let step = Step { rotate_deg, ..Step::default() };
                told += machine.line_of(n, step, &mut head).unwrap()[1];
                exact += rotate_deg * per_deg;
                assert!((f64::from(told) - exact).abs() < 0.5 + 1e-6, "{told}, not {exact}");
            }
        }
        // Where it goes on it stands as if it had come there from its zero.
        let mut head = HeadTarget::default();
        let sum: i32 = [90.0, 90.0, -90.0].map(|deg| head.turn(deg, 411.5 / 90.0)).iter().sum();
        assert_eq!((sum, head.steps()), (412, HeadTarget::at(90.0, 411.5 / 90.0).steps()));
    }

    #[test]
    fn the_peg_is_told_where_to_come_out_only_where_it_has_to_and_can_be() {
        let settings = Settings::default();
        let per_deg = f64::from(settings.bend_steps_per_turn) / 360.0;
        let mut machine = Machine::new(Rc::new(settings), None, Duration::ZERO);
        let mut told = |firmware: Option<u32>, bend_deg, approach_deg| {
            machine.versions = firmware.map(|firmware| Versions { protocol: 1, firmware, machine: 1 });
            machine.approach_of(7, Step { feed_mm: 30.0, rotate_deg: 0.0, bend_deg, approach_deg })
        };
        assert_eq!(told(Some(111), 40.0, None).unwrap(), None);
        assert_eq!(told(Some(110), 40.0, Some(-18.0)).unwrap(), None, "it comes out farther by itself");
        assert_eq!(told(Some(111), 40.0, Some(-30.0)).unwrap(), Some(steps(-30.0 * per_deg)));
        assert_eq!(
            told(None, -40.0, Some(30.0)).unwrap(),
            Some(steps(30.0 * per_deg)),
            "in a session of before"
        );
        let older = told(Some(110), 40.0, Some(-30.0)).unwrap_err();
        assert_eq!(older.code, "older-firmware");
        assert!(older.message.contains("step 7") && older.message.contains("1.10"), "{}", older.message);
        for (bend, approach, code) in [
            (40.0, -156.0, "beyond"),
            (40.0, 30.0, "other-side"),
            (-18.25, -10.0, "other-side"),
            (0.0, 0.0, "other-side"),
            (40.0, f64::NAN, "other-side"),
        ] {
            assert_eq!(told(Some(113), bend, Some(approach)).unwrap_err().code, code, "{bend} {approach}");
        }
        // At zero or before it the side of the bend is told, also where the peg comes out no farther than it does by itself. What
        // motors round to zero is at zero.
        for (bend, approach) in [(-5.0, -18.25), (5.0, 30.0), (0.0, -18.0), (0.003, -18.0)] {
            let there = Some(steps(approach * per_deg));
            assert_eq!(told(Some(113), bend, Some(approach)).unwrap(), there, "{bend} {approach}");
            let older = told(Some(112), bend, Some(approach)).unwrap_err();
            assert_eq!(older.code, "older-firmware");
            assert!(older.message.contains("step 7") && older.message.contains("1.12"), "{}", older.message);
        }
    }
}
