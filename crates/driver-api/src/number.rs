//! Numbers as text, for programs of machines.

/// A number with so many decimals; what rounds to zero has no sign, which some machines refuse.
///
/// ```
/// use wirebend_driver_api::fixed;
/// assert_eq!([fixed(-90.0, 3), fixed(-0.0004, 3), fixed(1.5, 0)], ["-90.000", "0.000", "2"]);
/// ```
#[must_use]
pub fn fixed(value: f64, decimals: u8) -> String {
    let text = format!("{value:.places$}", places = usize::from(decimals));
    match text.strip_prefix('-') {
        Some(size) if is_zero(size) => size.to_owned(),
        _ => text,
    }
}

/// Whether a written number is zero.
#[must_use]
pub fn is_zero(text: &str) -> bool {
    text.chars().all(|c| matches!(c, '0' | '.' | '-'))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_machine_ever_reads_minus_zero() {
        assert_eq!(fixed(-0.0, 5), "0.00000");
        assert_eq!(fixed(-0.000_001, 5), "0.00000");
        assert_eq!(fixed(-0.000_009, 5), "-0.00001");
        assert_eq!([fixed(-0.000_500_1, 3), fixed(30.0, 3)], ["-0.001", "30.000"]);
        assert_eq!(fixed(-0.4, 0), "0");
        assert_eq!(fixed(-133.786_218_4, 5), "-133.78622");
    }

    #[test]
    fn zero_is_told_from_small_numbers() {
        assert_eq!(["0", "-0.00", "0.01", "-90"].map(is_zero), [true, true, false, false]);
    }
}
