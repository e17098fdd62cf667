//! A machine on a table, and the shipped line to it.

use std::time::Duration;

use wirebend_driver_wirebend_kit::link::{Link, MachineEvent, Request};

use crate::board::{Board, MS};
use crate::table::Table;

/// What a computer's serial port delivers at once, ms.
const SLICE_MS: u64 = 1;
const SESSION: u16 = 0x1234;

/// The shipped line, which is served every millisecond.
pub struct Job<B> {
    pub table: Table<B>,
    /// The line to it.
    pub link: Link,
    passed_ms: u64,
    /// What the line has reported since the last [`Job::make`].
    pub events: Vec<MachineEvent>,
}

impl<B: Board> Job<B> {
    /// A line that is being opened.
    #[must_use]
    pub fn new(table: Table<B>) -> Self {
        let link = Link::new(SESSION, None, Duration::from_millis(500), Duration::ZERO);
        Self { table, link, passed_ms: 0, events: Vec::new() }
    }

    /// A homed machine with the settings that were compiled in; its next line has the number 2.
    ///
    /// # Panics
    /// When it does not home.
    #[must_use]
    pub fn ready() -> Self {
        let mut job = Self::new(Table::new());
        job.link.request(Request::LoadDefaults);
        job.until(2000, |event| matches!(event, MachineEvent::Answered(Request::LoadDefaults)));
        job.link.line(b'H', &[]);
        job.until(90_000, |event| *event == MachineEvent::Done(1));
        job
    }

    pub fn slice(&mut self) {
        self.table.board.send(&self.link.take_bytes());
        self.passed_ms += SLICE_MS;
        self.table.run_until(self.passed_ms * MS);
        let heard = std::mem::take(&mut self.table.bytes);
        self.link.advance(&heard, Duration::from_millis(self.passed_ms));
        self.events.extend(self.link.take_events());
    }

    /// Until there is such news among those that were not taken yet.
    ///
    /// # Panics
    /// When there is none in time.
    pub fn until(&mut self, max_ms: u64, mut is_it: impl FnMut(&MachineEvent) -> bool) {
        let end = self.passed_ms + max_ms;
        while !self.events.iter().any(&mut is_it) {
            assert!(self.passed_ms < end, "{}: not within {max_ms} ms: {:?}", B::NAME, self.events.last());
            self.slice();
        }
    }

    /// Runs lines `M`, and waits for the end of the last.
    ///
    /// # Panics
    /// When it is not done in time.
    pub fn make(&mut self, lines: &[[i32; 3]]) {
        let mut last = 0;
        for line in lines {
            last = self.link.line(b'M', line);
        }
        self.events.clear();
        let max_ms = lines.iter().map(|line| 60_000 + u64::from(line[0].unsigned_abs())).sum();
        self.until(max_ms, |event| *event == MachineEvent::Done(last));
    }
}
