//! A machine that outlives its driver: it is kept in a file, as a real one keeps its queue when the computer is
//! gone. Everything that it does is written down there, so that a step that is done twice is seen.
//!
//! Settings: `machine` (the file), `faults` (a list of `{"at": step, "how": …}`, of which each happens once),
//! `cutter_mm` and `jams_at` (where its cutter is, and at which cut that jams), `alone` (how many of the steps that it has taken it does before it is connected to again), `holds_by_hand` (in which of
//! the moves by hand, from 1, it holds; homing is one) and `misset` (one of its settings is another until
//! they are written).

use std::collections::VecDeque;
use std::fs::{self, File};
use std::path::PathBuf;

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use wirebend_driver_api::{
    Batch, Call, DoneBy, DriverError, Event, HeadBy, Limits, PausedBy, ReferenceBy, ResumeState, Sent,
    SettingCheck, Step,
};

/// How many steps it takes ahead.
const ROOM: u32 = 3;

#[derive(Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct Settings {
    machine: Option<PathBuf>,
    faults: Vec<Fault>,
    alone: u32,
    holds_by_hand: u32,
    misset: bool,
    /// What it says of the step that a stop has ended in its middle.
    cut: Option<Cut>,
    /// Where its cutter is, mm; absent, it has none.
    cutter_mm: Option<f64>,
    /// The cut at which the cutter jams, from 1.
    jams_at: u32,
}

/// How far a step is that was ended in its middle.
#[derive(Debug, Clone, Copy, Deserialize)]
struct Cut {
    made: Option<Step>,
    exact: bool,
}

#[derive(Debug, Clone, PartialEq, Deserialize)]
struct Fault {
    at: u32,
    how: How,
}

/// What goes wrong when a step is due.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum How {
    /// The cable is pulled before it begins; the machine stays in its session.
    Unplug,
    /// The same when it has been done and before that was reported.
    UnplugAfter,
    /// The controller starts anew, and has forgotten everything.
    Reset,
    ResetAfter,
    /// A person presses the button of the machine: it finishes the step, and holds.
    Hold,
    /// The driver is gone.
    Crash,
    CrashAfter,
}

#[derive(Debug, Default, Serialize, Deserialize)]
struct Kept {
    /// None after a reset.
    session: Option<u32>,
    /// How many sessions there were.
    sessions: u32,
    steps: u32,
    accepted: u32,
    done: u32,
    /// The batch that ends the wire was taken.
    ends: bool,
    /// Every step that was ever done, in order.
    made: Vec<u32>,
    /// Where the head was said to stand, for each arming.
    heads: Vec<f64>,
    /// Every step as it was sent.
    told: Vec<Step>,
    /// How many pieces were cut off.
    #[serde(default)]
    cuts: u32,
}

/// Whether anything reaches the machine.
#[derive(Debug, PartialEq, Eq)]
enum Cable {
    In,
    Out,
}

#[derive(Debug)]
pub(crate) struct Machine {
    settings: Settings,
    file: PathBuf,
    kept: Kept,
    resumed: bool,
    holds: bool,
    finished: bool,
    cable: Cable,
    /// Moves by hand that were begun.
    by_hand: u32,
    events: VecDeque<Event>,
    /// Only one driver at a time: the one before may still be on its way out.
    _lock: File,
}

impl Machine {
    /// None when the settings name no file.
    pub fn open(settings: &[u8]) -> Option<Self> {
        let settings: Settings = serde_json::from_slice(settings).ok()?;
        let file = settings.machine.clone()?;
        let lock = File::create(file.with_extension("lock")).ok()?;
        lock.lock().ok()?;
        let kept = fs::read(&file).ok().and_then(|text| serde_json::from_slice(&text).ok());
        let (kept, events) = (kept.unwrap_or_default(), VecDeque::new());
        Some(Self {
            settings,
            file,
            kept,
            resumed: false,
            holds: false,
            finished: false,
            cable: Cable::In,
            by_hand: 0,
            events,
            _lock: lock,
        })
    }

    pub fn call(&mut self, request: &[u8]) -> Result<Value, DriverError> {
        let call = serde_json::from_slice(request)
            .map_err(|error| DriverError::new("unknown-call", error.to_string(), ""))?;
        match call {
            Call::Connect { resume, .. } => self.connect(resume.as_deref()),
            Call::WriteSettings => {
                self.settings.misset = false;
                self.events
                    .push_back(Event::SettingsWritten { settings: Vec::new(), limits: Limits::default() });
            }
            Call::Home { .. } => self.move_by_hand(Event::Homed),
            Call::Jog(_) => self.move_by_hand(Event::Jogged),
            Call::Arm(run) => {
                if !self.resumed {
                    self.kept.sessions += 1;
                    self.kept.session = Some(self.kept.sessions);
                    (self.kept.accepted, self.kept.done) = (run.after, run.after);
                    self.kept.ends = false;
                }
                self.finished = false;
                self.kept.steps = run.steps;
                self.kept.heads.push(run.rotate_at_deg);
                self.save();
                return Ok(json!({"token": self.kept.session.map(|session| session.to_string())}));
            }
            Call::Send(batch) => return self.send(&batch),
            Call::Pause => {
                self.holds = true;
                self.events.push_back(Event::Paused { by: PausedBy::Program });
            }
            Call::Resume => {
                self.holds = false;
                self.events.push_back(Event::Resumed);
            }
            Call::Stop if self.cable == Cable::Out => {
                return Err(DriverError::new("disconnected", "the port is gone", "connect again"));
            }
            Call::Stop => {
                (self.resumed, self.holds) = (false, false);
                self.kept.session = None;
                self.save();
                if let Some(Cut { made, exact }) = self.settings.cut
                    && self.kept.done < self.kept.accepted
                {
                    let step = self.kept.done + 1;
                    self.events.push_back(Event::PartMade { step, made, exact });
                }
                self.events.push_back(Event::Stopped { homed: false });
            }
            Call::Limits => {
                let limits = Limits { cutter_mm: self.settings.cutter_mm, ..Limits::default() };
                return Ok(serde_json::to_value(limits).unwrap_or_default());
            }
            Call::Cut => self.cut(),
            Call::Disconnect => {}
            _ => return Err(DriverError::unsupported("do that")),
        }
        Ok(json!({}))
    }

