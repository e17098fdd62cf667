//! Numbered lines: sent in order, a few ahead, and again from where the controller says.

use std::collections::VecDeque;
use std::fmt::Write;

use super::{PATIENCE, Time};

/// Lines that may be on their way without an answer.
const WINDOW: u32 = 4;
/// Lines that the controller has room for. A line that it makes leaves room for one more, which is not counted on.
const ROOM: u32 = 8;
/// A full controller is tried again after so long; a line that it has made is a reason to try at once.
const FULL: Time = Time::from_millis(200);

#[derive(Debug, Default)]
pub(super) struct Queue {
    /// Lines that the controller has not taken, as far as is known; the first is `accepted + 1`.
    waiting: VecDeque<(u8, String)>,
    accepted: u32,
    done: u32,
    /// The last that was sent since the last repetition.
    sent: u32,
    /// When to send again what was not answered.
    again_at: Time,
    full: bool,
}

impl Queue {
    /// Of a session in which lines were taken and made already.
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

    /// Lines that were made, and lines that were taken.
    pub const fn progress(&self) -> (u32, u32) {
        (self.done, self.accepted)
    }

    /// What was not taken yet is not sent any more.
    pub fn forget(&mut self) {
        self.waiting.clear();
        self.sent = self.accepted;
    }

    /// An alarm is told: what was not taken before it is not sent any more. A search for the reference leaves the
    /// alarm, and may have been asked for after what is told here.
    pub fn alarmed(&mut self) {
        let homes = self.waiting.front().is_some_and(|&(letter, _)| letter == b'H');
        if !homes {
            self.forget();
        }
    }

    /// The controller has taken every line up to this one; `None` when that is no news.
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

    /// It has made every line up to this one.
    pub fn done(&mut self, n: u32, now: Time) -> Option<u32> {
        // What is made was taken, though the answer may have been lost.
        self.accepted(n, false, now);
        (n > self.done && n <= self.accepted).then(|| {
            self.done = n;
            n
        })
    }

    /// It expects this one next.
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

    /// The lines that are to be sent now.
    pub fn due(&mut self, now: Time) -> Vec<String> {
        let unanswered = self.sent > self.accepted || self.full;
        if unanswered && now >= self.again_at {
            self.sent = self.accepted;
            self.full = false;
        }
        let mut frames = Vec::new();
        let most = (self.accepted + WINDOW).min(self.done + ROOM).min(self.given());
        while !self.full && self.sent < most {
            frames.push(self.waiting[(self.sent - self.accepted) as usize].1.clone());
            self.sent += 1;
        }
        if !frames.is_empty() {
            self.again_at = now + PATIENCE;
        }
        frames
    }
}
