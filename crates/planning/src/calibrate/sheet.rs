//! A sheet as a table that a person types into.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_files::read::{SheetQuantity, SheetRow};

use super::enter::SheetFile;
use crate::PlanningError;

#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct CalibrationSheetRequest {
    /// The sheet.
    pub sheet: PathBuf,
}

/// A sheet with what has been read so far.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct CalibrationSheet {
    pub sheet: PathBuf,
    /// The machine that the coupons were planned for.
    pub machine: String,
    /// Their wire.
    pub material: String,
    pub rows: Vec<CalibrationRow>,
    /// The jobs of coupons that lie beside it.
    pub jobs: Vec<PathBuf>,
}

/// One thing to be read of equal coupons.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct CalibrationRow {
    /// Line of the sheet, from 1.
    pub line: usize,
    pub coupon: String,
    /// Which row of the coupon, from 1.
    pub row: usize,
    /// `bend`, `side`, `turn` or `turn-back`.
    pub what: &'static str,
    /// `deg` or `mm`.
    pub unit: &'static str,
    /// What was wanted; of a side from corner to corner.
    pub wanted: f64,
    pub commanded: f64,
    /// What was read; null where nothing was.
    pub readings: Vec<Option<f64>>,
}

/// What jobs of coupons are called.
const JOBS: [&str; 3] = ["angles.wbjob", "sides.wbjob", "turns.wbjob"];

/// Reads one.
pub fn sheet(request: &CalibrationSheetRequest) -> Result<CalibrationSheet, PlanningError> {
    let found = SheetFile::open(&request.sheet)?.sheet;
    let folder = request.sheet.parent().unwrap_or(Path::new("."));
    let rows = found.rows.iter().enumerate().map(|(at, row)| {
        let before = found.rows[..at].iter().filter(|before| before.coupon == row.coupon).count();
        table_row(row, before + 1)
    });
    Ok(CalibrationSheet {
        rows: rows.collect(),
        jobs: JOBS.iter().map(|job| folder.join(job)).filter(|job| job.is_file()).collect(),
        sheet: request.sheet.clone(),
        machine: found.machine,
        material: found.material,
    })
}

fn table_row(row: &SheetRow, number: usize) -> CalibrationRow {
    CalibrationRow {
        line: row.line,
        coupon: row.coupon.clone(),
        row: number,
        what: row.quantity.word(),
        unit: if row.quantity == SheetQuantity::Side { "mm" } else { "deg" },
        wanted: row.wanted,
        commanded: row.commanded,
        readings: row.readings.clone(),
    }
}
