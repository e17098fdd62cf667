//! Numbers as a person reads them.

use wirebend_api::number::{fixed, thousands};

/// A length with one decimal and its thousands apart.
pub(crate) fn mm(value: f64) -> String {
    thousands(&fixed(value, 1))
}

/// So many decimals, and as many more as three significant figures need.
pub(crate) fn figures(value: f64, decimals: usize) -> String {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a whole number from 0 to 15
    let needed = (2.0 - value.abs().log10().floor()).clamp(0.0, 15.0) as usize;
    let decimals = if value == 0.0 { decimals } else { decimals.max(needed) };
    format!("{value:.decimals$}")
}

/// So many decimals; what they cannot show is told to be less.
pub(crate) fn or_less(value: f64, decimals: usize) -> String {
    let least = 0.1_f64.powi(i32::try_from(decimals).unwrap_or(0));
    if value > 0.0 && value < least { format!("< {least:.decimals$}") } else { format!("{value:.decimals$}") }
}

/// A duration as hours, minutes and seconds, from the largest that is needed.
pub(crate) fn duration(seconds: f64) -> String {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // not negative, far below 2^64
    let whole = seconds.max(0.0).round() as u64;
    let (hours, minutes, seconds) = (whole / 3600, whole / 60 % 60, whole % 60);
    match (hours, minutes) {
        (0, 0) => format!("{seconds} s"),
        (0, _) => format!("{minutes} min {seconds:02} s"),
        _ => format!("{hours} h {minutes:02} min"),
    }
}

/// A number of things.
pub(crate) fn count(number: usize, one: &str, many: &str) -> String {
    format!("{number} {}", if number == 1 { one } else { many })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thousands_stand_apart() {
        assert_eq!(mm(11821.353), "11\u{202f}821.4");
        assert_eq!(mm(999.96), "1\u{202f}000.0");
        assert_eq!(mm(-0.04), "0.0");
        assert_eq!(mm(-1234.5), "-1\u{202f}234.5");
    }

    #[test]
    fn what_is_small_is_not_shown_as_nothing() {
        let shown = [0.0, 4.2e-6, 1.43e-5, 0.003_5, 2.5].map(|sigma| figures(sigma, 5));
        assert_eq!(shown, ["0.00000", "0.00000420", "0.0000143", "0.00350", "2.50000"]);
        let shown = [0.0, 1e-5, 0.000_14, 0.427_187].map(|moved| or_less(moved, 4));
        assert_eq!(shown, ["0.0000", "< 0.0001", "0.0001", "0.4272"]);
    }

    #[test]
    fn durations_start_with_what_is_needed() {
        assert_eq!(duration(8.4), "8 s");
        assert_eq!(duration(141.0), "2 min 21 s");
        assert_eq!(duration(3600.0 * 2.0 + 59.0), "2 h 00 min");
    }
}
