//! A small grbl on the other side of a cable, made after its documentation and without a line of the driver:
//! it takes lines into a planner of its own, answers `ok` when they are planned, and says `Idle` when they
//! are done.

use std::collections::VecDeque;
use std::io::{Read, Write};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use serialport::{SerialPort, TTYPort};

/// Steps for each unit of every axis.
const STEPS_PER_UNIT: f64 = 80.0;
/// Steps of a turn of the model's loop, which takes about a millisecond.
const STEPS_A_TURN: i64 = 40;
/// Blocks of the planner.
const PLANNER: usize = 15;
/// Bytes of the receive buffer.
const RECEIVE_BUFFER: usize = 128;

/// What the model has done.
#[derive(Debug, Default, Clone, PartialEq)]
pub struct Record {
    /// Where feed and rotation stood when the pin was put out, and how far the bend axis went from there.
    pub bends: Vec<[f64; 3]>,
    /// Where the axes stand.
    pub at: [f64; 3],
    /// More bytes came at once than the buffer holds.
    pub overflowed: bool,
    pub resets: usize,
}

/// A running model. It ends when it is told to, and with it the cable.
pub struct Model {
    end: Arc<AtomicBool>,
    resets: Arc<AtomicUsize>,
    thread: JoinHandle<Record>,
}

impl Model {
    pub fn run(port: TTYPort) -> Self {
        let end = Arc::new(AtomicBool::new(false));
        let resets = Arc::new(AtomicUsize::new(0));
        let (told, count) = (Arc::clone(&end), Arc::clone(&resets));
        let thread = thread::spawn(move || Controller::new(port, count).run(&told));
        Self { end, resets, thread }
    }

    /// How often it has been reset so far.
    pub fn resets(&self) -> usize {
        self.resets.load(Ordering::SeqCst)
    }

    pub fn end(self) -> Record {
        self.end.store(true, Ordering::SeqCst);
        self.thread.join().expect("the model does not fail")
    }
}

struct Controller {
    port: TTYPort,
    received: VecDeque<u8>,
    line: String,
    /// A line that waits until everything that was planned is done, and for how many turns after that.
    waiting: Option<(String, u32)>,
    planner: VecDeque<[i64; 3]>,
    state: State,
    relative: bool,
    /// Where the axes are, steps.
    at: [i64; 3],
    /// Where they will be after all that is planned, in units: as in the controller, what a step cannot show
    /// is not lost.
    planned: [f64; 3],
    /// With the pin out, the farthest that the bend axis has been.
    farthest: Option<i64>,
    asked: bool,
    resets: Arc<AtomicUsize>,
    record: Record,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    Alarm,
    Idle,
    Run,
}

impl Controller {
    fn new(mut port: TTYPort, resets: Arc<AtomicUsize>) -> Self {
        port.set_timeout(Duration::from_millis(1)).expect("a timeout");
        Self {
            port,
            received: VecDeque::new(),
            line: String::new(),
            waiting: None,
            planner: VecDeque::new(),
            state: State::Alarm,
            relative: false,
            at: [0; 3],
            planned: [0.0; 3],
            farthest: None,
            asked: false,
            resets,
            record: Record::default(),
        }
    }

    fn run(mut self, end: &AtomicBool) -> Record {
        self.begin();
        while !end.load(Ordering::SeqCst) {
            self.receive();
            self.line();
            // As in the controller: a report is written before motions that were just planned begin.
            if std::mem::take(&mut self.asked) {
                self.report();
            }
            if self.state != State::Alarm {
                self.state = if self.planner.is_empty() { State::Idle } else { State::Run };
            }
            self.move_on();
        }
        self.record.at = self.at.map(units);
        self.record.resets = self.resets.load(Ordering::SeqCst);
        self.record
    }

    fn say(&mut self, text: &str) {
        // The other side may have gone.
        let _ = self.port.write_all(format!("{text}\r\n").as_bytes());
    }

    /// Power, or a reset.
    fn begin(&mut self) {
        self.received.clear();
        self.line.clear();
        self.waiting = None;
        self.planner.clear();
        self.relative = false;
        self.planned = self.at.map(units);
        self.farthest = None;
        self.say("\r\nGrbl 1.1h ['$' for help]");
        if self.state == State::Alarm {
            self.say("[MSG:'$H'|'$X' to unlock]");
        }
    }

