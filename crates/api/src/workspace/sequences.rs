//! The order in which a machine builds the struts of the open design: looking for one, and checking one that a person has changed.

use std::cell::Cell;
use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_planning::design::Input;
use wirebend_planning::frame::FrameSupports;
use wirebend_planning::output::Output;
use wirebend_planning::sequence::{
    CostName, DrawnSequence, GroupBy, OrderedStep, SequenceFormat, drawn_sequence,
};

use super::Workspace;
use super::latest::Search;
use crate::{ApiError, Progress, SequenceRequest};

/// Looks for an order in which a machine builds the struts of the open design, or checks one. A search that is under way is stopped.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct SequenceDesign {
    /// The machine that builds the struts.
    pub machine: String,
    /// Absent: that of the design.
    pub material: Option<String>,
    /// How far a joint may be from where it is drawn, mm; absent, what the head still meets.
    pub epsilon_mm: Option<f64>,
    /// What is placed at once.
    #[serde(default)]
    pub group_by: GroupBy,
    /// How long is searched, s; absent, 120.
    pub limit_s: Option<f64>,
    /// The order to check; absent, that of `file`, or one is looked for.
    pub order: Option<Vec<OrderedStep>>,
    /// A file with the order to check.
    pub file: Option<PathBuf>,
    /// Where an order goes that can be built.
    pub output: Option<Output>,
    /// What it is written as.
    #[serde(default)]
    pub format: SequenceFormat,
}

/// Stops the search for a sequence that is under way.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct StopSequence {}

/// Nothing is searched for any more.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct SequenceStopped {}

impl Workspace {
    pub(crate) fn sequence(
        &self,
        asked: &SequenceDesign,
        progress: &dyn Progress,
    ) -> Result<DrawnSequence, ApiError> {
        let searches = &self.sequence_searches;
        let search = Search { progress, searches, own: searches.begin(), next: Cell::default() };
        let request = SequenceRequest {
            design: self.as_input()?,
            machine: asked.machine.clone(),
            material: asked.material.clone(),
            supports: FrameSupports::Design,
            epsilon_mm: asked.epsilon_mm,
            check: asked.file.clone().filter(|_| asked.order.is_none()).map(Input::File),
            layers: asked.order.is_none() || asked.output.is_some(),
            group_by: asked.group_by,
            cost: CostName::Sharing,
            limit_s: asked.limit_s,
            seed: None,
            output: asked.output.clone(),
            format: asked.format,
        };
        let drawn = drawn_sequence(&self.installation(), &request, asked.order.as_deref(), &search)?;
        Ok(DrawnSequence { stopped: !search.goes_on(), ..drawn })
    }

    pub(crate) fn stop_sequence(
        &self,
        _: &StopSequence,
        _: &dyn Progress,
    ) -> Result<SequenceStopped, ApiError> {
        self.sequence_searches.begin();
        Ok(SequenceStopped {})
    }
}
