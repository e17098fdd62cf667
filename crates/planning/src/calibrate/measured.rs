//! From a sheet to what `core` fits, and back to its lines.

use wirebend_core::calibrate::{
    AngleSample, Figure, Kind, LengthSample, Measurements, ReadingPlace, TurnSample,
};
use wirebend_core::units::Length;
use wirebend_files::read::{MeasuringSheet, SheetQuantity, SheetRow};

use super::coupons::over_outside;
use crate::PlanningError;
use crate::machine::{Setup, deg, mm};

/// The measurements of a sheet, and of each kind the rows that they are from.
pub(super) struct OfSheet<'a> {
    pub measured: Measurements,
    diameter: Length,
    bends: Vec<&'a SheetRow>,
    sides: Vec<&'a SheetRow>,
    turns: Vec<&'a SheetRow>,
}

impl<'a> OfSheet<'a> {
    pub fn new(sheet: &'a MeasuringSheet, setup: &Setup) -> Result<Self, PlanningError> {
        let diameter = setup.model.wire.diameter;
        let (bends, sides, turns) = (vec![], vec![], vec![]);
        let mut found = Self { measured: Measurements::default(), diameter, bends, sides, turns };
        for row in &sheet.rows {
            let angles = || {
                let read = |reading: &Option<f64>| reading.map(deg).transpose();
                row.readings.iter().map(read).collect::<Result<Vec<_>, _>>()
            };
            match row.quantity {
                SheetQuantity::Bend => {
                    found.bends.push(row);
                    // A small bend may stay while the axis is still before zero: what was wanted has the side.
                    let side = if row.wanted == 0.0 { row.commanded } else { row.wanted }.signum();
                    found.measured.angles.push(AngleSample {
                        axis: deg(row.commanded)?,
                        side,
                        readings: angles()?,
                    });
                }
                SheetQuantity::Side => {
                    let [before, after] = row.axes_deg.unwrap_or_default();
                    let corners = |reading: &Option<f64>| {
                        let outside = reading.map(mm).transpose()?;
                        Ok(outside.map(|outside| outside - over_outside(Length::ZERO, diameter)))
                    };
                    found.sides.push(row);
                    found.measured.lengths.push(LengthSample {
                        feed: mm(row.commanded)?,
                        axis_before: deg(before)?,
                        axis_after: deg(after)?,
                        readings: row.readings.iter().map(corners).collect::<Result<_, PlanningError>>()?,
                    });
                }
                SheetQuantity::Turn | SheetQuantity::TurnBack => {
                    found.turns.push(row);
                    found.measured.turns.push(TurnSample {
                        rotate: deg(row.commanded)?,
                        reverses: row.quantity == SheetQuantity::TurnBack,
                        readings: angles()?,
                    });
                }
            }
        }
        Ok(found)
    }

    /// A figure as it stands in the sheet: a side over the outside of the wire.
    pub fn as_read(&self, kind: Kind, figure: Figure) -> Figure {
        match figure {
            Figure::Length(side) if kind == Kind::Feeds => Figure::Length(over_outside(side, self.diameter)),
            other => other,
        }
    }

    /// The row that a reading stands in.
    pub fn row(&self, kind: Kind, place: ReadingPlace) -> Option<&'a SheetRow> {
        let rows = match kind {
            Kind::Bends => &self.bends,
            Kind::Feeds => &self.sides,
            Kind::Turns => &self.turns,
        };
        rows.get(place.sample).copied()
    }
}
