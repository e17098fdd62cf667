//! Tables of numbers as spreadsheets and bending machines write them.

pub(super) mod columns;
pub(super) mod pin_table;
pub(super) mod sheet;
mod units;
pub(super) mod xyz;

use std::borrow::Cow;

use wirebend_error::ErrorRemedy;

use super::error::{Location, ReadError};
use super::options::Handedness;
use super::text::{Source, last_place, lines};
use units::Units;

/// Rows of cells. Separators are `;`, tab, `,` or blanks, in this order of preference, and cells may stand in quotes; the decimal mark
/// may be a comma where the separator is `;` or tab, and in quotes. Lines that start with `#` are comments.
#[derive(Debug)]
pub(crate) struct Table<'a> {
    /// The first row, if it has words.
    pub(crate) header: Option<Vec<Column>>,
    /// The line of the first row, from 1.
    first_line: usize,
    /// How many cells that row has, with those that have no name.
    width: Option<usize>,
    /// The other rows with their line; empty cells at the end are cut off, rows of them left out as blank lines are.
    pub(crate) rows: Vec<(usize, Vec<Cow<'a, str>>)>,
    pub(crate) comments: usize,
    /// What the comments and the names of columns say of handedness.
    pub(crate) handedness: Option<Handedness>,
    decimal_comma: bool,
}

/// A header cell such as `X`, `length_mm` or `Angle [deg]`.
#[derive(Debug, PartialEq)]
pub(crate) struct Column {
    /// As it stands in the file.
    pub(crate) text: String,
    /// Its first word in lower case.
    pub(crate) name: String,
    /// The words behind it, in lower case.
    pub(crate) more: Vec<String>,
    /// What it is in.
    pub(crate) units: Units,
}

impl<'a> Table<'a> {
    /// A table from any text; one without numbers is a table too, and its reader says so.
    pub(crate) fn parse(text: &'a str) -> Self {
        let (mut comments, mut handedness) = (0, None);
        let mut content = Vec::new();
        for (number, line) in lines(text).filter(|(_, line)| !is_empty_row(line)) {
            if is_comment(line) {
                comments += 1;
                handedness = handedness.or_else(|| hand(line));
            } else {
                content.push((number, line));
            }
        }
        if separator(&content).is_none() {
            // A spreadsheet that knew nothing of the mark has saved each row as one cell.
            for (_, line) in &mut content {
                *line = line.trim().trim_matches('"');
            }
        }
        let separator = separator(&content);
        let first_line = content.first().map_or(1, |(number, _)| *number);
        let width = content.first().map_or(0, |(_, line)| all_cells(line, separator).len());
        let mut rows: Vec<(usize, Vec<Cow<str>>)> =
            content.into_iter().map(|(number, line)| (number, cells(line, separator))).collect();
        let is_header = rows.first().is_some_and(|(_, row)| {
            row.iter().any(|cell| cell.starts_with(|c: char| c.is_alphabetic()) && !number_like(cell))
        });
        let header: Option<Vec<Column>> =
            is_header.then(|| rows.remove(0).1.iter().map(|cell| Column::parse(cell)).collect());
        let of_column = |column: &Column| hand(&format!("handed {}", column.more.join(" ")));
        let handedness = handedness.or_else(|| header.iter().flatten().find_map(of_column));
        let decimal_comma = matches!(separator, Some(';' | '\t'))
            || rows.iter().flat_map(|(_, row)| row).any(|cell| is_decimal(cell));
        let width = header.as_ref().map(|_| width);
        Self { header, first_line, width, rows, comments, handedness, decimal_comma }
    }

    /// A table in which every cell has a column, of which there are `least` even where the header has fewer.
    pub(crate) fn read(text: &'a str, source: Source<'_>, least: usize) -> Result<Self, ReadError> {
        let table = Self::parse(text);
        let columns = table.width.map_or(usize::MAX, |width| width.max(least));
        if let Some((line, row)) = table.rows.iter().find(|(_, row)| row.len() > columns) {
            let expected = format!(
                "up to {columns} cells, as the header has; numbers with a decimal comma stand between semicolons or in quotes"
            );
            let place = Location::Line(*line);
            return Err(source.syntax(place, &row.join(" "), expected, ErrorRemedy::CorrectFile));
        }
        Ok(table)
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
        if cell.contains(',') && number_like(cell) {
            let expected = "a number with a point: its comma could stand before decimals or behind thousands";
            return Err(source.syntax(Location::Line(*line), cell, expected, ErrorRemedy::CorrectFile));
        }
        source.number(*line, cell).map(Some)
    }

    /// What the last digit of a column stands for: 0.01 where its numbers have up to two decimals.
    pub(crate) fn last_place(&self, column: usize) -> f64 {
        let cells = self.rows.iter().filter_map(|(_, row)| row.get(column));
        cells.map(|cell| self::last_place(cell)).reduce(f64::min).unwrap_or(1.0)
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
        let more = words.collect();
        Self { text: cell.to_owned(), name, more, units: Units::of(cell) }
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

/// Whether a line is a comment, which a spreadsheet may have put in quotes; the cell `"#"` alone is the name of a column.
fn is_comment(line: &str) -> bool {
    let line = line.trim_start();
    line.starts_with('#') || (line.starts_with("\"#") && !line.starts_with("\"#\""))
}

/// Whether a line has nothing but what stands between and around cells.
fn is_empty_row(line: &str) -> bool {
    line.chars().all(|c| c.is_whitespace() || matches!(c, ',' | ';' | '"'))
}

/// Whether a mark stands between cells, and not in one that has quotes around it.
fn is_separated(line: &str, mark: char) -> bool {
    let mut quoted = false;
    line.chars().any(|c| {
        quoted ^= c == '"';
        c == mark && !quoted
    })
}

/// What stands between the cells of a table.
fn separator(lines: &[(usize, &str)]) -> Option<char> {
    [';', '\t', ','].into_iter().find(|&mark| lines.iter().any(|(_, line)| is_separated(line, mark)))
}

fn all_cells(line: &str, separator: Option<char>) -> Vec<Cow<'_, str>> {
    let plain = |cell: &'_ str| cell.trim().trim_matches('"').trim().to_owned();
    match separator {
        Some(mark) => quoted_cells(line, mark)
            .unwrap_or_else(|| line.split(mark).map(|cell| Cow::Owned(plain(cell))).collect()),
        None => line.split_whitespace().map(Cow::Borrowed).collect(),
    }
}

fn cells(line: &str, separator: Option<char>) -> Vec<Cow<'_, str>> {
    let mut cells = all_cells(line, separator);
    while cells.last().is_some_and(|cell| cell.is_empty()) {
        cells.pop();
    }
    cells
}