    fn cut(&mut self) {
        self.kept.cuts += 1;
        self.save();
        if self.kept.cuts == self.settings.jams_at {
            let error =
                DriverError::new("jammed", "the cutter has not come back", "free it, then home the machine");
            self.events.push_back(Event::Fault { error, in_doubt: None, disconnected: false });
        } else {
            self.events.push_back(Event::Cut);
        }
    }

    fn move_by_hand(&mut self, made: Event) {
        self.by_hand += 1;
        let holds = self.by_hand == self.settings.holds_by_hand;
        self.events.push_back(if holds { Event::Paused { by: PausedBy::Silence } } else { made });
    }

    fn connect(&mut self, resume: Option<&str>) {
        let known = self.kept.session.map(|session| session.to_string());
        self.resumed = resume.is_some() && resume == known.as_deref();
        let mut state = None;
        if self.resumed {
            let alone = self.settings.alone.min(self.kept.accepted - self.kept.done);
            (0..alone).for_each(|_| self.make());
            // No program was there for a second: what was not begun waits.
            self.holds = self.kept.done < self.kept.accepted;
            state = Some(ResumeState { accepted: self.kept.accepted, done: self.kept.done });
        }
        let identity = "a machine in a file".to_owned();
        let other = || SettingCheck {
            name: "$100".to_owned(),
            machine: "80".to_owned(),
            expected: "40".to_owned(),
            matters: true,
        };
        let settings = self.settings.misset.then(other).into_iter().collect();
        self.events.push_back(Event::Connected {
            identity,
            settings,
            homed: false,
            resume: state,
            reference: ReferenceBy::default(),
            done_by: DoneBy::default(),
            head: HeadBy::default(),
            limits: Limits::default(),
        });
        if self.holds {
            self.events.push_back(Event::Paused { by: PausedBy::Silence });
        }
    }

    fn send(&mut self, batch: &Batch) -> Result<Value, DriverError> {
        if self.kept.session.is_none() {
            return Err(DriverError::new("not-armed", "there is no wire", ""));
        }
        let known = self.kept.accepted;
        for step in batch.steps.iter().filter(|step| step.n > known) {
            if self.kept.accepted - self.kept.done >= ROOM {
                break;
            }
            self.kept.accepted += 1;
            assert_eq!(step.n, self.kept.accepted, "a gap");
            self.kept.told.push(step.step);
        }
        self.kept.ends |= batch.last && self.kept.accepted == self.kept.steps;
        self.save();
        let free = ROOM - (self.kept.accepted - self.kept.done);
        Ok(serde_json::to_value(Sent { accepted: self.kept.accepted, free }).unwrap_or_default())
    }

    /// Does one step for each look at it.
    pub fn poll(&mut self) -> Option<Event> {
        if self.events.is_empty() && !self.holds && self.kept.session.is_some() {
            self.turn();
        }
        self.events.pop_front()
    }

    fn turn(&mut self) {
        if self.kept.done == self.kept.accepted {
            if self.kept.ends && !self.finished {
                self.finished = true;
                self.events.push_back(Event::Finished);
            }
            return;
        }
        let n = self.kept.done + 1;
        let due = self.settings.faults.iter().position(|fault| fault.at == n);
        let how = due.map(|at| self.settings.faults.remove(at).how);
        if !matches!(how, Some(How::Unplug | How::Reset | How::Crash)) {
            self.make();
        }
        match how {
            None => self.events.push_back(Event::Done { n }),
            Some(How::Crash | How::CrashAfter) => std::process::abort(),
            Some(How::Hold) => {
                self.holds = true;
                self.events.extend([Event::Done { n }, Event::Paused { by: PausedBy::Machine }]);
            }
            // It may resume by itself.
            Some(How::Unplug | How::UnplugAfter) => {
                self.cable = Cable::Out;
                self.fault(None, "unplugged");
            }
            Some(How::Reset | How::ResetAfter) => {
                self.kept.session = None;
                self.save();
                self.fault(Some(n), "reset");
            }
        }
    }

    fn fault(&mut self, in_doubt: Option<u32>, code: &str) {
        self.holds = true;
        let error = DriverError::new(code, "as it was told to", "connect again");
        self.events.push_back(Event::Fault { error, in_doubt, disconnected: true });
    }

    fn make(&mut self) {
        self.kept.done += 1;
        self.kept.made.push(self.kept.done);
        self.save();
    }

    /// In one piece: the driver may be ended at any moment.
    fn save(&self) {
        let new = self.file.with_extension("new");
        let text = serde_json::to_vec(&self.kept).unwrap_or_default();
        if fs::write(&new, text).is_ok() {
            let _ = fs::rename(&new, &self.file);
        }
    }
}
