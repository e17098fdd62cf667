//! Numbers with a fixed count of decimals, and what rounding did to them.

use wirebend_driver_api::Note;

/// What can be seen or measured on a wire: mm and degrees.
const VISIBLE: f64 = 0.05;

/// A number with so many decimals; what rounds to zero has no sign.
pub(crate) fn fixed(value: f64, decimals: u8) -> String {
    let places = usize::from(decimals);
    let text = format!("{value:.places$}");
    match text.strip_prefix('-') {
        Some(size) if is_zero(size) => size.to_owned(),
        _ => text,
    }
}

/// Whether a written number is zero.
pub(crate) fn is_zero(text: &str) -> bool {
    text.chars().all(|c| matches!(c, '0' | '.' | '-'))
}

/// The largest errors that rounding made, and how many can be seen.
#[derive(Debug, Default)]
pub(crate) struct Rounding {
    visible: usize,
    feed_mm: f64,
    angle_deg: f64,
}

impl Rounding {
    pub fn feed(&mut self, value: f64, written: &str) {
        self.feed_mm = self.feed_mm.max(self.error(value, written));
    }

    pub fn angle(&mut self, value: f64, written: &str) {
        self.angle_deg = self.angle_deg.max(self.error(value, written));
    }

    fn error(&mut self, value: f64, written: &str) -> f64 {
        let error = (value - written.parse().unwrap_or(value)).abs();
        // Half of the last digit is 0.05 for one decimal, give or take the last bit of a float.
        self.visible += usize::from(error > VISIBLE + 1e-9);
        error
    }

    /// What a person should know of it, where any of it can be seen.
    pub fn note(&self) -> Option<Note> {
        let Self { visible, feed_mm, angle_deg } = self;
        let message = format!(
            "values rounded by more than 0.05: {visible}; feeds by up to {feed_mm:.3} mm, angles by up to \
             {angle_deg:.3} degrees; raise 'decimals' in the driver's settings"
        );
        (*visible > 0).then(|| crate::note("rounded", *visible, message))
    }
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
