//! The sheet of a calibration: what was bent, by which commands, and what was read of it.

use wirebend_error::ErrorRemedy;

use super::super::error::{Location, ReadError};
use super::super::text::{Source, lines};
use super::Table;
use crate::encoding::decode;

/// What is read of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SheetQuantity {
    /// A bend, in degrees: how far the wire behind it turns away from the wire before it.
    Bend,
    /// The middle side of a U, in mm, over its outside.
    Side,
    /// The turn of the head between two bends, in degrees.
    Turn,
    /// The same against the turn before.
    TurnBack,
}

impl SheetQuantity {
    const ALL: [(Self, &'static str); 4] =
        [(Self::Bend, "bend"), (Self::Side, "side"), (Self::Turn, "turn"), (Self::TurnBack, "turn-back")];

    /// The word that the sheet has for it.
    #[must_use]
    pub fn word(self) -> &'static str {
        Self::ALL.iter().find(|(quantity, _)| *quantity == self).map_or("", |(_, word)| word)
    }
}

/// A row: one thing to be read of equal coupons.
#[derive(Debug, Clone, PartialEq)]
pub struct SheetRow {
    /// Its line, from 1; 0 where it was not read from a file.
    pub line: usize,
    /// The coupon.
    pub coupon: String,
    pub quantity: SheetQuantity,
    /// What was wanted, mm or degrees; of a side from corner to corner.
    pub wanted: f64,
    /// What was commanded: position of the bend axis or turn of the head in degrees, feed in mm.
    pub commanded: f64,
    /// Of a side the positions of the axis for the bends before and behind it, degrees.
    pub axes_deg: Option<[f64; 2]>,
    /// What was read, in the unit of what was wanted; none where nothing was.
    pub readings: Vec<Option<f64>>,
}

/// A sheet.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuringSheet {
    /// Id of the machine that the coupons were planned for.
    pub machine: String,
    /// Id of their wire.
    pub material: String,
    pub rows: Vec<SheetRow>,
    /// Ids of the runs of a simulated machine whose wires are among the readings.
    pub bent: Vec<String>,
    /// Lines that somebody has added as comments.
    pub comments: Vec<String>,
    /// Columns that somebody has added: their names, and a cell for each row.
    pub columns: Vec<(String, Vec<String>)>,
}

/// Lines that every sheet has; what `bent` begins names runs.
pub(crate) const EXPLANATIONS: [&str; 2] = [
    "# bend: how far the wire turns, degrees (straight is 0). side: over the outside of the U, mm. turn: between the planes of two bends, degrees.",
    "# A cell may stay empty. What is commanded belongs to the jobs beside this file: do not change it.",
];

/// Figures are written with four decimals, mm or degrees.
const SAME: f64 = 1e-4;

/// Names of the columns before those of readings.
pub(crate) const COLUMNS: [&str; 6] = ["coupon", "what", "wanted", "commanded", "before_deg", "after_deg"];

