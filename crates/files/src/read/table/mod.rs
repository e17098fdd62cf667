//! Tables of numbers as spreadsheets and bending machines write them.

pub(super) mod columns;
pub(super) mod pin_table;
pub(super) mod sheet;
pub(super) mod xyz;

use super::error::{Location, ReadError};
use super::options::{Handedness, LengthUnit};
use super::text::{Source, lines};

/// Rows of cells. Separators are `;`, tab, `,` or blanks, in this order of preference; the decimal
/// mark may be a comma where the separator is `;` or tab. Lines that start with `#` are comments.
#[derive(Debug)]
pub(crate) struct Table<'a> {
    /// The first row, if it has words.
    pub(crate) header: Option<Vec<Column>>,
    /// The other rows with their line; empty cells at the end are cut off, blank lines left out.
    pub(crate) rows: Vec<(usize, Vec<&'a str>)>,
    pub(crate) comments: usize,
    /// What the comments and the names of columns say of handedness.
    pub(crate) handedness: Option<Handedness>,
    decimal_comma: bool,
}

/// A header cell such as `X`, `length_mm` or `Angle [deg]`.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Column {
    /// As it stands in the file.
    pub(crate) text: String,
    /// Its first word in lower case.
    pub(crate) name: String,
    /// The words behind it, in lower case.
    pub(crate) more: Vec<String>,
    /// The unit of length that it names.
    pub(crate) unit: Option<LengthUnit>,
}

impl<'a> Table<'a> {
    /// A table from any text; one without numbers is a table too, and its reader says so.
    pub(crate) fn parse(text: &'a str) -> Self {
        let (mut comments, mut handedness) = (0, None);
        let mut content = Vec::new();
        for (number, line) in lines(text).filter(|(_, line)| !line.trim().is_empty()) {
            if line.trim_start().starts_with('#') {
                comments += 1;
                handedness = handedness.or_else(|| hand(line));
            } else {
                content.push((number, line));
            }
        }
        let separator =
            [';', '\t', ','].into_iter().find(|&mark| content.iter().any(|(_, line)| line.contains(mark)));
        let mut rows: Vec<(usize, Vec<&str>)> =
            content.into_iter().map(|(number, line)| (number, cells(line, separator))).collect();
        let is_header = rows.first().is_some_and(|(_, row)| {
            row.iter().any(|cell| cell.starts_with(|c: char| c.is_alphabetic()) && !number_like(cell))
        });
        let header: Option<Vec<Column>> =
            is_header.then(|| rows.remove(0).1.into_iter().map(Column::parse).collect());
        let of_column = |column: &Column| hand(&format!("handed {}", column.more.join(" ")));
        let handedness = handedness.or_else(|| header.iter().flatten().find_map(of_column));
        Self { header, rows, comments, handedness, decimal_comma: matches!(separator, Some(';' | '\t')) }
    }

    /// Whether the first rows hold numbers and nothing else.
    pub(crate) fn is_numeric(&self) -> bool {
        let cells = || self.rows.iter().take(50).flat_map(|(_, row)| row);
        cells().any(|cell| number_like(cell)) && cells().all(|cell| number_like(cell) || is_blank(cell))
    }

    /// The column with one of these names.
    pub(crate) fn column(&self, names: &[&str]) -> Option<usize> {
        self.header.as_ref()?.iter().position(|column| names.contains(&column.name.as_str()))
    }

    /// A cell as a number; `None` where it is missing, empty or a dash.
    pub(crate) fn value(
        &self,
        source: Source<'_>,
        row: usize,
        column: usize,
    ) -> Result<Option<f64>, ReadError> {
        let Some((line, cells)) = self.rows.get(row) else {
            return Ok(None);
        };
        let Some(cell) = cells.get(column).filter(|cell| !is_blank(cell)) else {
            return Ok(None);
        };
        if self.decimal_comma && cell.matches(',').count() == 1 && !cell.contains('.') {
            return source.number(*line, &cell.replace(',', ".")).map(Some);
        }
        source.number(*line, cell).map(Some)
    }

