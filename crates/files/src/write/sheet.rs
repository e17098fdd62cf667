//! The sheet of a calibration as a table that spreadsheets open.

use crate::number::short;
use crate::read::{MeasuringSheet, SHEET_COLUMNS, SHEET_EXPLANATIONS};

impl MeasuringSheet {
    /// The sheet with a column for each reading, and in its heading what is to be read. Comments and columns that somebody has added
    /// are kept.
    #[must_use]
    pub fn to_text(&self) -> String {
        let readings = self.rows.iter().map(|row| row.readings.len()).max().unwrap_or(0);
        let heading = SHEET_COLUMNS.iter().map(ToString::to_string);
        let heading = heading.chain((1..=readings).map(|k| format!("reading_{k}")));
        let mut table = vec![heading.chain(self.columns.iter().map(|(name, _)| name.clone())).collect()];
        table.extend((0..self.rows.len()).map(|row| self.cells(row, readings)));
        // A comma in a text would part it.
        let separator = if table.iter().flatten().any(|cell| cell.contains(',')) { ";" } else { "," };
        let mut lines =
            vec![format!("# machine: {}", self.machine), format!("# material: {}", self.material)];
        if !self.bent.is_empty() {
            lines.push(format!("# bent: {}", self.bent.join(" ")));
        }
        lines.extend(SHEET_EXPLANATIONS.map(str::to_owned));
        lines.extend(self.comments.iter().cloned());
        lines.extend(table.iter().map(|row| row.join(separator)));
        lines.join("\n") + "\n"
    }

    /// A row with so many readings.
    fn cells(&self, index: usize, readings: usize) -> Vec<String> {
        let row = &self.rows[index];
        let number = |value: f64| short(value, 4);
        let [before, after] = row.axes_deg.map_or([String::new(), String::new()], |axes| axes.map(number));
        let mut cells = vec![
            row.coupon.clone(),
            row.quantity.word().to_owned(),
            number(row.wanted),
            number(row.commanded),
            before,
            after,
        ];
        let reading = |k| row.readings.get(k).copied().flatten().map(number).unwrap_or_default();
        cells.extend((0..readings).map(reading));
        cells.extend(self.columns.iter().map(|(_, cells)| cells.get(index).cloned().unwrap_or_default()));
        cells
    }
}
