//! Rows of cells as text.

use crate::grid::Grid;
use crate::values::{DecimalMark, LengthUnit, LineEnd, Separator};

/// How cells and numbers are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Style {
    pub grid: Grid,
    pub unit: LengthUnit,
    pub separator: Separator,
    pub decimal_mark: DecimalMark,
    pub line_end: LineEnd,
    pub comment: bool,
}

impl Style {
    /// A length in the unit of the table.
    pub fn in_unit(self, mm: f64) -> f64 {
        mm / self.unit.mm()
    }

    /// A number of the grid.
    pub fn number(self, units: f64) -> String {
        let text = self.grid.text(units);
        if self.decimal_mark == DecimalMark::Comma { text.replace('.', ",") } else { text }
    }
}

/// A table that grows by rows.
#[derive(Debug)]
pub(crate) struct Sheet {
    style: Style,
    text: String,
}

impl Sheet {
    /// A table with its comment and its header, where it has them.
    pub fn new(style: Style, design_hash: &str, header: Option<&[String]>) -> Self {
        let mut sheet = Self { style, text: String::new() };
        if style.comment {
            let hash = design_hash.replace(|c: char| c.is_control(), " ");
            sheet.line(&format!("# design {hash}"));
        }
        if let Some(names) = header {
            sheet.row(names);
        }
        sheet
    }

    pub fn row(&mut self, cells: &[String]) {
        let line = cells.join(&self.style.separator.mark().to_string());
        self.line(&line);
    }

    fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push_str(if self.style.line_end == LineEnd::Crlf { "\r\n" } else { "\n" });
    }

    pub fn into_text(self) -> String {
        self.text
    }
}
