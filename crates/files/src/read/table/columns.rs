//! What the columns of a table of bends hold, by their names.
//!
//! L, R, A and CLR; Y, B and C in YBC tables. A name may say more: `Rabs` is a rotation that counts
//! from the start of the wire, `Lcorner` a length from corner to corner, `D_mm` a distance from
//! the start, `Dcorner` one along the corners. `Bend` is an angle where no column says so more plainly, since it
//! may be a number, and `Bend radius` is none. Reports after MIL-D-9898 have letters of their own, as
//! Siemens NX documents them (`uf_route.h`): C distance, E rotation from the start, F radius, G
//! angle, Y length.

use wirebend_error::ErrorRemedy;

use super::super::error::{Location, ReadError};
use super::super::note::{NoteKind, Notes};
use super::super::text::{Source, excerpt};
use super::{Column, Table};

const LENGTH: &[&str] = &["l", "length", "feed", "straight", "y"];
const DISTANCE: &[&str] = &["d"];
const TWIST: &[&str] = &["r", "rotation", "rotate", "twist", "b"];
const ANGLE: &[&str] = &["a", "angle", "c"];
const RADIUS: &[&str] = &["clr", "radius", "centerline", "centreline"];

/// Words that a value counts from the start of the wire.
const FROM_START: &[&str] = &["abs", "absolute", "cumulative"];
/// Words that a length runs from corner to corner.
const CORNERS: &[&str] = &["corner", "corners", "intersection", "intersections"];

/// The names of YBC tables.
const YBC: &[&str] = &["y", "b", "c"];
/// Words that a column counts the bends.
const NUMBER: &[&str] = &["no", "nr", "nº", "n", "num", "number", "id", "index"];
/// Words that what is said of a bend is a length, though not that before it.
const SOME_LENGTH: &[&str] = &["length", "distance"];
/// Words that it is the rotation before it.
const ROTATION: &[&str] = &["rotation", "twist"];

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Holds {
    Length { from_start: bool, corners: bool },
    Twist { from_start: bool },
    Angle,
    Radius,
}

/// How plainly a name says so. Of columns that hold the same the plainest is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Plain {
    /// By a word for it, or a letter of LRA.
    Fully,
    /// By a letter of YBC, which may as well be a coordinate.
    Letter,
    /// By "bend" and nothing else, which may as well be its number.
    Bend,
    /// By "bend" and something that is not understood.
    Perhaps,
    /// By "bend" and a unit of length, which is refused where nothing else is the angle.
    InLength,
}

