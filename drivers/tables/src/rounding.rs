//! What rounding did, for a person to know where it can be seen.

use wirebend_driver_api::Note;

/// What can be seen or measured on a wire: mm and degrees.
const VISIBLE: f64 = 0.05;

/// The largest errors of single values, and how many can be seen.
#[derive(Debug, Default)]
pub(crate) struct Rounding {
    visible: usize,
    length_mm: f64,
    angle_deg: f64,
}

impl Rounding {
    pub fn length(&mut self, exact_mm: f64, written_mm: f64) {
        let error = (exact_mm - written_mm).abs();
        self.length_mm = self.length_mm.max(error);
        self.count(error);
    }

    /// Angles that differ by whole turns are the same.
    pub fn angle(&mut self, exact_deg: f64, written_deg: f64) {
        let turn = (exact_deg - written_deg).rem_euclid(360.0);
        let error = turn.min(360.0 - turn);
        self.angle_deg = self.angle_deg.max(error);
        self.count(error);
    }

    fn count(&mut self, error: f64) {
        // Half of the last digit is 0.05 for one decimal, give or take the last bit of a float.
        self.visible += usize::from(error > VISIBLE + 1e-9);
    }

    pub fn note(&self) -> Option<Note> {
        let Self { visible, length_mm, angle_deg } = self;
        let message = format!(
            "values rounded by more than 0.05: {visible}; lengths by up to {length_mm:.3} mm, angles by up \
             to {angle_deg:.3} degrees; raise 'decimals' in the driver's settings"
        );
        (*visible > 0).then(|| Note { code: "rounded".to_owned(), count: *visible, message })
    }
}