impl MeasuringSheet {
    /// Reads a sheet, as it was written or as a spreadsheet has saved it again.
    ///
    /// # Errors
    /// [`ReadError`] with the line of what is no sheet.
    pub fn read(file: &str, bytes: &[u8]) -> Result<Self, ReadError> {
        let source = Source { name: file };
        let text = decode(bytes);
        let heading = |key: &str| {
            let found = lines(&text).filter_map(|(_, line)| {
                let (name, value) = line.trim().trim_matches('"').strip_prefix('#')?.split_once(':')?;
                let value = value.trim().trim_end_matches([',', ';', '"', '\t', ' ']);
                (name.trim() == key).then(|| value.to_owned())
            });
            found.last()
        };
        let needed = |key: &str| {
            let missing = || {
                let expected = format!("a line `# {key}: ID` as `wirebend calibrate new` writes it");
                source.syntax(Location::File, "none", expected, ErrorRemedy::CheckRightFile)
            };
            heading(key).ok_or_else(missing)
        };
        let (machine, material) = (needed("machine")?, needed("material")?);
        let bent = heading("bent").map(|ids| ids.split_whitespace().map(str::to_owned).collect());
        let table = Table::read(&text, source, 0)?;
        let column = |name: &'static str| {
            let word = name.split('_').next().unwrap_or(name);
            let columns = || ErrorRemedy::NameColumns { columns: COLUMNS.join(", ") + ", reading_1, …" };
            let missing = || source.syntax(Location::File, "no such column", name, columns());
            table.column(&[word]).ok_or_else(missing)
        };
        let [coupon, what, wanted, commanded, before, after] = COLUMNS.map(column);
        let (coupon, what, wanted, commanded, before, after) =
            (coupon?, what?, wanted?, commanded?, before?, after?);
        let readings: Vec<usize> = (0..table.header.as_ref().map_or(0, Vec::len))
            .filter(|&k| table.header.as_ref().is_some_and(|header| header[k].name == "reading"))
            .collect();
        let known = [coupon, what, wanted, commanded, before, after];
        let added = table.header.iter().flatten().enumerate();
        let added = added
            .filter(|(k, column)| !known.contains(k) && !readings.contains(k) && !column.text.is_empty());
        let columns = added.map(|(k, column)| {
            let cells = table
                .rows
                .iter()
                .map(|(_, cells)| cells.get(k).map_or_else(String::new, ToString::to_string));
            (column.text.clone(), cells.collect())
        });
        let columns = columns.collect();
        let mut rows = Vec::with_capacity(table.rows.len());
        for (row, (line, cells)) in table.rows.iter().enumerate() {
            let word = cells.get(what).map_or("", AsRef::as_ref);
            let quantity = SheetQuantity::ALL.iter().find(|(_, known)| known.eq_ignore_ascii_case(word));
            let Some(&(quantity, _)) = quantity else {
                let known = "bend, side, turn or turn-back";
                return Err(source.syntax(table.place(row), word, known, ErrorRemedy::CorrectFile));
            };
            let value = |column: usize| table.value(source, row, column);
            let needed = |column: usize| {
                let missing =
                    || source.syntax(table.place(row), "nothing", "a number", ErrorRemedy::CorrectFile);
                value(column)?.ok_or_else(missing)
            };
            let axes_deg = match quantity {
                SheetQuantity::Side => Some([needed(before)?, needed(after)?]),
                _ => None,
            };
            rows.push(SheetRow {
                line: *line,
                coupon: cells.get(coupon).map_or_else(String::new, ToString::to_string),
                quantity,
                wanted: needed(wanted)?,
                commanded: needed(commanded)?,
                axes_deg,
                readings: readings.iter().map(|&column| value(column)).collect::<Result<_, _>>()?,
            });
        }
        if let Some([first, again]) = twice(&rows) {
            let found = format!("{} as in line {}", again.coupon, first.line);
            let expected = "each row once: what was read again stands behind what was read before";
            let place = Location::Line(again.line);
            return Err(source.syntax(place, &found, expected, ErrorRemedy::CorrectFile));
        }
        if rows.is_empty() {
            return Err(ReadError::Empty { file: file.to_owned(), expected: "row", but: String::new() });
        }
        Ok(Self {
            machine,
            material,
            rows,
            bent: bent.unwrap_or_default(),
            comments: comments(&text),
            columns,
        })
    }
}

/// Two rows that are the same but for what was read: a fit would count their readings as if they were of different coupons.
fn twice(rows: &[SheetRow]) -> Option<[&SheetRow; 2]> {
    let near = |a: f64, b: f64| (a - b).abs() < SAME;
    let same = |a: &SheetRow, b: &SheetRow| {
        a.coupon == b.coupon
            && a.quantity == b.quantity
            && near(a.wanted, b.wanted)
            && near(a.commanded, b.commanded)
    };
    rows.iter()
        .enumerate()
        .find_map(|(k, again)| rows[..k].iter().find(|first| same(first, again)).map(|first| [first, again]))
}

