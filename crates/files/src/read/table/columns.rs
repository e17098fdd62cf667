//! What the columns of a table of bends hold, by their names.
//!
//! L, R, A and CLR; Y, B and C in YBC tables. A name may say more: `Rabs` is a rotation that counts
//! from the start of the wire, `Lcorner` a length from corner to corner, `D_mm` a distance from
//! the start, `Dcorner` one along the corners. Reports after MIL-D-9898 have letters of their own, as
//! Siemens NX documents them (`uf_route.h`): C distance, E rotation from the start, F radius, G
//! angle, Y length.

use wirebend_error::ErrorRemedy;

use super::super::error::{Location, ReadError};
use super::super::note::{NoteKind, Notes};
use super::super::text::Source;
use super::{Column, Table};

const LENGTH: &[&str] = &["l", "length", "feed", "straight", "y"];
const DISTANCE: &[&str] = &["d"];
const TWIST: &[&str] = &["r", "rotation", "rotate", "twist", "b"];
const ANGLE: &[&str] = &["a", "angle", "bend", "c"];
const RADIUS: &[&str] = &["clr", "radius", "centerline", "centreline"];

/// Words that a value counts from the start of the wire.
const FROM_START: &[&str] = &["abs", "absolute", "cumulative"];
/// Words that a length runs from corner to corner.
const CORNERS: &[&str] = &["corner", "corners", "intersection", "intersections"];

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Holds {
    Length { from_start: bool, corners: bool },
    Twist { from_start: bool },
    Angle,
    Radius,
}

/// Where a table of bends has what.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::read) struct Columns {
    pub(in crate::read) length: usize,
    /// Whether lengths are distances from the start of the wire.
    pub(in crate::read) is_distance: bool,
    /// Whether lengths run from corner to corner. Then the radius says nothing about them.
    pub(in crate::read) corners: bool,
    pub(in crate::read) twist: Option<usize>,
    /// Whether rotations count from the start of the wire.
    pub(in crate::read) is_absolute: bool,
    pub(in crate::read) angle: Option<usize>,
    pub(in crate::read) radius: Option<usize>,
}

impl Columns {
    /// By the header, else the first four: L, R, A and CLR.
    pub(in crate::read) fn of(
        table: &Table<'_>,
        source: Source<'_>,
        notes: &mut Notes,
    ) -> Result<Self, ReadError> {
        let Some(header) = &table.header else {
            if let Some((line, row)) = table.rows.iter().find(|(_, row)| row.len() > 4) {
                let remedy = ErrorRemedy::NameColumns { columns: "L, R, A and CLR".to_owned() };
                let place = Location::Line(*line);
                return Err(source.syntax(place, &row.join(" "), "L, R, A and perhaps CLR", remedy));
            }
            return Ok(Self {
                length: 0,
                is_distance: false,
                corners: false,
                twist: Some(1),
                is_absolute: false,
                angle: Some(2),
                radius: Some(3),
            });
        };
        notes.add(NoteKind::HeaderSkipped, 1);
        let Some(columns) = Self::named(header) else {
            let found = header.iter().map(|column| column.name.as_str()).collect::<Vec<_>>().join(", ");
            let remedy = ErrorRemedy::NameColumns {
                columns: "L, R, A and CLR, or D_mm for distances from the start".to_owned(),
            };
            return Err(source.syntax(Location::File, &found, "a header with L, R and A", remedy));
        };
        let used = [Some(columns.length), columns.twist, columns.angle, columns.radius];
        notes.add(NoteKind::ColumnsIgnored, header.len() - used.iter().flatten().count());
        Ok(columns)
    }

    /// By the header alone; `None` where nothing tells how long the wire is. Where a value is there twice,
    /// that one is taken which needs the fewest others to be read.
    pub(in crate::read) fn named(header: &[Column]) -> Option<Self> {
        let is_military = is_military(header);
        let held: Vec<_> =
            header.iter().map(|column| if is_military { military(column) } else { holds(column) }).collect();
        let find = |wanted: Holds| held.iter().position(|holds| *holds == Some(wanted));
        let lengths = [(false, true), (false, false), (true, true), (true, false)];
        let (length, is_distance, corners) = lengths.into_iter().find_map(|(from_start, corners)| {
            Some((find(Holds::Length { from_start, corners })?, from_start, corners))
        })?;
        let relative = find(Holds::Twist { from_start: false });
        let absolute = find(Holds::Twist { from_start: true });
        Some(Self {
            length,
            is_distance,
            corners,
            twist: relative.or(absolute),
            is_absolute: relative.is_none() && absolute.is_some(),
            angle: find(Holds::Angle),
            radius: find(Holds::Radius).filter(|_| !corners),
        })
    }
}

/// Whether a header is in the letters of MIL-D-9898, where C is not what it is in a YBC table. No other table
/// has E and G.
fn is_military(header: &[Column]) -> bool {
    let has = |name: &str| header.iter().any(|column| column.name == name);
    has("e") && has("g") && (has("c") || has("y"))
}

fn military(column: &Column) -> Option<Holds> {
    Some(match column.name.as_str() {
        "c" => Holds::Length { from_start: true, corners: false },
        "e" => Holds::Twist { from_start: true },
        "f" => Holds::Radius,
        "g" => Holds::Angle,
        "y" => Holds::Length { from_start: false, corners: false },
        _ => return None,
    })
}

/// What any other column holds: its first word tells what, the others and an ending how it is counted.
fn holds(column: &Column) -> Option<Holds> {
    let words = || std::iter::once(&column.name).chain(&column.more).map(String::as_str);
    let says = |list: &[&str]| words().any(|word| list.contains(&word));
    let (mut from_start, mut corners) = (says(FROM_START), says(CORNERS));
    let mut name = words().find(|word| !FROM_START.contains(word) && !CORNERS.contains(word))?;
    if let Some(twist) = name.strip_suffix("abs").filter(|name| TWIST.contains(name)) {
        (name, from_start) = (twist, true);
    }
    if let Some(length) =
        name.strip_suffix("corner").filter(|name| LENGTH.contains(name) || DISTANCE.contains(name))
    {
        (name, corners) = (length, true);
    }
    // The letter alone may as well be a diameter, or the one behind C.
    let distance = if column.unit.is_some() || corners { DISTANCE } else { &[] };
    let kinds = [
        (distance, Holds::Length { from_start: true, corners }),
        (LENGTH, Holds::Length { from_start, corners }),
        (TWIST, Holds::Twist { from_start }),
        (ANGLE, Holds::Angle),
        (RADIUS, Holds::Radius),
    ];
    kinds.into_iter().find(|(names, _)| names.contains(&name)).map(|(_, holds)| holds)
}
