//! A machine on a table: a controller, its bend axis and the switch that the axis meets.

use crate::board::{BEND, Board, Observation, Reset, What};

/// Where the bend axis of a new machine really stands, steps from zero.
pub const AT_FIRST: i64 = -3000;
/// The edge of its switch: that of the shipped settings.
pub const EDGE: i64 = -9547;

/// Whether the switch reads as pressed with the bend axis at a place, steps.
pub type Switch = Box<dyn FnMut(i64) -> bool>;

/// A controller with its bend axis and its switch.
pub struct Table<B> {
    pub board: B,
    switch: Switch,
    /// Where the bend axis really stands, steps from zero.
    pub bend: i64,
    /// Steps since the first power-on, by axis.
    pub counted: [i64; 3],
    /// Everything that was seen but bytes.
    pub seen: Vec<Observation>,
    /// Bytes to the host that were not taken.
    pub bytes: Vec<u8>,
}

impl<B: Board> Default for Table<B> {
    fn default() -> Self {
        Self::new()
    }
}

impl<B: Board> Table<B> {
    /// One whose switch is where the shipped settings say.
    #[must_use]
    pub fn new() -> Self {
        Self::with_switch(Box::new(|bend| bend <= EDGE))
    }

    /// One with another switch.
    #[must_use]
    pub fn with_switch(switch: Switch) -> Self {
        let (counted, seen, bytes) = ([0; 3], Vec::new(), Vec::new());
        let mut table = Self { board: B::new(), switch, bend: AT_FIRST, counted, seen, bytes };
        table.look_at_switch();
        table
    }

    /// Turns the bend axis by hand, steps from zero.
    pub fn turn_to(&mut self, bend: i64) {
        self.bend = bend;
        self.look_at_switch();
    }

    /// Another switch from now on.
    pub fn set_switch(&mut self, switch: Switch) {
        self.switch = switch;
        self.look_at_switch();
    }

    fn look_at_switch(&mut self) {
        self.board.set_switch((self.switch)(self.bend));
    }

    /// Lets the machine run for so many cycles.
    pub fn run(&mut self, cycles: u64) {
        self.run_until(self.board.now() + cycles);
    }

    /// Lets it run until a cycle.
    pub fn run_until(&mut self, cycle: u64) {
        loop {
            let seen = self.board.run(cycle);
            if seen.is_empty() && self.board.now() >= cycle {
                return;
            }
            for seen in seen {
                self.saw(seen);
            }
        }
    }

    fn saw(&mut self, seen: Observation) {
        match seen.what {
            What::Byte(byte) => return self.bytes.push(byte),
            What::Pulse { axis, forward } => {
                let way = if forward { 1 } else { -1 };
                self.counted[axis] += way;
                if axis == BEND {
                    self.bend += way;
                    self.look_at_switch();
                }
            }
            What::Servo { .. } | What::Motors(_) => {}
        }
        self.seen.push(seen);
    }

    /// A reset; what the host has not taken is lost.
    pub fn reset(&mut self, cause: Reset) {
        self.board.reset(cause);
        self.bytes.clear();
    }

    /// Pulses since the first power-on.
    #[must_use]
    pub fn pulses(&self) -> usize {
        self.seen.iter().filter(|seen| matches!(seen.what, What::Pulse { .. })).count()
    }
}
