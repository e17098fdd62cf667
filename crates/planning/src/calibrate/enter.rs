//! `calibrate enter`: readings into a sheet, typed, from tables of others, or of wires that a simulated machine has bent.

use std::path::{Path, PathBuf};

use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::Serialize;
use wirebend_error::InputName;
use wirebend_files::document::JobStep;
use wirebend_files::read::{MeasuringSheet, PinPair, SheetQuantity, SheetRow, pin_table, read_file};

use super::coupons::over_outside;
use crate::machine::mm;
use crate::output::Output;
use crate::{Installation, PlanningError};

/// Degrees or mm: commands are written with four decimals.
const SAME_COMMAND: f64 = 1e-3;

#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct CalibrateEnterResponse {
    /// The sheet.
    pub sheet: PathBuf,
    /// How many readings were entered.
    pub entered: usize,
    /// How many were there before in their rows, and gave way to them.
    pub replaced: usize,
    /// How many readings it has now.
    pub readings: usize,
    /// How many cells are empty.
    pub missing: usize,
}

/// A wire that a simulated machine has bent.
pub struct Bent<'a> {
    /// The file of its job.
    pub job: &'a str,
    /// Its index in the job.
    pub wire: usize,
    pub commands: &'a [JobStep],
    /// Each time that it was bent: the id of the run, and the corners of the wire; none where it was not finished.
    pub runs: &'a [(String, Vec<[f64; 3]>)],
}

/// A sheet that readings are entered into.
pub struct SheetFile {
    path: PathBuf,
    pub sheet: MeasuringSheet,
    entered: usize,
    replaced: usize,
}

impl SheetFile {
    pub fn open(path: &Path) -> Result<Self, PlanningError> {
        let sheet = MeasuringSheet::read(&path.display().to_string(), &read_file(path)?)?;
        Ok(Self { path: path.to_owned(), sheet, entered: 0, replaced: 0 })
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
                .parse::<f64>()
                .ok()
                .filter(|reading| reading.is_finite())
                .map(Some)
                .ok_or_else(|| wrong("readings that are numbers, with commas between them")),
        };
        let readings: Vec<Option<f64>> = values.split(',').map(read).collect::<Result<_, _>>()?;
        let mut rows: Vec<&mut SheetRow> =
            self.sheet.rows.iter_mut().filter(|row| row.coupon == coupon).collect();
        let index = match (number, rows.len()) {
            (_, 0) => return Err(wrong("a coupon of the sheet, by its name in the first column")),
            (None, 1) => 0,
            (None, _) => {
                let expected =
                    "a row of a coupon that has several, such as angle-40:2, in the order of the table";
                return Err(wrong(expected));
            }
            (Some(number), _) => {
                number.parse::<usize>().ok().and_then(|n| n.checked_sub(1)).unwrap_or(usize::MAX)
            }
        };
        let row = rows.get_mut(index).ok_or_else(|| wrong("a row that the coupon has, counted from 1"))?;
        if are_decimals(row, values) {
            return Err(wrong(
                "readings with a point before their decimals: a comma stands between readings, and so these would be twice as many",
            ));
        }
        self.entered += readings.iter().flatten().count();
        let kept =
            |(at, reading): &(usize, &Option<f64>)| reading.is_some() && readings.get(*at) == Some(*reading);
        let there = || row.readings.iter().enumerate().filter(|(_, reading)| reading.is_some());
        self.replaced += there().count() - there().filter(kept).count();
        row.readings = readings;
        Ok(())
    }

    /// Rows from a table of pin angles; readings of one angle are one row.
    pub fn add_pin_table(&mut self, file: &Path) -> Result<(), PlanningError> {
        let pairs = pin_table(&file.display().to_string(), &read_file(file)?)?;
        self.entered += pairs.len();
        let mut rows: Vec<SheetRow> = Vec::new();
        for PinPair { pin_deg, left_deg, .. } in pairs {
            // Another table may have angles of one that was entered before.
            let coupon = format!("pin-{pin_deg}");
            let of_table = |row: &&mut SheetRow| row.coupon == coupon;
            let same = |row: &&mut SheetRow| {
                (row.commanded - pin_deg).abs() < SAME_COMMAND && row.wanted.signum() == left_deg.signum()
            };
            match self.sheet.rows.iter_mut().chain(&mut rows).filter(of_table).find(same) {
                Some(row) => row.readings.push(Some(left_deg)),
                None => rows.push(SheetRow {
                    line: 0,
                    coupon: coupon.clone(),
                    quantity: SheetQuantity::Bend,
                    wanted: left_deg,
                    commanded: pin_deg,
                    axes_deg: None,
                    readings: vec![Some(left_deg)],
                }),
            }
        }
        self.sheet.rows.extend(rows);
        Ok(())
    }

    /// The readings of a wire that a simulated machine has bent, by the corners that it reports: the next empty reading of
    /// each row of the coupon that it is. A run that is among the readings already is not entered once more.
    pub fn add_bent(&mut self, app: &Installation, bent: &Bent) -> Result<(), PlanningError> {
        let setup = app.setup(&self.sheet.machine, Some(&self.sheet.material))?;
        let diameter = setup.model.wire.diameter;
        let coupon = coupon_of(&self.sheet, bent.commands).ok_or_else(|| PlanningError::Value {
            input: None,
            name: "a bent wire",
            value: format!("wire {} of {}", bent.wire + 1, bent.job),
            expected: "a wire of the jobs that were written with this table: their commands are in it",
        })?;
        for (id, corners_mm) in bent.runs {
            if corners_mm.is_empty() || self.sheet.bent.contains(id) {
                continue;
            }
            self.sheet.bent.push(id.clone());
            for (at, row) in self.sheet.rows.iter_mut().filter(|row| row.coupon == coupon).enumerate() {
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
        }
        Ok(())
    }

    /// Writes the sheet in its place.
    pub fn save(self) -> Result<CalibrateEnterResponse, PlanningError> {
        let cells = || self.sheet.rows.iter().flat_map(|row| &row.readings);
        let response = CalibrateEnterResponse {
            sheet: self.path.clone(),
            entered: self.entered,
            replaced: self.replaced,
            readings: cells().flatten().count(),
            missing: cells().filter(|reading| reading.is_none()).count(),
        };
        Output { path: self.path, force: true }.save(self.sheet.to_text().as_bytes())?;
        Ok(response)
    }
}

