//! Lines on their way to the machine.

use std::collections::VecDeque;
use std::time::Duration;

use crate::settings::Streaming;

/// grbl's receive buffer, bytes (`RX_BUFFER_SIZE`, `serial.h`). One is left free, since not every build of
/// the controller can use all of them.
const BUFFER_BYTES: usize = 128 - 1;

/// Lines that were not sent, and lines that were sent and not answered.
#[derive(Debug)]
pub(crate) struct Stream {
    streaming: Streaming,
    waiting: VecDeque<String>,
    /// In the order of their answers.
    sent: VecDeque<String>,
    /// When a line was last sent or answered.
    moved_at: Duration,
}

impl Stream {
    pub const fn new(streaming: Streaming) -> Self {
        Self { streaming, waiting: VecDeque::new(), sent: VecDeque::new(), moved_at: Duration::ZERO }
    }

    /// Takes lines. Blank ones are left out: the controller would answer them and do nothing.
    pub fn take(&mut self, lines: impl IntoIterator<Item = String>) {
        self.waiting.extend(lines.into_iter().filter(|line| !line.trim().is_empty()));
    }

    /// The next line that the machine has room for.
    pub fn next(&mut self, now: Duration) -> Option<String> {
        let length = self.waiting.front()?.len() + 1;
        let room = match self.streaming {
            Streaming::OneLineAtATime => self.sent.is_empty(),
            Streaming::CharacterCounting => {
                let used: usize = self.sent.iter().map(|line| line.len() + 1).sum();
                self.sent.is_empty() || used + length <= BUFFER_BYTES
            }
        };
        if !room {
            return None;
        }
        let line = self.waiting.pop_front()?;
        self.sent.push_back(line.clone());
        self.moved_at = now;
        Some(line)
    }

    /// The line that an answer belongs to; nothing when no line waits for one.
    pub fn answered(&mut self, now: Duration) -> Option<String> {
        self.moved_at = now;
        self.sent.pop_front()
    }

    /// Whether every line was sent and answered.
    pub fn is_empty(&self) -> bool {
        self.waiting.is_empty() && self.sent.is_empty()
    }

    /// The line whose answer is awaited, and since when nothing has moved.
    pub fn awaited(&self) -> Option<(&str, Duration)> {
        self.sent.front().map(|line| (line.as_str(), self.moved_at))
    }

    /// What was not sent is not sent any more; what was is still answered.
    pub fn drop_waiting(&mut self) {
        self.waiting.clear();
    }

    pub fn clear(&mut self) {
        self.waiting.clear();
        self.sent.clear();
    }
}

/// How long a line keeps the machine waiting by itself: the seconds of `G4 P…`.
pub(crate) fn dwell_of(line: &str) -> Duration {
    let code: String = line.chars().filter(|c| !c.is_whitespace()).collect::<String>().to_ascii_uppercase();
    let is_dwell = code.contains("G4P") || code.contains("G04P");
    let seconds = code.split_once('P').filter(|_| is_dwell).and_then(|(_, rest)| {
        let end = rest.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(rest.len());
        rest[..end].parse().ok()
    });
    seconds.and_then(|seconds| Duration::try_from_secs_f64(seconds).ok()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    const NOW: Duration = Duration::ZERO;

    fn filled(streaming: Streaming, lines: &[&str]) -> Stream {
        let mut stream = Stream::new(streaming);
        stream.take(lines.iter().map(|&line| line.to_owned()));
        stream
    }

    #[test]
    fn one_line_at_a_time_waits_for_each_answer() {
        let mut stream = filled(Streaming::OneLineAtATime, &["G21", "", " ", "G91"]);
        assert_eq!(stream.next(NOW).as_deref(), Some("G21"));
        assert_eq!(stream.next(NOW), None);
        assert_eq!(stream.answered(NOW).as_deref(), Some("G21"));
        assert_eq!(stream.next(NOW).as_deref(), Some("G91"));
        assert!(!stream.is_empty());
        assert_eq!(stream.answered(NOW).as_deref(), Some("G91"));
        assert!(stream.is_empty());
        assert_eq!(stream.answered(NOW), None);
    }

    #[test]
    fn counting_never_overfills_the_buffer() {
        // 13 lines of 10 bytes with their ends are 130: 12 of them fit into 127.
        let mut stream = filled(Streaming::CharacterCounting, &["G1 X1 F50"; 13]);
        assert_eq!(std::iter::from_fn(|| stream.next(NOW)).count(), 12);
        stream.answered(NOW);
        assert_eq!(std::iter::from_fn(|| stream.next(NOW)).count(), 1);
        // A line that is longer than the buffer goes alone: the controller empties it as it comes.
        let long = "x".repeat(200);
        let mut stream = filled(Streaming::CharacterCounting, &[&long, "G91"]);
        assert_eq!(std::iter::from_fn(|| stream.next(NOW)).count(), 1);
    }

    #[test]
    fn a_dwell_is_known_by_its_seconds() {
        let seconds = |line| dwell_of(line).as_secs_f64();
        for (line, expected) in [
            ("G4 P0.3", 0.3),
            ("N12 g04 p20 (rest)", 20.0),
            ("G1 X4 F500", 0.0),
            ("M3 S1000", 0.0),
            ("G4", 0.0),
        ] {
            assert!((seconds(line) - expected).abs() < 1e-9, "{line}");
        }
    }
}
