//! Time, from outside: the loop that makes a wire has no clock of its own, so that tests need not wait.

use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

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

const DAY_S: u64 = 86_400;

/// Seconds since 1970 as a date of the Gregorian calendar.
fn stamp(seconds: u64) -> String {
    let (mut days, of_day) = (seconds / DAY_S, seconds % DAY_S);
    let mut year = 1970;
    while days >= year_days(year) {
        days -= year_days(year);
        year += 1;
    }
    let february = year_days(year) - 337;
    let mut month = 1;
    for length in [31, february, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31] {
        if days < length {
            break;
        }
        days -= length;
        month += 1;
    }
    let (hour, minute, second) = (of_day / 3600, of_day / 60 % 60, of_day % 60);
    format!("{year:04}-{month:02}-{:02}T{hour:02}:{minute:02}:{second:02}Z", days + 1)
}

/// The time of a stamp of [`SystemClock`]; `None` for one that is none.
#[must_use]
pub fn stamped(stamp: &str) -> Option<SystemTime> {
    let (date, time) = stamp.strip_suffix('Z')?.split_once('T')?;
    let parts = |text: &str, by: char| {
        let numbers: Option<Vec<u64>> = text.split(by).map(|part| part.parse().ok()).collect();
        <[u64; 3]>::try_from(numbers?).ok()
    };
    let ([year, month, day], [hour, minute, second]) = (parts(date, '-')?, parts(time, ':')?);
    if !(1970..=9999).contains(&year) || !(1..=12).contains(&month) || !(1..=31).contains(&day) {
        return None;
    }
    if hour > 23 || minute > 59 || second > 59 {
        return None;
    }
    let february = year_days(year) - 337;
    let months = [31, february, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];
    let before: u64 = (1970..year).map(year_days).sum();
    let of_year: u64 = months.iter().zip(1..month).map(|(days, _)| days).sum();
    let seconds = (before + of_year + day - 1) * DAY_S + hour * 3600 + minute * 60 + second;
    UNIX_EPOCH.checked_add(Duration::from_secs(seconds))
}

const fn year_days(year: u64) -> u64 {
    if year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400)) { 366 } else { 365 }
}

#[cfg(test)]
mod tests {
    use super::*;

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
