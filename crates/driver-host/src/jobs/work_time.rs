//! How long a machine is at work on a wire: in all of its parts, without what it holds for, and without what people think about between them.

use std::time::{Duration, SystemTime};

use super::clock::stamped;
use super::entry::{Entry, EntryKind};

#[derive(Debug, Clone, Copy, Default)]
pub(super) struct WorkTime {
    before: Duration,
    since: Option<Duration>,
}

/// Whether the machine begins to work, or rests, with what happened; nothing changes with all else.
const fn works(what: &EntryKind) -> Option<bool> {
    match what {
        EntryKind::Armed { .. } | EntryKind::Resumed => Some(true),
        EntryKind::Paused
        | EntryKind::Stopped { .. }
        | EntryKind::Fault { .. }
        | EntryKind::Finished
        | EntryKind::Abandoned => Some(false),
        _ => None,
    }
}

impl WorkTime {
    /// From what was written down. Where the program has ended meanwhile, it counts up to the last entry before.
    pub fn of(entries: &[Entry]) -> Self {
        let (mut before, mut since): (Duration, Option<SystemTime>) = (Duration::ZERO, None);
        let mut last = None;
        for Entry { at, what } in entries {
            let at = stamped(at);
            let ended = matches!(what, EntryKind::Connected { .. });
            let until = if ended { last } else { at };
            match (if ended { Some(false) } else { works(what) }, since) {
                (Some(true), None) => since = at,
                (Some(false), Some(from)) => {
                    before += until.and_then(|until| until.duration_since(from).ok()).unwrap_or_default();
                    since = None;
                }
                _ => {}
            }
            last = at.or(last);
        }
        Self { before, since: None }
    }

    /// Something happens.
    pub fn take(&mut self, what: &EntryKind, now: Duration) {
        match works(what) {
            Some(true) => {
                self.since.get_or_insert(now);
            }
            Some(false) => *self = Self { before: self.until(now), since: None },
            None => {}
        }
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

    /// 10 s, a hold, 5 s, a stop; 20 s until the program ended, of which the last is known by a step at 12 s.
    #[test]
    fn what_a_machine_waits_for_does_not_count() {
        let entries = [
            entry("00:00", connected()),
            entry("01:00", armed()),
            entry("01:10", EntryKind::Paused),
            entry("02:00", EntryKind::Resumed),
            entry("02:05", EntryKind::Stopped { by: None }),
            entry("10:00", connected()),
            entry("11:00", armed()),
            entry("11:12", EntryKind::Done { n: 1 }),
            entry("20:00", connected()),
        ];
        let s = Duration::from_secs;
        let mut time = WorkTime::of(&entries);
        assert_eq!(time.until(s(1000)), s(27));
        time.take(&armed(), s(1000));
        time.take(&EntryKind::Done { n: 2 }, s(1003));
        assert_eq!(time.until(s(1004)), s(31));
        time.take(&EntryKind::Finished, s(1005));
        assert_eq!(time.until(s(2000)), s(32));
    }
}