    fn receive(&mut self) {
        let mut bytes = [0; 256];
        let count = self.port.read(&mut bytes).unwrap_or_default();
        for &byte in &bytes[..count] {
            match byte {
                b'?' => self.asked = true,
                0x18 => {
                    if self.state == State::Run {
                        self.state = State::Alarm;
                        self.say("ALARM:3");
                    }
                    self.begin();
                    self.resets.fetch_add(1, Ordering::SeqCst);
                }
                _ => self.received.push_back(byte),
            }
        }
        self.record.overflowed |= self.received.len() > RECEIVE_BUFFER;
    }

    /// Takes one line, if there is one and nothing keeps it.
    fn line(&mut self) {
        if let Some((line, turns)) = self.waiting.take() {
            if !self.planner.is_empty() {
                self.waiting = Some((line, turns));
            } else if turns > 0 {
                self.waiting = Some((line, turns - 1));
            } else {
                self.after_motion(&line);
            }
            return;
        }
        if self.planner.len() >= PLANNER {
            return;
        }
        while let Some(byte) = self.received.pop_front() {
            if byte == b'\n' {
                let line = std::mem::take(&mut self.line);
                return self.execute(&line);
            }
            self.line.push(char::from(byte));
        }
    }

    fn execute(&mut self, line: &str) {
        match line {
            "$I" => self.say("[VER:1.1h.20190825:model]\r\n[OPT:V,15,128]\r\nok"),
            "$$" => self.say("$13=0\r\n$22=1\r\n$32=0\r\n$100=80.000\r\n$101=80.000\r\n$102=80.000\r\nok"),
            "$H" => self.waiting = Some((line.to_owned(), 50)),
            _ if self.state == State::Alarm => self.say("error:9"),
            "M5" | "M3 S1000" => self.waiting = Some((line.to_owned(), 0)),
            _ if line.starts_with("G4 P") => self.waiting = Some((line.to_owned(), 20)),
            _ => {
                let jog = line.strip_prefix("$J=G91 G21 ");
                let known = jog.unwrap_or(line).split(' ').all(|word| self.word(word, jog.is_some()));
                let target = self.planned.map(steps);
                if known && target != *self.planner.back().unwrap_or(&self.at) {
                    self.planner.push_back(target);
                }
                self.say(if known { "ok" } else { "error:20" });
            }
        }
    }

    fn word(&mut self, word: &str, jog: bool) -> bool {
        let (letter, number) = word.split_at(1);
        let value: f64 = number.parse().expect("a number");
        match word {
            "G90" => self.relative = false,
            "G91" => self.relative = true,
            "G0" | "G1" | "G21" | "G94" => {}
            _ if letter == "F" => {}
            _ => {
                let Some(axis) = ["X", "Y", "Z"].iter().position(|known| *known == letter) else {
                    return false;
                };
                self.planned[axis] = if self.relative || jog { self.planned[axis] + value } else { value };
            }
        }
        true
    }

    fn after_motion(&mut self, line: &str) {
        match line {
            "$H" => {
                self.state = State::Idle;
                self.at = [0; 3];
                self.planned = [0.0; 3];
            }
            "M3 S1000" => self.farthest = Some(0),
            "M5" => {
                if let Some(farthest) = self.farthest.take() {
                    let [feed, rotate, _] = self.at.map(units);
                    self.record.bends.push([feed, rotate, units(farthest)]);
                }
            }
            _ => {}
        }
        self.say("ok");
    }

    fn move_on(&mut self) {
        let Some(&target) = self.planner.front() else { return };
        for (at, target) in self.at.iter_mut().zip(target) {
            *at += (target - *at).clamp(-STEPS_A_TURN, STEPS_A_TURN);
        }
        if let Some(farthest) = &mut self.farthest
            && self.at[2].abs() > farthest.abs()
        {
            *farthest = self.at[2];
        }
        if self.at == target {
            self.planner.pop_front();
        }
    }

    fn report(&mut self) {
        let [x, y, z] = self.at.map(units);
        self.say(&format!("<{:?}|MPos:{x:.3},{y:.3},{z:.3}|FS:0,0>", self.state));
    }
}

#[allow(clippy::cast_precision_loss)] // a model's wire is short
fn units(steps: i64) -> f64 {
    steps as f64 / STEPS_PER_UNIT
}

#[allow(clippy::cast_possible_truncation)] // a model's wire is short
fn steps(units: f64) -> i64 {
    (units * STEPS_PER_UNIT).round() as i64
}
