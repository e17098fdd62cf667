//! Numbers as text: the one place for files, messages and the command line.
//!
//! Drivers know none of this and have [the same for programs of machines](../../driver-api/src/number.rs).

use wirebend_core::units::DisplayUnit;

const MM_PER_INCH: f64 = 25.4;

/// Millimetres as a number of the unit, with so many decimals in millimetres, or so many in inches.
#[must_use]
pub fn length_in(unit: DisplayUnit, mm: f64, [in_mm, in_inches]: [usize; 2]) -> String {
    match unit {
        DisplayUnit::Millimetre => fixed(mm, in_mm),
        DisplayUnit::Inch => fixed(mm / MM_PER_INCH, in_inches),
    }
}

/// "mm" or "in".
#[must_use]
pub const fn unit_name(unit: DisplayUnit) -> &'static str {
    match unit {
        DisplayUnit::Millimetre => "mm",
        DisplayUnit::Inch => "in",
    }
}

/// A unit as it stands in a sentence: "mm" or "inches".
#[must_use]
pub const fn unit_word(unit: DisplayUnit) -> &'static str {
    match unit {
        DisplayUnit::Millimetre => "mm",
        DisplayUnit::Inch => "inches",
    }
}

/// A number with so many decimals; what rounds to zero has no sign.
#[must_use]
pub fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(size) if size.chars().all(|c| matches!(c, '0' | '.')) => size.to_owned(),
        _ => text,
    }
}

/// A number with up to so many decimals, one or more: no zeros at its end.
#[must_use]
pub fn short(value: f64, decimals: usize) -> String {
    fixed(value, decimals).trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// A written number with its thousands apart, from four digits on.
#[must_use]
pub fn thousands(text: &str) -> String {
    const SPACE: char = '\u{202f}'; // narrow, and no line is broken there
    let (sign, size) = text.strip_prefix('-').map_or(("", text), |size| ("-", size));
    let (whole, decimals) = size.split_at(size.find('.').unwrap_or(size.len()));
    let mut apart = sign.to_owned();
    for (k, digit) in whole.chars().enumerate() {
        if k > 0 && (whole.len() - k).is_multiple_of(3) {
            apart.push(SPACE);
        }
        apart.push(digit);
    }
    apart + decimals
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nobody_ever_reads_minus_zero() {
        assert_eq!(fixed(-0.0, 5), "0.00000");
        assert_eq!(fixed(-0.000_001, 5), "0.00000");
        assert_eq!(fixed(-0.000_009, 5), "-0.00001");
        assert_eq!(fixed(-0.4, 0), "0");
        assert_eq!(fixed(-133.786_218_4, 5), "-133.78622");
        assert_eq!(fixed(f64::NEG_INFINITY, 1), "-inf");
    }

    #[test]
    fn lengths_are_numbers_of_their_unit() {
        let both = [DisplayUnit::Millimetre, DisplayUnit::Inch];
        assert_eq!(both.map(|unit| length_in(unit, 63.5, [1, 3])), ["63.5", "2.500"]);
        assert_eq!(both.map(unit_name), ["mm", "in"]);
    }

    #[test]
    fn no_digit_too_many() {
        assert_eq!([short(10.0, 2), short(-0.25, 3), short(-1e-9, 5)], ["10", "-0.25", "0"]);
    }

    #[test]
    fn large_numbers_are_grouped() {
        for (number, text) in [
            ("0", "0"),
            ("999", "999"),
            ("1000", "1\u{202f}000"),
            ("-1234.5", "-1\u{202f}234.5"),
            ("1234567.1234", "1\u{202f}234\u{202f}567.1234"),
        ] {
            assert_eq!(thousands(number), text);
        }
    }
}
