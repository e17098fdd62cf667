//! Numbers as people type them.

/// A number with a point or, as on many a keyboard, a comma before its decimals. A comma before three digits may set
/// thousands apart, and so it is no number.
pub(crate) fn number(text: &str) -> Option<f64> {
    let text = text.trim();
    let plain = match text.split_once(',') {
        Some((_, decimals)) if decimals.len() == 3 || decimals.contains([',', '.']) => return None,
        Some(_) => text.replace(',', "."),
        None => text.to_owned(),
    };
    plain.parse().ok().filter(|number: &f64| number.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_comma_is_a_point_where_it_can_be_nothing_else() {
        let read = ["12.5", "12,5", "-0,25", " 90 ", "1,0005"].map(number);
        assert_eq!(read, [Some(12.5), Some(12.5), Some(-0.25), Some(90.0), Some(1.0005)]);
        for refused in ["", "ten", "1,000", "1,000.5", "1,2,3", "1.000,5", "nan", "inf", "-inf", "1e400"] {
            assert_eq!(number(refused), None, "{refused}");
        }
    }
}