/// What each column of a header holds.
struct Held(Vec<Option<(Holds, Plain)>>);

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
        columns.refuse_twice(header, source)?;
        let used = [Some(columns.length), columns.twist, columns.angle, columns.radius];
        notes.add(NoteKind::ColumnsIgnored, header.len() - used.iter().flatten().count());
        notes.add(NoteKind::RotationMissing, usize::from(columns.twist.is_none()));
        Ok(columns)
    }

    /// Refuses a header in which another column holds the same as one that is read, as plainly.
    fn refuse_twice(&self, header: &[Column], source: Source<'_>) -> Result<(), ReadError> {
        let held = Held::of(header);
        for column in [Some(self.length), self.twist, self.angle, self.radius].into_iter().flatten() {
            let Some((holds, _)) = held.0[column] else { continue };
            let Some(again) = held.plainest(holds).find(|again| *again != column) else { continue };
            let found = header.iter().map(|column| column.text.as_str()).collect::<Vec<_>>().join(", ");
            let expected = format!(
                "one column with the {}, not both {} and {}",
                holds.word(),
                excerpt(&header[column].text),
                excerpt(&header[again].text)
            );
            let remedy = ErrorRemedy::NameColumns { columns: "L, R, A and CLR".to_owned() };
            return Err(source.syntax(Location::File, &found, expected, remedy));
        }
        Ok(())
    }

    /// By the header alone; `None` where nothing tells how long the wire is. Where a value is there twice,
    /// that one is taken which needs the fewest others to be read.
    pub(in crate::read) fn named(header: &[Column]) -> Option<Self> {
        let held = Held::of(header);
        let find = |wanted: Holds| held.plainest(wanted).next();
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

impl Held {
    fn of(header: &[Column]) -> Self {
        let is_military = is_military(header);
        let held = |column: &Column| {
            if is_military { military(column).map(|holds| (holds, Plain::Fully)) } else { holds(column) }
        };
        Self(header.iter().map(held).collect())
    }

    /// The columns that hold this, as far as none says so more plainly.
    fn plainest(&self, wanted: Holds) -> impl Iterator<Item = usize> {
        let plain = move |held: Option<(Holds, Plain)>| {
            held.filter(|(holds, _)| *holds == wanted).map(|(_, plain)| plain)
        };
        let plainest = self.0.iter().copied().filter_map(plain).min();
        let is_it = move |held| plainest.is_some() && plain(held) == plainest;
        self.0.iter().enumerate().filter(move |(_, held)| is_it(**held)).map(|(column, _)| column)
    }
}

impl Holds {
    const fn word(self) -> &'static str {
        match self {
            Self::Length { .. } => "length",
            Self::Twist { .. } => "rotation",
            Self::Angle => "angle",
            Self::Radius => "radius",
        }
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

fn words(column: &Column) -> impl Iterator<Item = &str> {
    std::iter::once(&column.name).chain(&column.more).map(String::as_str)
}

fn says(column: &Column, list: &[&str]) -> bool {
    words(column).any(|word| list.contains(&word))
}

/// Whether "rad" in the name of a column is short for its radius.
pub(super) fn says_radius(column: &Column) -> bool {
    says(column, RADIUS) && says(column, &["rad"])
}

/// What any other column holds: its first word tells what, the others and an ending how it is counted.
fn holds(column: &Column) -> Option<(Holds, Plain)> {
    let (mut from_start, mut corners) = (says(column, FROM_START), says(column, CORNERS));
    let mut name = words(column).find(|word| !FROM_START.contains(word) && !CORNERS.contains(word))?;
    if name == "bend" {
        return of_bend(column, from_start);
    }
    if let Some(twist) = name.strip_suffix("abs").filter(|name| TWIST.contains(name)) {
        (name, from_start) = (twist, true);
    }
    if let Some(length) =
        name.strip_suffix("corner").filter(|name| LENGTH.contains(name) || DISTANCE.contains(name))
    {
        (name, corners) = (length, true);
    }
    // The letter alone may as well be a diameter, or the one behind C.
    let is_measured = column.units.mm.is_some() || column.units.unread;
    let distance = if is_measured || corners { DISTANCE } else { &[] };
    let kinds = [
        (distance, Holds::Length { from_start: true, corners }),
        (LENGTH, Holds::Length { from_start, corners }),
        (TWIST, Holds::Twist { from_start }),
        (ANGLE, Holds::Angle),
        (RADIUS, Holds::Radius),
    ];
    let plain = if YBC.contains(&name) { Plain::Letter } else { Plain::Fully };
    kinds.into_iter().find(|(names, _)| names.contains(&name)).map(|(_, holds)| (holds, plain))
}

/// What a column holds whose name begins with "bend": what the other words say.
fn of_bend(column: &Column, from_start: bool) -> Option<(Holds, Plain)> {
    if says(column, RADIUS) {
        return Some((Holds::Radius, Plain::Fully));
    }
    let is_number = says(column, NUMBER) || column.text.contains(['#', '№']);
    if is_number || says(column, SOME_LENGTH) {
        return None;
    }
    if says(column, ROTATION) {
        return Some((Holds::Twist { from_start }, Plain::Fully));
    }
    let is_angle = says(column, ANGLE) || column.units.degrees.is_some();
    let is_bare =
        words(column).all(|word| word == "bend" || FROM_START.contains(&word) || CORNERS.contains(&word));
    let plain = match (is_angle, is_bare) {
        _ if column.units.mm.is_some() && column.units.degrees.is_none() => Plain::InLength,
        (true, _) => Plain::Fully,
        (false, true) => Plain::Bend,
        (false, false) => Plain::Perhaps,
    };
    Some((Holds::Angle, plain))
}
