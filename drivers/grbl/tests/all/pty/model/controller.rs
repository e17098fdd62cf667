//! The controller's loop: bytes, motion, resets and alarms.

use std::collections::VecDeque;
use std::io::{Read, Write};
use std::sync::Arc;
use std::time::{Duration, Instant};

use super::{Build, Events, Record, STEPS_PER_UNIT};

/// Blocks of the planner.
pub(super) const PLANNER: usize = 15;
/// Bytes of the receive buffer.
const RECEIVE_BUFFER: usize = 128;
/// After `ALARM:` the controller does nothing for so long (`report_alarm_message`). By the clock, since what the driver
/// waits for is: turns take longer where other tests run beside.
const ALARM: Duration = Duration::from_millis(500);
/// A report has `WCO:` so often (`REPORT_WCO_REFRESH_IDLE_COUNT`, `_BUSY_COUNT`).
const OFFSET_IDLE: u32 = 10;
const OFFSET_BUSY: u32 = 30;
/// The same of the overrides.
const OVERRIDE_IDLE: u32 = 10;
const OVERRIDE_BUSY: u32 = 20;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum State {
    Alarm,
    Idle,
    Run,
    Hold,
}

/// What keeps the controller from everything else.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Ending {
    Not,
    /// It has said its alarm, and does nothing for a while.
    Alarm {
        critical: bool,
        until: Instant,
    },
    /// It waits for a reset, after a limit.
    Locked,
}

pub struct Controller<P> {
    port: P,
    pub build: Build,
    events: Arc<Events>,
    pub received: VecDeque<u8>,
    pub line: String,
    /// A line that waits until everything that was planned is done, and for how many turns after that.
    pub waiting: Option<(String, u32)>,
    pub planner: VecDeque<[i64; 3]>,
    pub state: State,
    ending: Ending,
    reset_asked: bool,
    pub relative: bool,
    /// Where the axes are, steps of the controller's count.
    pub at: [i64; 3],
    /// Where they will be after all that is planned, in units: as in the controller, what a step cannot show
    /// is not lost.
    pub planned: [f64; 3],
    /// G92.
    pub offset: [f64; 3],
    pub until_offset: u32,
    /// Percent of the feed rate.
    feed_override: u8,
    /// Which of the bytes from 0x90 on have come since the turn before; not how often.
    override_flags: u8,
    until_override: u32,
    /// Where the axes really stand.
    pub really: [f64; 3],
    /// With the pin out, the farthest that the bend axis has really been.
    pub farthest: Option<f64>,
    asked: bool,
    pub record: Record,
}

impl<P: Read + Write> Controller<P> {
    pub fn new(port: P, build: Build, events: Arc<Events>) -> Self {
        let state = if build.switches { State::Alarm } else { State::Idle };
        Self {
            port,
            build,
            events,
            received: VecDeque::new(),
            line: String::new(),
            waiting: None,
            planner: VecDeque::new(),
            state,
            ending: Ending::Not,
            reset_asked: false,
            relative: false,
            at: [0; 3],
            planned: [0.0; 3],
            offset: [0.0; 3],
            until_offset: 0,
            feed_override: 100,
            override_flags: 0,
            until_override: 0,
            really: [0.0; 3],
            farthest: None,
            asked: false,
            record: Record::default(),
        }
    }

    pub fn run(mut self) -> Record {
        self.begin();
        while !self.events.ended() {
            self.turn();
        }
        self.record.at = self.really;
        self.record
    }

    /// A turn of its loop.
    pub fn turn(&mut self) {
        let events = Arc::clone(&self.events);
        self.really = events.tell(self.at.map(units), self.farthest.is_some(), self.record.resets);
        self.receive();
        self.override_feed();
        if Events::takes(&events.power) {
            self.start_anew();
        }
        if Events::takes(&events.limit) {
            self.kill(Some(1));
        }
        if self.is_kept() {
            return;
        }
        self.take_line();
        // As in the controller: a report is written before motions that were just planned begin.
        if std::mem::take(&mut self.asked) {
            self.report();
        }
        if matches!(self.state, State::Idle | State::Run) {
            self.state = if self.planner.is_empty() { State::Idle } else { State::Run };
        }
        self.move_on();
    }

    pub fn say(&mut self, text: &str) {
        // The other side may have gone.
        let _ = self.port.write_all(format!("{text}\r\n").as_bytes());
    }

    /// Power, or the end of a reset. The position stays, G92 does not.
    pub fn begin(&mut self) {
        self.received.clear();
        self.line.clear();
        self.waiting = None;
        self.planner.clear();
        (self.relative, self.offset, self.until_offset) = (false, [0.0; 3], 0);
        (self.feed_override, self.override_flags, self.until_override) = (100, 0, 0);
        (self.reset_asked, self.asked) = (false, false);
        self.planned = self.at.map(units);
        self.farthest = None;
        if self.state == State::Hold {
            self.state = State::Idle;
        }
        self.say("\r\nGrbl 1.1h ['$' for help]");
        if self.state == State::Alarm {
            self.say("[MSG:'$H'|'$X' to unlock]");
        }
    }

    /// The power was away: the controller counts from zero, wherever the axes stand.
    fn start_anew(&mut self) {
        let mut now = self.events.now.lock().expect("nothing fails while it is held");
        for (hand, steps) in now.hand.iter_mut().zip(self.at.map(units)) {
            *hand += steps;
        }
        drop(now);
        self.at = [0; 3];
        self.ending = Ending::Not;
        self.state = if self.build.switches { State::Alarm } else { State::Idle };
        self.begin();
    }

