//! `calibrate enter`: readings into a sheet, also of wires that a simulated machine has bent.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::Deserialize;
use wirebend_files::document::Job;
use wirebend_files::read::read_file;
use wirebend_planning::Installation;
use wirebend_planning::PlanningError;
use wirebend_planning::calibrate::{Bent, CalibrateEnterResponse, SheetFile};

use crate::runs::{RunsFolder, StoredRun};
use crate::{FrontEnd, OperationError};

#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct CalibrateEnterRequest {
    /// The sheet.
    pub sheet: PathBuf,
    /// Readings as they are typed, such as `angle-40:1=38.5,39`.
    #[serde(default)]
    pub readings: Vec<String>,
    /// Tables of pin angle and springback angle.
    #[serde(default)]
    pub pin_tables: Vec<PathBuf>,
    /// Jobs of coupons that a simulated machine has bent: the readings are those of its wires.
    #[serde(default)]
    pub bent: Vec<PathBuf>,
}

pub fn enter(
    app: &Installation,
    request: &CalibrateEnterRequest,
    _front_end: &dyn FrontEnd,
) -> Result<CalibrateEnterResponse, OperationError> {
    let mut sheet = SheetFile::open(&request.sheet)?;
    for typed in &request.readings {
        sheet.type_in(typed)?;
    }
    for table in &request.pin_tables {
        sheet.add_pin_table(table)?;
    }
    for path in &request.bent {
        let bytes = read_file(path).map_err(PlanningError::from)?;
        let job = Job::open(&bytes, &path.display().to_string()).map_err(PlanningError::from)?;
        let folder = RunsFolder::of(app)?;
        for (wire, planned) in job.contents().wires.iter().enumerate() {
            let corners = |run: StoredRun| {
                let corners = run.record().map(|record| record.corners_mm).unwrap_or_default();
                (run.id, corners)
            };
            let runs: Vec<_> = folder.of_wire(job.hash(), wire)?.into_iter().map(corners).collect();
            let job = path.display().to_string();
            sheet.add_bent(app, &Bent { job: &job, wire, commands: &planned.compensated, runs: &runs })?;
        }
    }
    Ok(sheet.save()?)
}
