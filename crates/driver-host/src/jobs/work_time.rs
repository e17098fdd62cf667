//! How long a machine is at work on a wire: in all of its parts, without what it holds for, and without what people think about between them.

use std::time::{Duration, SystemTime};

use super::clock::stamped;
use super::entry::{Entry, EntryKind};

#[derive(Debug, Clone, Copy, Default)]
pub(super) struct WorkTime {
    before: Duration,
    since: Option<Duration>,
    /// The last step that was sent, or was about to be, and the last that is done.
    sent: u32,
    done: u32,
}

impl WorkTime {
    /// From what was written down. Where the program has ended meanwhile, it counts up to the last entry before.
    pub fn of(entries: &[Entry]) -> Self {
        let first = entries.iter().find_map(|entry| stamped(&entry.at));
        let since_first = |at: SystemTime| first.and_then(|first| at.duration_since(first).ok());
        let (mut time, mut last) = (Self::default(), Duration::ZERO);
        for Entry { at, what } in entries {
            let now = stamped(at).and_then(since_first).unwrap_or(last);
            if matches!(what, EntryKind::Connected { .. }) {
                time.rests(last);
            } else {
                time.take(what, now);
            }
            last = now;
        }
        time.rests(last);
        time
    }

    /// Something happens.
    pub fn take(&mut self, what: &EntryKind, now: Duration) {
        match what {
            EntryKind::Intent { to, .. } => {
                self.sent = *to;
                self.works(now);
            }
            EntryKind::NotTaken { after } => self.sent = *after,
            // With nothing in hand it waits for a person, at a pause point or at the end.
            EntryKind::Resumed | EntryKind::Armed { resumed: true, .. } if self.sent > self.done => {
                self.works(now);
            }
            EntryKind::Done { n } => {
                self.done = *n;
                if self.done >= self.sent {
                    self.rests(now);
                }
            }
            EntryKind::Paused
            | EntryKind::Stopped { .. }
            | EntryKind::Fault { .. }
            | EntryKind::Finished
            | EntryKind::Abandoned => self.rests(now),
            _ => {}
        }
    }

    fn works(&mut self, now: Duration) {
        self.since.get_or_insert(now);
    }

    fn rests(&mut self, now: Duration) {
        (self.before, self.since) = (self.until(now), None);
    }

    /// All of it by now.
    pub fn until(&self, now: Duration) -> Duration {
        self.before + self.since.map_or(Duration::ZERO, |since| now.saturating_sub(since))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entry(at: &str, what: EntryKind) -> Entry {
        Entry { at: format!("2026-05-01T09:{at}.000Z"), what }
    }

    fn connected() -> EntryKind {
        EntryKind::Connected { identity: String::new(), resume: None }
    }

    const fn armed() -> EntryKind {
        EntryKind::Armed { token: None, after: 0, resumed: false }
    }

    const fn sent(from: u32, to: u32) -> EntryKind {
        EntryKind::Intent { from, to }
    }

    /// 10 s, a hold, 5 s, a stop; 12 s until the last that is known before the program ended. Ten minutes at a pause point after step 2, and 3 s
    /// for the last.
    #[test]
    fn what_a_machine_waits_for_does_not_count() {
        let entries = [
            entry("00:00", connected()),
            entry("01:00", armed()),
            entry("01:00", sent(1, 2)),
            entry("01:10", EntryKind::Paused),
            entry("02:00", EntryKind::Resumed),
            entry("02:05", EntryKind::Stopped { by: None }),
            entry("10:00", connected()),
            entry("11:00", armed()),
            entry("11:00", sent(1, 2)),
            entry("11:12", EntryKind::Done { n: 1 }),
            entry("20:00", connected()),
        ];
        let s = Duration::from_secs;
        let mut time = WorkTime::of(&entries);
        assert_eq!(time.until(s(1000)), s(27));
        time.take(&armed(), s(1000));
        assert_eq!(time.until(s(1001)), s(27), "it has nothing to do yet");
        time.take(&sent(2, 2), s(1001));
        time.take(&EntryKind::Done { n: 2 }, s(1005));
        for waits in
            [EntryKind::Armed { token: None, after: 2, resumed: true }, EntryKind::Paused, EntryKind::Resumed]
        {
            time.take(&waits, s(1100));
        }
        assert_eq!(time.until(s(1600)), s(31), "it waits at the pause point");
        time.take(&EntryKind::PauseConfirmed { after: 2, note: String::new() }, s(1605));
        time.take(&sent(3, 3), s(1605));
        assert_eq!(time.until(s(1607)), s(33));
        time.take(&EntryKind::Done { n: 3 }, s(1608));
        time.take(&EntryKind::Finished, s(1609));
        assert_eq!(time.until(s(2000)), s(34));
    }
}
