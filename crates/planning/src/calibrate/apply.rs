//! `calibrate apply`: a version of the machine and the wire with what was found.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::json;
use wirebend_driver_host::jobs::{Clock, SystemClock, is_day};
use wirebend_error::InputName;
use wirebend_profile::Kind;

use super::beyond::beyond;
use super::fit::ShapeName;
use super::report::CalibrationReport;
use super::values::Values;
use crate::profiles::OwnProfile;
use crate::profiles::set::sourced;
use crate::{Installation, PlanningError, Progress};

#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct CalibrateApplyRequest {
    /// The sheet.
    pub sheet: PathBuf,
    /// What the springback depends on; what predicts best if absent.
    pub shape: Option<ShapeName>,
    /// Id of the new version of the machine.
    pub machine_id: String,
    /// Id of the new version of the wire.
    pub material_id: String,
    /// The day of the measurement, such as 2026-11-25; today if absent.
    pub date: Option<String>,
    /// The folder with profiles of the person's own.
    pub folder: PathBuf,
    /// Whether profiles of these ids may be replaced.
    #[serde(default)]
    pub force: bool,
}

#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct CalibrateApplyResponse {
    /// The new machine.
    pub machine: String,
    /// The new wire.
    pub material: String,
    /// The files of both.
    pub files: Vec<PathBuf>,
    /// What was found.
    pub report: CalibrationReport,
}

pub fn apply(
    app: &Installation,
    request: &CalibrateApplyRequest,
    progress: &dyn Progress,
) -> Result<CalibrateApplyResponse, PlanningError> {
    if let Some(date) = request.date.as_ref().filter(|date| !is_day(date)) {
        return Err(PlanningError::Value {
            input: Some(InputName::Date),
            name: "the day of the measurement",
            value: format!("'{date}'"),
            expected: "a day of the calendar, such as 2026-11-25",
        });
    }
    let fitted = app.fitted(&request.sheet, request.shape, None, progress)?;
    progress.stage("writing profiles");
    let place = (request.folder.as_path(), request.force);
    let new = |kind, id, inherits| OwnProfile::new(app, kind, id, inherits, place);
    let mut machine = new(Kind::Machine, &request.machine_id, fitted.setup.machine_id())?;
    let mut material = new(Kind::Material, &request.material_id, fitted.setup.material_id())?;
    let today = SystemClock::default().stamp();
    let today = today.split('T').next().unwrap_or_default();
    let found = Values { fitted: &fitted, date: request.date.as_deref().unwrap_or(today) };
    machine.set("name", calibrated_name(fitted.setup.machine_name(), found.date).into())?;
    material.set("name", calibrated_name(fitted.setup.material_name(), found.date).into())?;
    for (key, value) in found.of_machine() {
        machine.set(key, value)?;
    }
    for (key, value) in found.of_material() {
        material.set(key, value)?;
    }
    let calibrated = json!({
        "date": found.date,
        "readings": found.readings(),
        "machine": fitted.setup.machine_id(),
        "material": fitted.setup.material_id(),
    });
    machine.set("calibrated", calibrated)?;
    // The wire first: the machine names it.
    let refused = |error| match &error {
        PlanningError::Profile(fault) => match beyond(&fitted.report, fault) {
            Some(reason) => PlanningError::Beyond { sheet: request.sheet.display().to_string(), reason },
            None => error,
        },
        _ => error,
    };
    material.check(app).map_err(refused)?;
    let with_material = app.with_profile(&material)?;
    let source = "the wire that it was calibrated with";
    machine.set("default_material", sourced(&json!(request.material_id), source, false))?;
    machine.check(&with_material).map_err(refused)?;
    Ok(CalibrateApplyResponse {
        machine: request.machine_id.clone(),
        material: request.material_id.clone(),
        files: vec![material.save()?, machine.save()?],
        report: fitted.report.clone(),
    })
}

/// What comes between the name of a profile and the day of its calibration.
const CALIBRATED: &str = ", calibrated ";

/// The name of a profile that was calibrated on a day: of one that was calibrated before, the last day counts.
fn calibrated_name(before: &str, date: &str) -> String {
    let name = before.split_once(CALIBRATED).map_or(before, |(name, _)| name);
    format!("{name}{CALIBRATED}{date}")
}