/// Whether readings have been typed with commas before their decimals: taken as readings, every other one is far from what was wanted,
/// and the rest is near.
fn are_decimals(row: &SheetRow, values: &str) -> bool {
    let parts: Vec<&str> = values.split(',').map(str::trim).collect();
    let is_digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let wanted = row.wanted.abs();
    let is_near = |digits: &str| digits.parse().is_ok_and(|value: f64| (value - wanted).abs() < wanted / 2.0);
    let is_decimal = |pair: &[&str]| {
        let &[whole, decimals] = pair else { return false };
        let whole = whole.trim_start_matches(['-', '+']);
        // Nothing that a person reads has more than two decimals.
        is_digits(whole) && is_digits(decimals) && decimals.len() <= 2 && is_near(whole) && !is_near(decimals)
    };
    parts.len().is_multiple_of(2) && parts.chunks(2).all(is_decimal)
}

/// The coupon that is bent with these commands.
fn coupon_of(sheet: &MeasuringSheet, commands: &[JobStep]) -> Option<String> {
    let mut coupons = sheet.rows.iter().map(|row| &row.coupon);
    let is_it = |coupon: &&String| {
        let rows: Vec<&SheetRow> = sheet.rows.iter().filter(|row| row.coupon == **coupon).collect();
        is_commanded(&rows, commands)
    };
    coupons.find(is_it).cloned()
}

