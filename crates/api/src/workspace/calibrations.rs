//! A calibration in the window: its profiles are used at once.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::Deserialize;
use wirebend_planning::calibrate::ShapeName;

use super::Workspace;
use crate::{
    ApiError, CalibrateApplyRequest, CalibrateApplyResponse, CalibrationSheet, CalibrationSheetRequest,
    Progress,
};

/// Writes a version of the machine and of the wire with what a sheet tells, to the person's own profiles.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ApplyCalibration {
    /// The sheet.
    pub sheet: PathBuf,
    /// What the springback depends on; what predicts best if absent.
    pub shape: Option<ShapeName>,
    /// Id of the new version of the machine.
    pub machine_id: String,
    /// Id of the new version of the wire.
    pub material_id: String,
    /// Whether profiles of these ids may be replaced.
    #[serde(default)]
    pub force: bool,
}

impl Workspace {
    pub(crate) fn calibration_sheet(
        &self,
        asked: &CalibrationSheetRequest,
        _: &dyn Progress,
    ) -> Result<CalibrationSheet, ApiError> {
        Ok(wirebend_planning::calibrate::sheet(asked)?)
    }

    pub(crate) fn apply_calibration(
        &self,
        asked: &ApplyCalibration,
        progress: &dyn Progress,
    ) -> Result<CalibrateApplyResponse, ApiError> {
        let request = CalibrateApplyRequest {
            sheet: asked.sheet.clone(),
            shape: asked.shape,
            machine_id: asked.machine_id.clone(),
            material_id: asked.material_id.clone(),
            date: None,
            folder: self.own_folder()?,
            force: asked.force,
        };
        let made = wirebend_planning::calibrate::apply(&self.installation(), &request, progress)?;
        self.reload()?;
        Ok(made)
    }
}
