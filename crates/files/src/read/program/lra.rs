//! LRA/YBC table: L (straight length from tangent to tangent), R (twist), A (bend), CLR (radius).
//!
//! R is right-handed about the direction of travel and stands on the row of the bend that it
//! precedes; the last row has only L. YBC tables name the same columns Y, B and C. A header may say
//! that values count from the start of the wire or lengths run from corner to corner: see
//! [`Columns`]. A distance from the start is to where the bend begins, along the centreline, each
//! arc as radius times angle; in the last row it is to the end.

use wirebend_core::bend::Step;
use wirebend_core::units::{Angle, Length};
use wirebend_error::ErrorRemedy;

use super::super::Imported;
use super::super::error::ReadError;
use super::super::format::Format;
use super::super::note::{NoteKind, Notes};
use super::super::options::{Handedness, ReadOptions};
use super::super::table::Table;
use super::super::table::columns::Columns;
use super::super::text::{Source, decode};
use super::{Rounding, Written, finish};

const CORRECT: ErrorRemedy = ErrorRemedy::CorrectFile;

/// Whether a table has lengths, twists and angles rather than points.
pub(in crate::read) fn looks_like(table: &Table<'_>) -> bool {
    if let Some(header) = &table.header {
        return Columns::named(header).is_some_and(|columns| columns.angle.is_some())
            && table.column(&["x"]).is_none();
    }
    let widths = |range: std::ops::Range<usize>| table.rows[range].iter().map(|(_, row)| row.len());
    let last = table.rows.len().saturating_sub(1);
    last > 0 && widths(last..last + 1).eq([1]) && widths(0..last).all(|width| width >= 3)
}

/// Reads a table; without a radius lengths are taken from corner to corner, which is noted.
pub(in crate::read) fn read(
    bytes: &[u8],
    source: Source<'_>,
    options: &ReadOptions,
) -> Result<Imported, ReadError> {
    let text = decode(bytes);
    let table = Table::read(&text, source, 0)?;
    let mut notes = Notes::default();
    notes.add(NoteKind::CommentsIgnored, table.comments);
    let columns = Columns::of(&table, source, &mut notes)?;
    if options.units.is_none() && table.unit_mm().is_none() {
        notes.add(NoteKind::UnitsAssumed, 1);
    }
    let of_length = table.mm(source, Some(columns.length), options)?;
    let of_radius = table.mm(source, columns.radius, options)?;
    notes.add(
        NoteKind::UnitsOverridden,
        usize::from(of_length.1 || (columns.radius.is_some() && of_radius.1)),
    );
    let factors = Factors {
        length: of_length.0,
        radius: of_radius.0,
        twist: table.degrees(source, columns.twist)?,
        angle: table.degrees(source, columns.angle)?,
    };

    let handedness = options.handedness.or(table.handedness);
    let over = handedness == Some(Handedness::Left);
    notes.add(NoteKind::LeftHanded, usize::from(over));

    let digit = table.last_place(columns.length);
    // Numbers that happen to be whole are no rounder than the lengths.
    let of = |column: Option<usize>| column.map_or(digit, |column| table.last_place(column).min(digit));
    let digits = Factors {
        length: digit * factors.length,
        radius: of(columns.radius) * factors.radius,
        twist: of(columns.twist) * factors.twist,
        angle: of(columns.angle) * factors.angle,
    };
    let rows = Rows { table: &table, source, options, columns, factors, digits };
    let mut steps: Vec<Step> = Vec::new();
    let mut lines = Vec::new();
    let mut before = Before::default();
    let mut turns = false;
    for row in 0..table.rows.len() {
        source.room(table.place(row), row, "steps")?;
        let mut step = rows.step(row, &mut before, &mut notes)?;
        // Half a turn is the same either way.
        turns |= step.rotate.rad().sin().abs() > 1e-9;
        if over {
            step.rotate = -step.rotate;
        }
        steps.push(options.convention.apply(step));
        lines.push(table.rows[row].0);
    }
    notes.add(NoteKind::RadiusUnused, usize::from(options.clr.is_some() && !before.needed_radius));
    notes.add(NoteKind::HandednessAssumed, usize::from(handedness.is_none() && turns));
    // Each corner is off by what the straight part and the arcs beside it are.
    let Factors { length, radius, twist, angle } = digits;
    let rounding = Rounding { length_mm: length.hypot(radius), angle_deg: twist.max(angle) };
    finish(
        Format::Lra,
        source,
        options,
        Written { steps, lines, rounding, ..Written::default() },
        false,
        notes,
    )
}

/// What a row needs to be read.
struct Rows<'a> {
    table: &'a Table<'a>,
    source: Source<'a>,
    options: &'a ReadOptions,
    columns: Columns,
    factors: Factors,
    /// What the last digit of each stands for.
    digits: Factors,
}

/// Something of each column, in mm or degrees: what one is, or a last digit.
#[derive(Debug, Clone, Copy)]
struct Factors {
    length: f64,
    radius: f64,
    twist: f64,
    angle: f64,
}

/// The arc of a bend. Where there is none, or lengths do not depend on it, both are 0.
#[derive(Debug, Clone, Copy, Default)]
struct Arc {
    radius_mm: f64,
    angle_rad: f64,
}

impl Arc {
    /// From its end to the corner.
    fn tangent_mm(self) -> f64 {
        self.radius_mm * (self.angle_rad / 2.0).tan()
    }

    fn length_mm(self) -> f64 {
        self.radius_mm * self.angle_rad
    }
}

