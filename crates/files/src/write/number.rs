//! Numbers with a fixed count of decimals.

/// A number with so many decimals; what rounds to zero has no sign.
pub(super) fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(size) if is_zero(size) => size.to_owned(),
        _ => text,
    }
}

/// Whether a written number is zero.
fn is_zero(text: &str) -> bool {
    text.chars().all(|c| matches!(c, '0' | '.' | ',' | '-'))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_machine_ever_reads_minus_zero() {
        assert_eq!(fixed(-0.0, 5), "0.00000");
        assert_eq!(fixed(-0.000_001, 5), "0.00000");
        assert_eq!(fixed(-0.000_009, 5), "-0.00001");
        assert_eq!(fixed(-0.4, 0), "0");
        assert_eq!(fixed(-133.786_218_4, 5), "-133.78622");
    }
}