/// The comments of a sheet that are not of its own.
fn comments(text: &str) -> Vec<String> {
    let lines =
        lines(text).map(|(_, line)| line.trim().trim_matches('"').trim_end_matches([',', ';', '\t', ' ']));
    let is_own = |line: &str| {
        let key = line.trim_start_matches('#').trim_start();
        ["machine:", "material:", "bent:"].iter().any(|own| key.starts_with(own))
            || EXPLANATIONS.contains(&line)
    };
    lines.filter(|line| line.starts_with('#') && !is_own(line)).map(str::to_owned).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHEET: &str = "# machine: kit\n# material: wire\ncoupon,what,wanted,commanded,before_deg,after_deg,reading_1,reading_2\n\
        angle-20,bend,20,12.5,,,20.5,\nside-35,side,35,34.2,102,102,38.1,-\n";

    #[test]
    fn a_sheet_is_read_as_it_was_written() {
        let sheet = MeasuringSheet::read("s.csv", SHEET.as_bytes()).unwrap();
        assert_eq!((sheet.machine.as_str(), sheet.material.as_str()), ("kit", "wire"));
        assert_eq!(sheet.rows[0].readings, [Some(20.5), None]);
        assert_eq!(sheet.rows[1].axes_deg, Some([102.0, 102.0]));
        let again = MeasuringSheet::read("s.csv", sheet.to_text().as_bytes()).unwrap();
        let unlined = |mut sheet: MeasuringSheet| {
            sheet.rows.iter_mut().for_each(|row| row.line = 0);
            sheet
        };
        assert_eq!(unlined(again), unlined(sheet));
    }

    #[test]
    fn what_somebody_has_added_stays() {
        let added = SHEET
            .replace("coupon,", "# the spool of May,,\ncoupon,")
            .replace("reading_2\n", "reading_2,Who read\n");
        let added =
            added.replace("20.5,\n", "20.5,,Ann\n").replace("# machine", "# bent: a-0-1 a-1-1\n# machine");
        let sheet = MeasuringSheet::read("s.csv", added.as_bytes()).unwrap();
        assert_eq!(sheet.bent, ["a-0-1", "a-1-1"]);
        let text = sheet.to_text();
        for kept in ["# bent: a-0-1 a-1-1\n", "# the spool of May\n", ",Who read\n", "20.5,,Ann\n"] {
            assert!(text.contains(kept), "{kept}: {text}");
        }
        assert_eq!(MeasuringSheet::read("s.csv", text.as_bytes()).unwrap().to_text(), text);
        let mut comma = sheet;
        comma.columns[0].1[0] = "Ann, twice".to_owned();
        let again = MeasuringSheet::read("s.csv", comma.to_text().as_bytes()).unwrap();
        assert_eq!(again.columns[0].1[0], "Ann, twice");
        assert_eq!(again.rows[0].readings, comma.rows[0].readings);
    }

    /// A spreadsheet in Europe writes semicolons, commas in numbers, and fills rows up.
    #[test]
    fn a_sheet_that_a_spreadsheet_has_saved_is_the_same() {
        let saved = "# machine: kit;;;;;;;\n# material: wire;;;;;;;\n\
            coupon;what;wanted;commanded;before_deg;after_deg;reading_1;reading_2\n\
            angle-20;bend;20;12,5;;;20,5;\nside-35;side;35;34,2;102;102;38,1;-\n";
        assert_eq!(
            MeasuringSheet::read("s.csv", saved.as_bytes()).unwrap().rows,
            MeasuringSheet::read("s.csv", SHEET.as_bytes()).unwrap().rows
        );
    }

    #[test]
    fn what_is_wrong_is_said_with_its_line() {
        let broken = [
            (SHEET.replace("38.1", "38.l"), "s.csv, line 5: \"38.l\" is not a finite number"),
            (
                format!("{SHEET}angle-20,bend,20,12.5,,,20.6,\n"),
                "s.csv, line 6: found \"angle-20 as in line 4\", expected each row once: what was read again stands behind what was read before",
            ),
            (
                SHEET.replace("bend", "bent"),
                "s.csv, line 4: found \"bent\", expected bend, side, turn or turn-back",
            ),
            (SHEET.replace("commanded,", "said,"), "s.csv: found \"no such column\", expected commanded"),
            (
                SHEET.replace("# machine: kit\n", ""),
                "s.csv: found \"none\", expected a line `# machine: ID` as `wirebend calibrate new` writes it",
            ),
        ];
        for (text, message) in broken {
            assert_eq!(MeasuringSheet::read("s.csv", text.as_bytes()).unwrap_err().to_string(), message);
        }
    }
}
