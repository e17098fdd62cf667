//! A machine on a table, and the shipped line to it.

use std::time::Duration;

use wirebend_driver_wirebend_kit::link::{Ask, Link, News};

use crate::board::{Board, MS};
use crate::table::Table;

/// What a computer's serial port delivers at once, ms.
const SLICE_MS: u64 = 1;
const SESSION: u16 = 0x1234;

/// The shipped line, which is served every millisecond.
pub struct Job<B> {
    /// The machine.
    pub table: Table<B>,
    /// The line to it.
    pub link: Link,
    passed_ms: u64,
    /// What the line has told since the last [`Job::make`].
    pub news: Vec<News>,
}

impl<B: Board> Job<B> {
    /// A line that is being opened.
    #[must_use]
    pub fn new(table: Table<B>) -> Self {
        let link = Link::new(SESSION, None, Duration::from_millis(500), Duration::ZERO);
        Self { table, link, passed_ms: 0, news: Vec::new() }
    }

    /// A homed machine with the settings that were compiled in; its next line has the number 2.
    ///
    /// # Panics
    /// When it does not home.
    #[must_use]
    pub fn ready() -> Self {
        let mut job = Self::new(Table::new());
        job.link.ask(Ask::LoadDefaults);
        job.until(2000, |news| matches!(news, News::Answered(Ask::LoadDefaults)));
        job.link.line(b'H', &[]);
        job.until(90_000, |news| *news == News::Done(1));
        job
    }

    /// One millisecond.
    pub fn slice(&mut self) {
        self.table.board.send(&self.link.take_bytes());
        self.passed_ms += SLICE_MS;
        self.table.run_until(self.passed_ms * MS);
        let heard = std::mem::take(&mut self.table.bytes);
        self.link.advance(&heard, Duration::from_millis(self.passed_ms));
        self.news.extend(self.link.take_news());
    }

    /// Until there is such news among those that nobody has taken.
    ///
    /// # Panics
    /// When there is none in time.
    pub fn until(&mut self, most_ms: u64, mut is_it: impl FnMut(&News) -> bool) {
        let end = self.passed_ms + most_ms;
        while !self.news.iter().any(&mut is_it) {
            assert!(self.passed_ms < end, "{}: not within {most_ms} ms: {:?}", B::NAME, self.news.last());
            self.slice();
        }
    }

    /// Makes lines `M`, and waits for the end of the last.
    ///
    /// # Panics
    /// When it is not made in time.
    pub fn make(&mut self, lines: &[[i32; 3]]) {
        let mut last = 0;
        for line in lines {
            last = self.link.line(b'M', line);
        }
        self.news.clear();
        let most = lines.iter().map(|line| 60_000 + u64::from(line[0].unsigned_abs())).sum();
        self.until(most, |news| *news == News::Done(last));
    }
}
