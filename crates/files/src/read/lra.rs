//! LRA/YBC table: L (straight length from tangent to tangent), R (twist), A (bend), CLR (radius).
//!
//! R is right-handed about the direction of travel and stands on the row of the bend that it
//! precedes; the last row has only L. YBC tables name the same columns Y, B and C.

use wirebend_core::bend::Step;
use wirebend_core::units::{Angle, Length};

use super::Imported;
use super::error::{Place, ReadError};
use super::format::Format;
use super::note::{NoteKind, Notes};
use super::options::ReadOptions;
use super::program::finish;
use super::table::Table;
use super::text::{Source, decode};

const LENGTH: &[&str] = &["l", "length", "feed", "straight", "y"];
const TWIST: &[&str] = &["r", "rotation", "rotate", "twist", "b"];
const ANGLE: &[&str] = &["a", "angle", "bend", "c"];
const RADIUS: &[&str] = &["clr", "radius", "centerline", "centreline"];

/// Whether a table has lengths, twists and angles rather than points.
pub(super) fn looks_like(table: &Table<'_>) -> bool {
    if table.header.is_some() {
        return table.column(LENGTH).is_some()
            && table.column(ANGLE).is_some()
            && table.column(&["x"]).is_none();
    }
    let widths = |range: std::ops::Range<usize>| table.rows[range].iter().map(|(_, row)| row.len());
    let last = table.rows.len().saturating_sub(1);
    last > 0 && widths(last..last + 1).eq([1]) && widths(0..last).all(|width| width >= 3)
}

/// Reads a table; without a radius lengths are taken from corner to corner, which is noted.
pub(super) fn read(bytes: &[u8], source: Source<'_>, options: &ReadOptions) -> Result<Imported, ReadError> {
    let text = decode(bytes);
    let table = Table::parse(&text);
    let mut notes = Notes::default();
    notes.add(NoteKind::CommentsIgnored, table.comments);
    let [length, twist, angle, radius] = columns(&table, source, &mut notes)?;
    let unit = table.header.iter().flatten().find_map(|column| column.unit);
    let factor = options.units.or(unit).unwrap_or_default().mm() * options.scale;
    if options.units.or(unit).is_none() {
        notes.add(NoteKind::UnitsAssumed, 1);
    }

    let mut steps: Vec<Step> = Vec::new();
    let mut lines = Vec::new();
    let mut before = 0.0;
    for row in 0..table.rows.len() {
        let place = table.place(row);
        source.room(place.clone(), row, "steps")?;
        let value =
            |column: Option<usize>| column.map_or(Ok(None), |column| table.value(source, row, column));
        let refuse = |found: f64, expected: &str| {
            let help = "correct the row";
            source.syntax(place.clone(), &found.to_string(), expected, help)
        };
        let feed = value(length)?.unwrap_or(0.0) * factor;
        let bend = value(angle)?.unwrap_or(0.0);
        notes.add(NoteKind::NegativeAngles, usize::from(bend < 0.0));
        let after = if bend == 0.0 {
            0.0
        } else {
            let radius = match (value(radius)?, options.clr) {
                (Some(radius), _) => radius * factor,
                (None, Some(radius)) => radius.mm(),
                (None, None) => {
                    notes.add(NoteKind::RadiusAssumed, 1);
                    0.0
                }
            };
            if radius < 0.0 {
                return Err(refuse(radius, "a radius of 0 or more"));
            }
            if bend.abs() > 179.999 && radius > 0.0 {
                return Err(ReadError::NoCorner { file: source.name.to_owned(), place, bend_deg: bend });
            }
            radius * (bend.abs().to_radians() / 2.0).tan()
        };
        if feed < 0.0 {
            return Err(refuse(feed, "a length of 0 or more"));
        }
        let feed = Length::from_mm(feed + before + after)
            .map_err(|_| refuse(feed, "a length within a kilometre"))?;
        let rotate = Angle::from_deg(value(twist)?.unwrap_or(0.0)).unwrap_or_default();
        let step = Step { feed, rotate, bend: Angle::from_deg(bend).unwrap_or_default() };
        steps.push(options.convention.apply(step));
        lines.push(table.rows[row].0);
        before = after;
    }
    finish(Format::Lra, source, options, (steps, &lines), notes)
}

/// The columns L, R, A and CLR: by their header, else the first four.
fn columns(
    table: &Table<'_>,
    source: Source<'_>,
    notes: &mut Notes,
) -> Result<[Option<usize>; 4], ReadError> {
    let Some(header) = &table.header else {
        if let Some((line, row)) = table.rows.iter().find(|(_, row)| row.len() > 4) {
            let help = "name the columns in a header line, as L,R,A,CLR";
            return Err(source.syntax(Place::Line(*line), &row.join(" "), "L, R, A and perhaps CLR", help));
        }
        return Ok([Some(0), Some(1), Some(2), Some(3)]);
    };
    notes.add(NoteKind::HeaderSkipped, 1);
    let columns = [LENGTH, TWIST, ANGLE, RADIUS].map(|names| table.column(names));
    if columns[0].is_none() {
        let found = header.iter().map(|column| column.name.as_str()).collect::<Vec<_>>().join(", ");
        let help = "name the columns L, R, A and CLR";
        return Err(source.syntax(Place::File, &found, "a header with L, R and A", help));
    }
    notes.add(NoteKind::ColumnsIgnored, header.len() - columns.iter().flatten().count());
    Ok(columns)
}