/// The cells of a line, of which some have quotes around them, as spreadsheets write them: two quotes in such a cell stand for one. None
/// where quotes are not like that.
fn quoted_cells(line: &str, mark: char) -> Option<Vec<Cow<'_, str>>> {
    let mut cells = Vec::new();
    let mut rest = line;
    loop {
        let (cell, behind) = if let Some(quoted) = rest.trim_start_matches(' ').strip_prefix('"') {
            quoted_cell(quoted)?
        } else {
            let end = rest.find(mark).unwrap_or(rest.len());
            (Cow::Borrowed(rest[..end].trim()), &rest[end..])
        };
        cells.push(cell);
        match behind.strip_prefix(mark) {
            Some(next) => rest = next,
            None if behind.trim().is_empty() => return Some(cells),
            None => return None,
        }
    }
}

/// A cell up to the quote at its end, and what is behind that.
fn quoted_cell(text: &str) -> Option<(Cow<'_, str>, &str)> {
    let mut from = 0;
    loop {
        let end = from + text[from..].find('"')?;
        if !text[end + 1..].starts_with('"') {
            let cell = text[..end].trim();
            let cell =
                if cell.contains('"') { Cow::Owned(cell.replace("\"\"", "\"")) } else { Cow::Borrowed(cell) };
            return Some((cell, text[end + 1..].trim_start_matches(' ')));
        }
        from = end + 2;
    }
}

/// Whether the comma of a number is a decimal mark for sure: one of thousands has three digits behind it, and no zero before it.
fn is_decimal(cell: &str) -> bool {
    let Some((before, behind)) = cell.split_once(',') else { return false };
    let is_digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let before = before.trim_start_matches(['-', '+']);
    is_digits(before) && is_digits(behind) && (behind.len() != 3 || before.starts_with('0'))
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

    /// As a spreadsheet saves them that writes commas in numbers, and commas between cells.
    #[test]
    fn a_comma_in_quotes_is_a_decimal_mark() {
        let numbers = [Some(57.5), Some(-90.0), Some(3.25)];
        for text in
            ["\"57,5\",\"-90,0\",\"3,25\"", "\"57,5\" , -90, \"3,25\",,", " \"57,5\";\"-90,0\";\"3,25\""]
        {
            assert_eq!(first_row(text), numbers, "{text}");
        }
        assert_eq!(first_row("\"0,125\",\"1,000\",2"), [Some(0.125), Some(1.0), Some(2.0)]);
        // Each row saved as one cell.
        assert_eq!(first_row("\"57.5;-90;3.25\"\n\"1;2;3\""), numbers);
        let numbered = Table::parse("\"#\",\"x\",\"y\"\n1,2,3\n");
        assert_eq!((numbered.column(&["x"]), numbered.comments), (Some(1), 0));
        // Of this nobody knows whether it is one or a thousand.
        let thousand = Table::parse("\"1,000\",2,3");
        let refused = thousand.value(Source { name: "t" }, 0, 0).unwrap_err().to_string();
        assert!(refused.contains("\"1,000\"") && refused.contains("thousands"), "{refused}");
        let words = Table::parse("who,what\nAnn,\"5\"\", twice\"\nBen,5\"\n");
        assert_eq!(words.rows[0].1, ["Ann", "5\", twice"]);
        assert_eq!(words.rows[1].1, ["Ben", "5\""]);
    }

    #[test]
    fn a_row_with_more_cells_than_columns_is_refused() {
        let source = Source { name: "t" };
        assert!(Table::read("x,y,z\n1,2,3\n1,2,3,,\n", source, 0).is_ok());
        let refused = Table::read("x,y,z\n1,2,3\n57,5,40,5,0,0\n", source, 0).unwrap_err().to_string();
        assert!(
            refused.starts_with("t, line 3: found \"57 5 40 5 0 0\", expected up to 3 cells"),
            "{refused}"
        );
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
                units: Units { mm: Some(1.0), ..Units::default() },
            }
        );
        assert_eq!(table.header.as_ref().unwrap()[1].units.mm, Some(25.4));
        assert_eq!((table.comments, table.rows.len()), (1, 1));
        assert!(Table::parse("1,2,3\nx,y,z").header.is_none());
        let words = Table::parse("Length in mm;Angle in deg;Radius in;Turn [Grad]\n1;2;3;4\n");
        let of: Vec<_> =
            words.header.iter().flatten().map(|Column { units, .. }| (units.mm, units.degrees)).collect();
        assert_eq!(of, [(Some(1.0), None), (None, Some(1.0)), (Some(25.4), None), (None, Some(1.0))]);
    }
}
