//! How far off the open design will be: given up as soon as it is asked for again.

use std::time::{Duration, Instant};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_planning::PlanningError;
use wirebend_planning::simulate::{Prediction, PredictionRequest, predict};

use super::Workspace;
use crate::{ApiError, Progress};

/// From one report to the next.
const BETWEEN: Duration = Duration::from_millis(100);

/// How far off the open design will be.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct PredictedDesign {
    /// Null where it was stopped.
    pub found: Option<Prediction>,
}

/// Stops the prediction that is under way.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct StopPrediction {}

/// No prediction is under way any more.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct PredictionStopped {}

impl Workspace {
    pub(crate) fn predict(
        &self,
        asked: &PredictionRequest,
        progress: &dyn Progress,
    ) -> Result<PredictedDesign, ApiError> {
        let prediction = self.predictions.begin();
        let (app, planned) = self.planned(progress)?;
        let unreached = || PlanningError::StageNotReached {
            stage: crate::StageName::Compensated,
            report: Box::new(planned.report()),
        };
        let job = planned.job()?.ok_or_else(unreached)?;
        progress.stage("bending");
        let next = std::cell::Cell::new(Instant::now() + BETWEEN);
        let goes_on = |done, of| {
            if Instant::now() >= next.get() {
                next.set(Instant::now() + BETWEEN);
                progress.advance(done, of);
            }
            self.predictions.is_last(prediction)
        };
        let found = predict(&app, &planned.opened.name, &planned.setup, &job, asked, &goes_on)?;
        Ok(PredictedDesign { found })
    }

    pub(crate) fn stop_prediction(
        &self,
        _: &StopPrediction,
        _: &dyn Progress,
    ) -> Result<PredictionStopped, ApiError> {
        self.predictions.begin();
        Ok(PredictionStopped {})
    }
}