    /// What the last digit of a column stands for: 0.01 where its numbers have up to two decimals.
    pub(crate) fn last_place(&self, column: usize) -> f64 {
        let cells = self.rows.iter().filter_map(|(_, row)| row.get(column));
        let decimals = cells.map(|cell| {
            let behind = cell.split_once(['.', ',']).map_or("", |(_, behind)| behind);
            behind.bytes().take_while(u8::is_ascii_digit).count()
        });
        0.1_f64.powi(decimals.max().and_then(|max| i32::try_from(max).ok()).unwrap_or(0))
    }

    /// The line of a row, for errors.
    pub(crate) fn place(&self, row: usize) -> Location {
        self.rows.get(row).map_or(Location::File, |&(line, _)| Location::Line(line))
    }
}

impl Column {
    fn parse(cell: &str) -> Self {
        let words = cell.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
        let mut words = words.map(str::to_lowercase);
        let name = words.next().unwrap_or_default();
        let more: Vec<String> = words.collect();
        let unit = more.iter().find_map(|word| LengthUnit::from_word(word));
        Self { text: cell.to_owned(), name, unit, more }
    }
}

/// What a line says of handedness, as "left-handed" or "handedness: left".
fn hand(line: &str) -> Option<Handedness> {
    let line = line.to_lowercase();
    let words = || line.split(|c: char| !c.is_alphanumeric());
    let says = |list: &[&str]| words().any(|word| list.contains(&word));
    let about = words().any(|word| word.ends_with("handed") || word == "handedness");
    match (about, says(&["left", "lh", "lefthanded"]), says(&["right", "rh", "righthanded"])) {
        (true, true, false) => Some(Handedness::Left),
        (true, false, true) => Some(Handedness::Right),
        _ => None,
    }
}

fn cells(line: &str, separator: Option<char>) -> Vec<&str> {
    let mut cells: Vec<&str> = match separator {
        Some(mark) => line.split(mark).map(|cell| cell.trim().trim_matches('"').trim()).collect(),
        None => line.split_whitespace().collect(),
    };
    while cells.last().is_some_and(|cell| cell.is_empty()) {
        cells.pop();
    }
    cells
}

fn number_like(cell: &str) -> bool {
    cell.parse::<f64>().is_ok() || cell.replace(',', ".").parse::<f64>().is_ok()
}

fn is_blank(cell: &str) -> bool {
    matches!(cell, "" | "-" | "–" | "—")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn first_row(text: &str) -> Vec<Option<f64>> {
        let table = Table::parse(text);
        (0..3).map(|column| table.value(Source { name: "t" }, 0, column).unwrap()).collect()
    }

    #[test]
    fn separators_and_decimal_marks() {
        let numbers = [Some(1.5), Some(-2.25), Some(3.0)];
        for text in [
            "1.5,-2.25,3",
            "1,5;-2,25;3",
            "1.5;-2.25;3;",
            "1,5\t-2,25\t3",
            " 1.5  -2.25 3 ",
            "\"1.5\",\"-2.25\", 3",
        ] {
            assert_eq!(first_row(text), numbers, "{text}");
        }
        assert_eq!(first_row("1.5;;-"), [Some(1.5), None, None]);
    }

    #[test]
    fn the_last_digit_of_a_column_is_that_of_its_longest_number() {
        let table = Table::parse("D;A\n1;90\n2,25;-\n10,5;45\n12\n");
        assert!((table.last_place(0) - 0.01).abs() < 1e-15);
        assert!((table.last_place(1) - 1.0).abs() < 1e-15);
        assert!((table.last_place(2) - 1.0).abs() < 1e-15, "a column that is not there");
    }

    #[test]
    fn a_header_names_columns_and_units() {
        let table = Table::parse("# made by hand\nX [mm], y_inch ,Z\n1,2,3");
        assert_eq!(table.column(&["y"]), Some(1));
        assert_eq!(
            table.header.as_ref().unwrap()[0],
            Column {
                text: "X [mm]".into(),
                name: "x".into(),
                more: vec!["mm".into()],
                unit: Some(LengthUnit::Millimetre)
            }
        );
        assert_eq!(table.header.as_ref().unwrap()[1].unit, Some(LengthUnit::Inch));
        assert_eq!((table.comments, table.rows.len()), (1, 1));
        assert!(Table::parse("1,2,3\nx,y,z").header.is_none());
    }
}