    /// Homing is over.
    pub fn stand_at_marks(&mut self) {
        self.events.now.lock().expect("nothing fails while it is held").hand = [0.0; 3];
        self.at = [0; 3];
    }

    /// Motion and spindle end at once. An alarm of its own, or 3 where something moved.
    pub fn kill(&mut self, alarm: Option<u32>) {
        if self.ending != Ending::Not {
            return;
        }
        if let Some(farthest) = self.farthest.take() {
            self.record.bends.push([self.really[0], self.really[1], farthest]);
        }
        let moved = self.state == State::Run && !self.planner.is_empty();
        if let Some(code) = alarm.or(moved.then_some(3)) {
            self.planner.clear();
            self.state = State::Alarm;
            self.ending = Ending::Alarm { critical: code < 3, until: Instant::now() + ALARM };
            self.say(&format!("ALARM:{code}"));
        }
    }

    fn receive(&mut self) {
        let mut bytes = [0; 256];
        let count = self.port.read(&mut bytes).unwrap_or_default();
        for &byte in &bytes[..count] {
            match byte {
                b'?' => self.asked = true,
                b'!' if matches!(self.state, State::Run | State::Idle) => self.state = State::Hold,
                b'~' if self.state == State::Hold => self.state = State::Idle,
                0x18 => {
                    self.record.resets += 1;
                    self.kill(None);
                    self.reset_asked = true;
                }
                0x90..=0x97 => self.override_flags |= 1 << (byte - 0x90),
                // A real-time command that it does not know is no part of a line.
                b'!' | b'~' | 0x80.. => {}
                _ => self.received.push_back(byte),
            }
        }
        self.record.overflowed |= self.received.len() > RECEIVE_BUFFER;
    }

    /// Each once, however often it came: all of it, ten more and less, one more and less.
    fn override_feed(&mut self) {
        let flags = std::mem::take(&mut self.override_flags);
        let before = self.feed_override;
        if flags & 1 != 0 {
            self.feed_override = 100;
        }
        for (flag, by) in [(1, 10), (2, -10), (3, 1), (4, -1)] {
            if flags & 1 << flag != 0 {
                self.feed_override = self.feed_override.saturating_add_signed(by).clamp(10, 200);
            }
        }
        if self.feed_override != before {
            self.until_override = 0;
        }
    }

    /// Whether an alarm or a reset keeps it from its lines. A report that was asked for meanwhile is not written.
    fn is_kept(&mut self) -> bool {
        match self.ending {
            Ending::Alarm { until, .. } if Instant::now() < until => return true,
            Ending::Alarm { critical, .. } => {
                self.ending = Ending::Not;
                if critical {
                    self.say("[MSG:Reset to continue]");
                    // One that came before is forgotten.
                    (self.ending, self.reset_asked) = (Ending::Locked, false);
                }
            }
            Ending::Locked if self.reset_asked => self.ending = Ending::Not,
            Ending::Locked => return true,
            Ending::Not => {}
        }
        if self.ending == Ending::Not && self.reset_asked {
            // The line that waited is over, as far as the controller is concerned.
            if self.waiting.take().is_some() {
                self.say("ok");
            }
            self.begin();
        }
        self.ending != Ending::Not
    }

    fn move_on(&mut self) {
        if self.state != State::Run {
            return;
        }
        let Some(&target) = self.planner.front() else { return };
        let most = (self.build.steps_a_turn * i64::from(self.feed_override) / 100).max(1);
        for (at, target) in self.at.iter_mut().zip(target) {
            *at += (target - *at).clamp(-most, most);
        }
        self.really = self.events.tell(self.at.map(units), self.farthest.is_some(), self.record.resets);
        if let Some(farthest) = &mut self.farthest
            && self.really[2].abs() > farthest.abs()
        {
            *farthest = self.really[2];
        }
        if self.at == target {
            self.planner.pop_front();
        }
    }

    fn report(&mut self) {
        let name = match self.state {
            State::Hold => "Hold:0".to_owned(),
            state => format!("{state:?}"),
        };
        let [x, y, z] = self.at.map(units);
        let field = if self.until_offset == 0 {
            self.until_offset = if self.state == State::Run { OFFSET_BUSY } else { OFFSET_IDLE };
            let [x, y, z] = self.offset;
            format!("|WCO:{x:.3},{y:.3},{z:.3}")
        } else if self.until_override == 0 {
            self.until_override = if self.state == State::Run { OVERRIDE_BUSY } else { OVERRIDE_IDLE };
            format!("|Ov:{},100,100", self.feed_override)
        } else {
            String::new()
        };
        self.until_offset -= 1;
        self.until_override = self.until_override.saturating_sub(1);
        self.say(&format!("<{name}|MPos:{x:.3},{y:.3},{z:.3}|FS:0,0{field}>"));
    }
}

#[allow(clippy::cast_precision_loss)] // a model's wire is short
pub(super) fn units(steps: i64) -> f64 {
    steps as f64 / STEPS_PER_UNIT
}

#[allow(clippy::cast_possible_truncation)] // a model's wire is short
pub(super) fn steps(units: f64) -> i64 {
    (units * STEPS_PER_UNIT).round() as i64
}
