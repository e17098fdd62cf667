//! Time, from outside: the loop that runs a wire has no clock of its own, so that tests need not wait.

use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use jiff::Timestamp;
use jiff::civil::Date;

/// What time it is, for measuring and for people.
pub trait Clock {
    /// Time since some fixed moment. It never goes back.
    fn now(&self) -> Duration;

    /// The time of day, as people shall read it in journals and records.
    fn stamp(&self) -> String;
}

/// The clock of the computer. Its stamps are UTC, such as `2026-05-01T09:30:00Z`.
#[derive(Debug, Clone, Copy)]
pub struct SystemClock {
    begun: Instant,
}

impl Default for SystemClock {
    fn default() -> Self {
        Self { begun: Instant::now() }
    }
}

impl Clock for SystemClock {
    fn now(&self) -> Duration {
        self.begun.elapsed()
    }

    fn stamp(&self) -> String {
        // A clock that is set before 1970 is as good as none.
        stamp(SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default().as_secs())
    }
}

/// Seconds since 1970 as a date of the Gregorian calendar.
fn stamp(seconds: u64) -> String {
    let at = i64::try_from(seconds).ok().and_then(|seconds| Timestamp::from_second(seconds).ok());
    at.unwrap_or(Timestamp::MAX).to_string()
}

/// The time of day in UTC, to a millisecond, such as `2026-05-01T09:30:00.250Z`.
#[must_use]
pub fn stamp_to_ms() -> String {
    format!("{:.3}", Timestamp::now())
}

/// The time of a stamp of [`SystemClock`]; `None` for one that is none.
#[must_use]
pub fn stamped(stamp: &str) -> Option<SystemTime> {
    let at: Timestamp = stamp.strip_suffix('Z').and(stamp.parse().ok())?;
    // A clock that is set before 1970 gives no such stamp.
    (at >= Timestamp::UNIX_EPOCH).then(|| at.into())
}

/// Whether a text is a day of the calendar, such as `2026-05-01`, and nothing else.
#[must_use]
pub fn is_day(text: &str) -> bool {
    // The reader takes a time behind a day, too.
    text.parse::<Date>().is_ok_and(|day| day.to_string() == text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_day_is_one_of_the_calendar() {
        for day in ["2026-11-25", "2024-02-29", "2000-01-01"] {
            assert!(is_day(day), "{day}");
        }
        for none in [
            "2026-13-45",
            "2026-02-29",
            "01.02.2026",
            "yesterday",
            "",
            "2026-11-25T10:00:00Z",
            "20261125",
            "2026-11-25 ",
            "26-11-25",
            "2026-W48-3",
        ] {
            assert!(!is_day(none), "{none}");
        }
    }

    /// Seconds by `date -u -d … +%s`.
    #[test]
    fn stamps_are_dates() {
        let dates = [
            (0, "1970-01-01T00:00:00Z"),
            (951_782_399, "2000-02-28T23:59:59Z"),
            (951_782_400, "2000-02-29T00:00:00Z"),
            (1_709_251_199, "2024-02-29T23:59:59Z"),
            (1_767_225_599, "2025-12-31T23:59:59Z"),
            (1_767_225_600, "2026-01-01T00:00:00Z"),
            (4_107_542_400, "2100-03-01T00:00:00Z"),
        ];
        for (seconds, date) in dates {
            assert_eq!(stamp(seconds), date);
            assert_eq!(stamped(date), UNIX_EPOCH.checked_add(Duration::from_secs(seconds)));
        }
    }

    #[test]
    fn what_is_no_stamp_has_no_time() {
        for text in [
            "",
            "2026-05-01",
            "2026-13-01T00:00:00Z",
            "2026-05-01T24:00:00Z",
            "1969-12-31T23:59:59Z",
            "step 1",
        ] {
            assert_eq!(stamped(text), None, "{text}");
        }
    }
}
