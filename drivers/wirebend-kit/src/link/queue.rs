//! Numbered lines: sent in order, a few ahead, and again from where the controller says.

use std::collections::VecDeque;
use std::fmt::Write;

use super::{PATIENCE, Time};

/// Lines that may be unanswered at a time.
const WINDOW: u32 = 4;
/// Lines that the controller has room for; it may have room for one more while a line runs.
const ROOM: u32 = 8;
/// How long to wait before trying a full controller again; a line that is done is a reason to try at once.
const FULL: Time = Time::from_millis(200);

#[derive(Debug, Default)]
pub(super) struct Queue {
    /// Lines that are not known to be accepted; the first is `accepted + 1`.
    waiting: VecDeque<(u8, String)>,
    accepted: u32,
    done: u32,
    /// The last line that was sent.
    sent: u32,
    /// When to repeat unanswered lines.
    again_at: Time,
    full: bool,
}

impl Queue {
    /// For a session in which lines were accepted and done already.
    pub fn after(accepted: u32, done: u32) -> Self {
        Self { accepted, done, sent: accepted, ..Self::default() }
    }

    pub fn push(&mut self, letter: u8, numbers: &[i32]) -> u32 {
        let n = self.given() + 1;
        let mut payload = format!("{}{n}", char::from(letter));
        for number in numbers {
            let _ = write!(payload, ",{number}");
        }
        self.waiting.push_back((letter, payload));
        n
    }

    fn given(&self) -> u32 {
        self.accepted + u32::try_from(self.waiting.len()).unwrap_or(u32::MAX)
    }

    pub const fn is_outstanding(&self) -> bool {
        self.sent > self.done || self.accepted > self.done
    }

    /// Lines that are done, and lines that are accepted.
    pub const fn progress(&self) -> (u32, u32) {
        (self.done, self.accepted)
    }

    /// Drops lines that are not accepted.
    pub fn forget(&mut self) {
        self.waiting.clear();
        self.sent = self.accepted;
    }

    /// An alarm was reported: lines that were not accepted before it are not sent any more. Homing clears the alarm, and may
    /// have been requested after this report.
    pub fn alarmed(&mut self) {
        let homes = self.waiting.front().is_some_and(|&(letter, _)| letter == b'H');
        if !homes {
            self.forget();
        }
    }

    /// The controller has accepted every line up to this one; `None` when that was known.
    pub fn accepted(&mut self, last: u32, full: bool, now: Time) -> Option<u32> {
        self.full = full;
        if full {
            self.sent = last.min(self.given());
            self.again_at = now + FULL;
        }
        if last <= self.accepted || last > self.given() {
            return None;
        }
        self.waiting.drain(..(last - self.accepted) as usize);
        self.accepted = last;
        self.sent = self.sent.max(last);
        if !full {
            self.again_at = now + PATIENCE;
        }
        Some(last)
    }

    /// Every line up to this one is done.
    pub fn done(&mut self, n: u32, now: Time) -> Option<u32> {
        // A line that is done was accepted, even if that answer was lost.
        self.accepted(n, false, now);
        (n > self.done && n <= self.accepted).then(|| {
            self.done = n;
            n
        })
    }

    /// The controller expects this line next.
    pub fn go_back(&mut self, next: u32, now: Time) {
        if next > self.accepted && next <= self.given() {
            self.accepted(next - 1, false, now);
            self.sent = next - 1;
        }
    }

    /// Whether the first line that waits is the one that was refused; then none is sent any more.
    pub fn refused(&mut self, command: u8, next: u32) -> bool {
        let is_first = next == self.accepted + 1
            && self.sent > self.accepted
            && self.waiting.front().is_some_and(|&(letter, _)| letter == command);
        if is_first {
            self.forget();
        }
        is_first
    }

    /// The lines to send now.
    pub fn due(&mut self, now: Time) -> Vec<String> {
        let unanswered = self.sent > self.accepted || self.full;
        if unanswered && now >= self.again_at {
            self.sent = self.accepted;
            self.full = false;
        }
        let mut frames = Vec::new();
        let max = (self.accepted + WINDOW).min(self.done + ROOM).min(self.given());
        while !self.full && self.sent < max {
            frames.push(self.waiting[(self.sent - self.accepted) as usize].1.clone());
            self.sent += 1;
        }
        if !frames.is_empty() {
            self.again_at = now + PATIENCE;
        }
        frames
    }
}