/// Where the rows so far have led.
#[derive(Default)]
struct Before {
    arc: Arc,
    /// From the start of the wire to the end of that arc, in a table of distances.
    end_mm: f64,
    /// From the start of the wire, in a table of absolute rotations.
    turned_deg: f64,
    /// Whether a bend had none of its own and took the caller's radius.
    needed_radius: bool,
}

impl Rows<'_> {
    fn step(&self, row: usize, before: &mut Before, notes: &mut Notes) -> Result<Step, ReadError> {
        let bend = self.value(row, self.columns.angle)?.unwrap_or(0.0) * self.factors.angle;
        notes.add(NoteKind::NegativeAngles, usize::from(bend < 0.0));
        let arc = self.arc(row, bend, (before, notes))?;
        let length_mm = self.length_mm(row, before)?;
        before.end_mm += arc.length_mm();
        let feed = Length::from_mm(length_mm + before.arc.tangent_mm() + arc.tangent_mm())
            .map_err(|_| self.refuse(row, length_mm, "a length within a kilometre", CORRECT))?;
        before.arc = arc;
        let rotate = self.rotation(row, before)?;
        Ok(Step { feed, rotate, bend: Angle::from_deg(bend).unwrap_or_default() })
    }

    fn arc(
        &self,
        row: usize,
        bend_deg: f64,
        (before, notes): (&mut Before, &mut Notes),
    ) -> Result<Arc, ReadError> {
        if bend_deg == 0.0 || self.columns.corners {
            return Ok(Arc::default());
        }
        let own = self.value(row, self.columns.radius)?;
        let radius_mm = match (own, self.options.clr) {
            (Some(radius), _) => radius * self.factors.radius,
            (None, Some(radius)) => {
                before.needed_radius = true;
                radius.mm()
            }
            (None, None) => {
                notes.add(NoteKind::RadiusAssumed, 1);
                0.0
            }
        };
        if radius_mm < 0.0 {
            return Err(self.refuse(row, radius_mm, "a radius of 0 or more", CORRECT));
        }
        if bend_deg.abs() > 179.999 && radius_mm > 0.0 {
            let file = self.source.name.to_owned();
            return Err(ReadError::NoCorner { file, place: self.table.place(row), bend_deg });
        }
        // Without an arc the corner is all that there is.
        if let Some(radius) = Length::from_mm(radius_mm).ok().filter(|_| own.is_some() && radius_mm > 0.0) {
            notes.add_sized(NoteKind::RadiiLost, radius);
        }
        Ok(Arc { radius_mm, angle_rad: bend_deg.abs().to_radians() })
    }

    /// What lies between the arc before and that of this row, or between their corners.
    fn length_mm(&self, row: usize, before: &mut Before) -> Result<f64, ReadError> {
        let given = self.value(row, Some(self.columns.length))?.map(|value| value * self.factors.length);
        if !self.columns.is_distance {
            let bends = self.value(row, self.columns.angle)?.is_some_and(|angle| angle != 0.0);
            let Some(length_mm) = given.or_else(|| (!bends).then_some(0.0)) else {
                let found = self.table.rows[row].1.join(" ");
                return Err(self.source.syntax(
                    self.table.place(row),
                    &found,
                    "a length before the bend",
                    CORRECT,
                ));
            };
            if length_mm < 0.0 {
                return Err(self.refuse(row, length_mm, "a length of 0 or more", CORRECT));
            }
            return Ok(length_mm);
        }
        let Some(distance_mm) = given else {
            let found = self.table.rows[row].1.join(" ");
            let expected = "a distance from the start in every row";
            return Err(self.source.syntax(self.table.place(row), &found, expected, CORRECT));
        };
        let length_mm = distance_mm - before.end_mm;
        if length_mm < -self.rounding_mm(before.arc) {
            let expected =
                format!("a distance of {:.3} mm or more, where the row before ends", before.end_mm);
            let remedy = ErrorRemedy::CorrectFile;
            return Err(self.refuse(row, distance_mm, &expected, remedy));
        }
        // What follows is measured from the distance as it is written.
        before.end_mm = distance_mm;
        Ok(if length_mm < 0.0 { 0.0 } else { length_mm })
    }

    /// How much less than nothing rounding may leave behind an arc: up to a last digit of the distance, the
    /// radius and the angle, where a table has equally many everywhere. Without an arc between them distances
    /// are in order, however they are rounded.
    fn rounding_mm(&self, arc: Arc) -> f64 {
        if arc.length_mm() == 0.0 {
            return 0.0;
        }
        let Factors { length, radius, angle, .. } = self.digits;
        length + radius * arc.angle_rad + angle.to_radians() * arc.radius_mm
    }

    fn rotation(&self, row: usize, before: &mut Before) -> Result<Angle, ReadError> {
        let Some(twist) = self.value(row, self.columns.twist)? else {
            return Ok(Angle::ZERO);
        };
        let deg = twist * self.factors.twist;
        if !self.columns.is_absolute {
            return Ok(Angle::from_deg(deg).unwrap_or_default());
        }
        // Without whole turns the difference is finite, whatever the table says.
        let turned_deg = deg % 360.0;
        let by_deg = turned_deg - std::mem::replace(&mut before.turned_deg, turned_deg);
        Ok(Angle::from_deg(by_deg).unwrap_or_default().wrapped())
    }

    fn value(&self, row: usize, column: Option<usize>) -> Result<Option<f64>, ReadError> {
        column.map_or(Ok(None), |column| self.table.value(self.source, row, column))
    }

    fn refuse(&self, row: usize, found: f64, expected: &str, remedy: ErrorRemedy) -> ReadError {
        self.source.syntax(self.table.place(row), &found.to_string(), expected, remedy)
    }
}
