//! `calibrate fit`: what a sheet tells.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::calibrate::{Calibration, ShapeChoice, SpringbackShape, settled};
use wirebend_files::read::{MeasuringSheet, read_file};

use super::measured::OfSheet;
use super::report::CalibrationReport;
use crate::machine::Setup;
use crate::{Installation, PlanningError, Progress};

/// What the springback may depend on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ShapeName {
    /// On nothing.
    Constant,
    /// As in the profile, and the same everywhere besides.
    Moved,
    /// On the angle, for each side.
    Curve,
}

#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct CalibrateFitRequest {
    /// The sheet.
    pub sheet: PathBuf,
    /// What the springback depends on; what predicts best if absent.
    pub shape: Option<ShapeName>,
}

/// A sheet, the machine and the wire that it is of, and what it tells of them.
pub(super) struct Fitted {
    pub setup: Setup,
    pub found: Calibration,
    pub report: CalibrationReport,
}

impl Installation {
    pub(super) fn fitted(
        &self,
        sheet: &Path,
        shape: Option<ShapeName>,
        of: Option<[&str; 2]>,
        progress: &dyn Progress,
    ) -> Result<Fitted, PlanningError> {
        let sheet = MeasuringSheet::read(&sheet.display().to_string(), &read_file(sheet)?)?;
        let [machine, material] = of.unwrap_or([&sheet.machine, &sheet.material]);
        let setup = self.setup(machine, Some(material))?;
        progress.stage("fitting");
        let of_sheet = OfSheet::new(&sheet, &setup)?;
        let choice = match shape {
            None => ShapeChoice::Better,
            Some(ShapeName::Constant) => ShapeChoice::Fixed(SpringbackShape::Constant),
            Some(ShapeName::Moved) => ShapeChoice::Fixed(SpringbackShape::Moved),
            Some(ShapeName::Curve) => ShapeChoice::Fixed(SpringbackShape::Cubic),
        };
        let found = settled(&setup.assumed()?, &of_sheet.measured, choice)?;
        let report = CalibrationReport::new(setup.machine_id(), setup.material_id(), &found, &of_sheet);
        let mut fitted = Fitted { setup, found, report };
        fitted.report.doubts = fitted.doubts(self)?;
        Ok(fitted)
    }
}

pub fn fit(
    app: &Installation,
    request: &CalibrateFitRequest,
    progress: &dyn Progress,
) -> Result<CalibrationReport, PlanningError> {
    Ok(app.fitted(&request.sheet, request.shape, None, progress)?.report)
}
