//! What rounding did to the numbers of a script.

use wirebend_driver_api::Note;

/// What can be seen or measured on a wire: mm and degrees.
const VISIBLE: f64 = 0.05;

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
