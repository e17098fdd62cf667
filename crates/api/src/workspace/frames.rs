//! The open design as a frame: what it carries, how it vibrates, how accurate it is, and how good a machine must be for that.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_planning::catalogue::{NoiseEntry, StrutBuilderEntry, noises, strut_builders};
use wirebend_planning::frame::{
    ClosingChoice, ClosingName, FrameShapes, FrameSupports, RequirementsChoice, ToleranceSubject, VaryName,
    drawn_frame, tolerance,
};

use super::Workspace;
use crate::{
    ApiError, FrameRequest, FrameResponse, Input, PlanChoices, Progress, ToleranceRequest, ToleranceResponse,
};

/// Asks what there is to choose from for frames.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct FrameChoicesRequest {}

/// What there is to choose from for frames.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct FrameChoices {
    /// Errors of machines.
    pub errors: Vec<NoiseEntry>,
    /// Machines that build struts.
    pub strut_builders: Vec<StrutBuilderEntry>,
}

/// Computes the open design as a frame.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct FrameDesign {
    /// Absent: that of the design.
    pub material: Option<String>,
    /// What holds the frame.
    #[serde(default)]
    pub supports: FrameSupports,
    /// Gravity along x, y and z, as multiples of standard gravity; absent: 1 against z.
    pub gravity: Option<[f64; 3]>,
    /// How many modes to look for, the rigid ones aside.
    #[serde(default)]
    pub modes: u32,
    /// How its joints are closed, where that is asked for.
    pub close: Option<ClosingChoice>,
    /// Whether wires may run along edges twice where there is no route otherwise.
    #[serde(default)]
    pub double: bool,
}

/// The open design as a frame, and what the view draws of it.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct FrameShown {
    pub result: FrameResponse,
    pub shapes: FrameShapes,
}

/// Asks how good a machine must be for the open design.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ToleranceDesign {
    /// Absent: that of the design.
    pub material: Option<String>,
    pub required: RequirementsChoice,
    #[serde(default)]
    pub vary: VaryName,
    #[serde(default)]
    pub closing: ClosingName,
    /// Faces that are to be flat, by their vertices; none: all vertices count.
    #[serde(default)]
    pub faces: Vec<Vec<u32>>,
    /// Whether wires may run along edges twice where there is no route otherwise.
    #[serde(default)]
    pub double: bool,
}

/// Of each strut so many pieces vibrate.
const PIECES: u32 = 4;
/// Where feeds and angles both vary, each has half of what is required.
const FEED_SHARE: f64 = 0.5;

impl Workspace {
    pub(crate) fn frame_choices(
        &self,
        _: &FrameChoicesRequest,
        _: &dyn Progress,
    ) -> Result<FrameChoices, ApiError> {
        let app = self.installation();
        Ok(FrameChoices { errors: noises(&app), strut_builders: strut_builders(&app)? })
    }

    pub(crate) fn frame(&self, asked: &FrameDesign, progress: &dyn Progress) -> Result<FrameShown, ApiError> {
        let request = FrameRequest {
            design: self.as_input()?,
            choices: choices(asked.material.as_ref(), asked.double),
            supports: asked.supports.clone(),
            gravity: asked.gravity,
            loads: None,
            files: Box::default(),
            modes: asked.modes,
            pieces: PIECES,
            close: asked.close.clone(),
        };
        let (result, shapes) = drawn_frame(&self.installation(), &request, progress)?;
        Ok(FrameShown { result, shapes })
    }

    pub(crate) fn tolerance(
        &self,
        asked: &ToleranceDesign,
        progress: &dyn Progress,
    ) -> Result<ToleranceResponse, ApiError> {
        let faces = match asked.faces.as_slice() {
            [] => None,
            faces => Some(Input::Bytes { name: "the faces".to_owned(), bytes: serde_json::to_vec(faces)? }),
        };
        let request = ToleranceRequest {
            of: ToleranceSubject::Design(self.as_input()?),
            choices: choices(asked.material.as_ref(), asked.double),
            required: asked.required,
            vary: asked.vary,
            feed_share: FEED_SHARE,
            closing: asked.closing,
            faces,
        };
        Ok(tolerance(&self.installation(), &request, progress)?)
    }
}

fn choices(material: Option<&String>, double: bool) -> PlanChoices {
    PlanChoices { material: material.cloned(), double, ..PlanChoices::default() }
}
