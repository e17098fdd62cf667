//! A small grbl on the other side of a cable, without a line of the driver: it takes lines into a planner of its own,
//! answers `ok` when they are planned, and says `Idle` when they are done. What it sends at a reset and at an alarm was
//! compared with grbl 1.1h (build 20190830) on a simulated `ATmega328P`; drivers/grbl/README.md has what came of it.

mod controller;
mod lines;

use std::io::{Read, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};

pub use controller::Controller;

/// Steps for each unit of every axis.
pub const STEPS_PER_UNIT: f64 = 80.0;

/// How a model is built, and what happens to it.
#[derive(Debug, Clone)]
pub struct Build {
    /// It has switches and homes by them; otherwise `$22=0`, and it starts unlocked.
    pub switches: bool,
    /// Steps of a turn of its loop, which takes about a millisecond.
    pub steps_a_turn: i64,
    /// A byte that the cable changes, once.
    pub change: Option<Change>,
    /// Soft limits are on: its bend axis, whose zero is where it homes, goes so far up and no way down.
    pub bend_travel: Option<f64>,
    /// What it says that its bend axis does at most, units a minute; otherwise the truth.
    pub bend_rate: Option<f64>,
}

impl Default for Build {
    fn default() -> Self {
        Self { switches: true, steps_a_turn: 40, change: None, bend_travel: None, bend_rate: None }
    }
}

/// A byte of a line that arrives as another one.
#[derive(Debug, Clone)]
pub struct Change {
    /// The line as it was sent; the first such line is changed.
    pub line: String,
    pub at: usize,
    pub to: u8,
}

/// What the model has done.
#[derive(Debug, Default, Clone, PartialEq)]
pub struct Record {
    /// Where feed and rotation stood when the pin was put out, and the farthest that the bend axis was while it was.
    pub bends: Vec<[f64; 3]>,
    /// Where the feed really was whenever the cutter was on.
    pub cuts: Vec<f64>,
    /// Where the axes stand.
    pub at: [f64; 3],
    /// More bytes came at once than the buffer holds.
    pub overflowed: bool,
    pub resets: usize,
}

/// What happens at the machine while it runs.
#[derive(Debug, Default)]
pub struct Events {
    end: AtomicBool,
    /// A limit switch closes.
    limit: AtomicBool,
    /// The power goes off and comes back, or the board's own reset is pressed: it counts from zero again.
    power: AtomicBool,
    now: Mutex<Now>,
}

/// What can be seen of the machine at any time.
#[derive(Debug, Default, Clone, Copy)]
pub struct Now {
    /// Where the axes stand.
    pub at: [f64; 3],
    pub pin_out: bool,
    pub resets: usize,
    /// What a hand has turned the axes by, which the controller knows nothing of.
    hand: [f64; 3],
}

/// A running model. It ends when it is ordered to or dropped, and with it the cable.
pub struct Model {
    events: Arc<Events>,
    /// Nothing once it was ordered to end.
    thread: Option<JoinHandle<Record>>,
}

impl Drop for Model {
    fn drop(&mut self) {
        self.events.end.store(true, Ordering::SeqCst);
    }
}

impl Model {
    /// At a port whose reads wait for about a millisecond.
    pub fn run(port: impl Read + Write + Send + 'static, build: Build) -> Self {
        let events = Arc::new(Events::default());
        let told = Arc::clone(&events);
        let thread = thread::spawn(move || Controller::new(port, build, told).run());
        Self { events, thread: Some(thread) }
    }

    pub fn now(&self) -> Now {
        *self.events.now.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// How often it has been reset so far.
    pub fn resets(&self) -> usize {
        self.now().resets
    }

    /// A limit switch closes.
    pub fn hit_limit(&self) {
        self.events.limit.store(true, Ordering::SeqCst);
    }

    /// The power fails for a moment.
    pub fn cut_power(&self) {
        self.events.power.store(true, Ordering::SeqCst);
    }

    /// A person turns the head and the bend axis to their marks by hand. A feed has none, and the wire is left where it is.
    pub fn turn_to_marks(&self) {
        let mut now = self.events.now.lock().unwrap_or_else(PoisonError::into_inner);
        now.hand[1] -= now.at[1];
        now.hand[2] -= now.at[2];
    }

    pub fn end(mut self) -> Record {
        self.events.end.store(true, Ordering::SeqCst);
        let thread = self.thread.take().expect("it runs");
        thread.join().expect("the model does not fail")
    }
}

impl Events {
    fn ended(&self) -> bool {
        self.end.load(Ordering::SeqCst)
    }

    fn takes(flag: &AtomicBool) -> bool {
        flag.swap(false, Ordering::SeqCst)
    }

    /// Reports how the machine is; what a hand has done to it comes back.
    fn tell(&self, steps: [f64; 3], pin_out: bool, resets: usize) -> [f64; 3] {
        let mut now = self.now.lock().unwrap_or_else(PoisonError::into_inner);
        let at = std::array::from_fn(|axis| steps[axis] + now.hand[axis]);
        (now.at, now.pin_out, now.resets) = (at, pin_out, resets);
        at
    }
}