/// Whether these are the rows of a wire with these commands: of the whole wire, since a longer one can have the same among others.
fn is_commanded(rows: &[&SheetRow], commands: &[JobStep]) -> bool {
    let near = |a: f64, b: f64| (a - b).abs() < SAME_COMMAND;
    let bent = commands.iter().take_while(|step| step.bend_deg != 0.0).count();
    let (bent, behind) = commands.split_at(bent);
    if behind.iter().any(|step| step.bend_deg != 0.0) {
        return false;
    }
    // The rotation before the first bend turns the wire as a whole.
    let is_flat = bent.iter().skip(1).all(|step| near(step.rotate_deg, 0.0));
    let bends_alike = bent.windows(2).all(|pair| near(pair[0].bend_deg, pair[1].bend_deg));
    let fits = |(at, row): (usize, &&SheetRow)| match row.quantity {
        SheetQuantity::Bend => bent.len() == rows.len() && is_flat && near(bent[at].bend_deg, row.commanded),
        SheetQuantity::Turn | SheetQuantity::TurnBack => {
            bent.len() == rows.len() + 1 && bends_alike && near(bent[at + 1].rotate_deg, row.commanded)
        }
        SheetQuantity::Side => {
            let axes = row.axes_deg.zip(bent.first_chunk::<2>()).is_some_and(|([before, after], steps)| {
                near(steps[0].bend_deg, before) && near(steps[1].bend_deg, after)
            });
            bent.len() == 2 && is_flat && axes && near(bent[1].feed_mm, row.commanded)
        }
    };
    !rows.is_empty() && rows.iter().enumerate().all(fits)
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

#[cfg(test)]
mod tests {
    use super::*;

    fn row(quantity: SheetQuantity, commanded: f64) -> SheetRow {
        SheetRow {
            line: 0,
            coupon: "coupon".to_owned(),
            quantity,
            wanted: commanded,
            commanded,
            axes_deg: (quantity == SheetQuantity::Side).then_some([110.4, 110.4]),
            readings: Vec::new(),
        }
    }

    fn is_it(rows: &[SheetRow], steps: &[[f64; 3]]) -> bool {
        let step = |&[feed_mm, rotate_deg, bend_deg]: &[f64; 3]| JobStep {
            feed_mm,
            rotate_deg,
            bend_deg,
            ..JobStep::default()
        };
        let commands: Vec<JobStep> = steps.iter().map(step).collect();
        is_commanded(&rows.iter().collect::<Vec<_>>(), &commands)
    }

    #[test]
    fn a_wire_is_a_coupon_with_all_that_it_has() {
        let end = [40.0, 0.0, 0.0];
        let turns = [row(SheetQuantity::Turn, 90.0), row(SheetQuantity::TurnBack, -90.0)];
        let twist = [[40.0, 0.0, 110.4], [40.0, 90.0, 110.4], [40.0, -90.0, 110.4], end];
        assert!(is_it(&turns, &twist));
        let mut after_lead = twist;
        after_lead[0][1] = 15.0;
        assert!(is_it(&turns, &after_lead), "the head turns the wire as a whole first");
        let longer = [&twist[..3], &[[40.0, 180.0, 110.4], end]].concat();
        assert!(!is_it(&turns, &longer), "a wire of four bends");
        let mut other = twist;
        other[1][2] = 66.2;
        assert!(!is_it(&turns, &other), "bends that differ");

        let bends = [row(SheetQuantity::Bend, 66.2), row(SheetQuantity::Bend, -66.2)];
        let z = [[40.0, 0.0, 66.2], [40.0, 0.0, -66.2], end];
        assert!(is_it(&bends, &z) && !is_it(&bends[..1], &z) && !is_it(&turns, &z));
        let mut turned = z;
        turned[1][1] = 90.0;
        assert!(!is_it(&bends, &turned), "its second bend is to another side");

        let side = [row(SheetQuantity::Side, 22.0)];
        let u = [[40.0, 0.0, 110.4], [22.0, 0.0, 110.4], end];
        assert!(is_it(&side, &u));
        assert!(!is_it(&side, &[&[[30.0, 0.0, 110.4]], &u[..]].concat()), "a bend before the U");
        assert!(!is_it(&side, &[&u[..2], &[[30.0, 0.0, 110.4]]].concat()), "a bend behind it");
    }
}
