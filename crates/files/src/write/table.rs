//! How tables are written.

use super::number::fixed;

/// What stands between two cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Separator {
    /// `,`
    #[default]
    Comma,
    /// `;`
    Semicolon,
    /// A tab.
    Tab,
}

/// What stands before the decimals.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum DecimalMark {
    /// `.`
    #[default]
    Point,
    /// `,`
    Comma,
}

/// How a table is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TableStyle {
    /// Between cells. Where the decimal mark is a comma too, a semicolon is used instead.
    pub separator: Separator,
    /// In numbers.
    pub decimal: DecimalMark,
    /// Whether the first row names the columns.
    pub header: bool,
    /// Digits behind the decimal mark.
    pub decimals: usize,
}

impl Default for TableStyle {
    /// Comma, decimal point, header, three decimals.
    fn default() -> Self {
        Self { separator: Separator::Comma, decimal: DecimalMark::Point, header: true, decimals: 3 }
    }
}

impl TableStyle {
    /// What spreadsheets of countries with a decimal comma open: semicolon and decimal comma.
    #[must_use]
    pub fn decimal_comma() -> Self {
        Self { separator: Separator::Semicolon, decimal: DecimalMark::Comma, ..Self::default() }
    }

    pub(super) fn number(self, value: f64) -> String {
        let text = fixed(value, self.decimals);
        if self.decimal == DecimalMark::Comma { text.replace('.', ",") } else { text }
    }

    pub(super) fn row<S: AsRef<str>>(self, cells: impl IntoIterator<Item = S>) -> String {
        let separator = match (self.separator, self.decimal) {
            (Separator::Comma, DecimalMark::Point) => ",",
            (Separator::Tab, _) => "\t",
            _ => ";",
        };
        let cells: Vec<String> = cells.into_iter().map(|cell| cell.as_ref().to_owned()).collect();
        format!("{}\n", cells.join(separator))
    }
}
