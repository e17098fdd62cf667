//! `calibrate enter`: readings into a sheet, typed, from tables of others, or of wires that a simulated machine has bent.

use std::path::{Path, PathBuf};

use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::Serialize;
use wirebend_error::InputName;
use wirebend_files::read::{MeasuringSheet, SheetQuantity, SheetRow, pin_table, read_file};

use super::coupons::over_outside;
use crate::machine::mm;
use crate::output::Output;
use crate::{Installation, PlanningError};

#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct CalibrateEnterResponse {
    /// The sheet.
    pub sheet: PathBuf,
    /// How many readings were entered.
    pub entered: usize,
    /// How many readings it has now.
    pub readings: usize,
    /// How many cells are empty.
    pub missing: usize,
}

/// A sheet that readings are entered into.
pub struct SheetFile {
    path: PathBuf,
    pub sheet: MeasuringSheet,
    entered: usize,
}

impl SheetFile {
    pub fn open(path: &Path) -> Result<Self, PlanningError> {
        let sheet = MeasuringSheet::read(&path.display().to_string(), &read_file(path)?)?;
        Ok(Self { path: path.to_owned(), sheet, entered: 0 })
    }

    /// Readings as they are typed: `angle-40=38.5,39` for a coupon with one row, `angle-40:2=…` for its second. A dash leaves
    /// out one that is missing. What was there is replaced.
    pub fn type_in(&mut self, typed: &str) -> Result<(), PlanningError> {
        let wrong = |expected| PlanningError::Value {
            input: Some(InputName::Readings),
            name: "a reading",
            value: format!("'{typed}'"),
            expected,
        };
        let (row, values) = typed
            .split_once('=')
            .ok_or_else(|| wrong("a coupon and its readings, such as angle-40:1=38.5,39"))?;
        let (coupon, number) = row.split_once(':').map_or((row, None), |(coupon, n)| (coupon, Some(n)));
        let read = |value: &str| match value.trim() {
            "" | "-" => Ok(None),
            value => value
                .parse()
                .map(Some)
                .map_err(|_| wrong("readings that are numbers, with commas between them")),
        };
        let readings: Vec<Option<f64>> = values.split(',').map(read).collect::<Result<_, _>>()?;
        let mut rows: Vec<&mut SheetRow> =
            self.sheet.rows.iter_mut().filter(|row| row.coupon == coupon).collect();
        let index = match (number, rows.len()) {
            (_, 0) => return Err(wrong("a coupon of the sheet, by its name in the first column")),
            (None, 1) => 0,
            (None, _) => return Err(wrong("a row of a coupon that has several, such as angle-40:2")),
            (Some(number), _) => {
                number.parse::<usize>().ok().and_then(|n| n.checked_sub(1)).unwrap_or(usize::MAX)
            }
        };
        let row = rows.get_mut(index).ok_or_else(|| wrong("a row that the coupon has, counted from 1"))?;
        self.entered += readings.iter().flatten().count();
        row.readings = readings;
        Ok(())
    }

    /// Rows from a table of pin angle and springback angle.
    pub fn add_pin_table(&mut self, file: &Path) -> Result<(), PlanningError> {
        let pairs = pin_table(&file.display().to_string(), &read_file(file)?)?;
        self.entered += pairs.len();
        self.sheet.rows.extend(pairs.into_iter().map(|pair| {
            let left = pair.pin_deg.signum() * (pair.pin_deg.abs() - pair.springback_deg);
            SheetRow {
                line: 0,
                coupon: format!("pin-{}", pair.pin_deg),
                quantity: SheetQuantity::Bend,
                wanted: left,
                told: pair.pin_deg,
                axes_deg: None,
                readings: vec![Some(left)],
            }
        }));
        Ok(())
    }

    /// The readings of a wire that a simulated machine has bent, by the corners that it reports: the next empty reading of
    /// each row of the coupon that it is.
    pub fn add_corners(
        &mut self,
        app: &Installation,
        job: &str,
        wire: usize,
        corners_mm: &[[f64; 3]],
    ) -> Result<(), PlanningError> {
        let setup = app.setup(&self.sheet.machine, Some(&self.sheet.material))?;
        let diameter = setup.model.wire.diameter;
        for row in bent_rows(&mut self.sheet, job, wire) {
            let (at, row) = row;
            let Some(reading) = read_corner(row.quantity, at, corners_mm) else { continue };
            let reading = match row.quantity {
                SheetQuantity::Side => over_outside(mm(reading)?, diameter).mm(),
                _ => reading,
            };
            let rounded = (reading * 100.0).round() / 100.0;
            match row.readings.iter_mut().find(|reading| reading.is_none()) {
                Some(empty) => *empty = Some(rounded),
                None => row.readings.push(Some(rounded)),
            }
            self.entered += 1;
        }
        Ok(())
    }

    /// Writes the sheet in its place.
    pub fn save(self) -> Result<CalibrateEnterResponse, PlanningError> {
        let cells = || self.sheet.rows.iter().flat_map(|row| &row.readings);
        let response = CalibrateEnterResponse {
            sheet: self.path.clone(),
            entered: self.entered,
            readings: cells().flatten().count(),
            missing: cells().filter(|reading| reading.is_none()).count(),
        };
        Output { path: self.path, force: true }.save(self.sheet.to_text().as_bytes())?;
        Ok(response)
    }
}

/// The rows of the coupon that is a wire of a job, each with its index among them. Jobs are named as `calibrate new` names
/// them.
pub fn bent_rows<'s>(
    sheet: &'s mut MeasuringSheet,
    job: &str,
    wire: usize,
) -> impl Iterator<Item = (usize, &'s mut SheetRow)> {
    let is_of = |row: &SheetRow| match row.quantity {
        SheetQuantity::Bend => job == "angles" && !row.coupon.starts_with("pin-"),
        SheetQuantity::Side => job == "sides",
        SheetQuantity::Turn | SheetQuantity::TurnBack => job == "turns",
    };
    let mut coupons: Vec<String> =
        sheet.rows.iter().filter(|row| is_of(row)).map(|row| row.coupon.clone()).collect();
    coupons.dedup();
    let coupon = coupons.into_iter().nth(wire);
    sheet.rows.iter_mut().filter(move |row| Some(&row.coupon) == coupon.as_ref()).enumerate()
}

/// What is read of a wire by its corners: the `at`-th bend, the middle side, or the `at`-th turn.
fn read_corner(quantity: SheetQuantity, at: usize, corners: &[[f64; 3]]) -> Option<f64> {
    let edge = |k: usize| Some(Vector3::from(*corners.get(k + 1)?) - Vector3::from(*corners.get(k)?));
    let angle = |a: Vector3<f64>, b: Vector3<f64>| a.cross(&b).norm().atan2(a.dot(&b)).to_degrees();
    match quantity {
        SheetQuantity::Bend => Some(angle(edge(at)?, edge(at + 1)?)),
        SheetQuantity::Side => Some(edge(1)?.norm()),
        SheetQuantity::Turn | SheetQuantity::TurnBack => {
            let normal = |k: usize| Some(edge(k)?.cross(&edge(k + 1)?));
            Some(angle(normal(at)?, normal(at + 1)?))
        }
    }
}
