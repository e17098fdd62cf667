//! The sheet of a calibration as a table that spreadsheets open.

use std::fmt::Write as _;

use crate::number::short;
use crate::read::{MeasuringSheet, SHEET_COLUMNS};

impl MeasuringSheet {
    /// The sheet with a column for each reading, and in its heading what is to be read.
    #[must_use]
    pub fn to_text(&self) -> String {
        let readings = self.rows.iter().map(|row| row.readings.len()).max().unwrap_or(0);
        let mut text = String::new();
        // Writing to a String cannot fail.
        let _ = writeln!(text, "# machine: {}\n# material: {}", self.machine, self.material);
        text.push_str(
            "# bend: how far the wire turns, degrees (straight is 0). side: over the outside of the U, mm. turn: between the planes of two bends, degrees.\n\
             # A cell may stay empty. What is told belongs to the jobs beside this file: do not change it.\n",
        );
        let _ = write!(text, "{}", SHEET_COLUMNS.join(","));
        (1..=readings).for_each(|k| {
            let _ = write!(text, ",reading_{k}");
        });
        text.push('\n');
        let number = |value: f64| short(value, 4);
        for row in &self.rows {
            let [before, after] =
                row.axes_deg.map_or([String::new(), String::new()], |axes| axes.map(number));
            let (what, wanted, told) = (row.quantity.word(), number(row.wanted), number(row.told));
            let _ = write!(text, "{},{what},{wanted},{told},{before},{after}", row.coupon);
            for k in 0..readings {
                let reading = row.readings.get(k).copied().flatten().map(number).unwrap_or_default();
                let _ = write!(text, ",{reading}");
            }
            text.push('\n');
        }
        text
    }
}
