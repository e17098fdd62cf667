//! The open design as a frame: what it carries, how it vibrates, how accurate it is, and how good a machine must be for that.

use std::cell::Cell;
use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_planning::catalogue::{NoiseEntry, StrutBuilderEntry, noises, strut_builders};
use wirebend_planning::frame::{
    BowChoice, ClosingChoice, ClosingName, ContinuumChoice, FacesChoice, FrameFiles, FrameShapes,
    FrameSupports, LoadCases, LoadsChoice, RequirementsChoice, ToleranceSubject, VaryName, VertexForce,
    drawn_frame, frame, load_cases, tolerance,
};
use wirebend_planning::report::NoteReport;

use super::Workspace;
use super::latest::Search;
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
    /// Gravity along x, y and z, as multiples of standard gravity; absent: that of the loads, and without loads 1 against z.
    pub gravity: Option<[f64; 3]>,
    /// What acts on it besides, from a file.
    pub loads: Option<LoadsChoice>,
    /// Forces at vertices, besides.
    #[serde(default)]
    pub forces: Vec<VertexForce>,
    /// How many modes to look for, the rigid ones aside.
    #[serde(default)]
    pub modes: u32,
    /// Struts that bow while it vibrates, beside straight ones.
    pub bow: Option<BowChoice>,
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

/// Stops computing the frame that is under way.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct StopFrame {}

/// No frame is computed any more.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct FrameStopped {}

/// Writes what a frame carries for other programs.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct SaveFrame {
    /// The frame, as it is computed. Modes and closed joints are in no file.
    pub frame: FrameDesign,
    pub files: FrameFiles,
}

/// Files that were written.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct SavedFrame {
    /// None where the frame floats or does not stand.
    pub files: Vec<PathBuf>,
    /// What was left out.
    pub notes: Vec<NoteReport>,
}

/// Asks which load cases a file has for the open design.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct LoadCasesRequest {
    /// Load cases as conmech writes them.
    pub file: Input,
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
    /// The faces that are to be flat. Absent, all vertices count.
    pub faces: Option<FacesChoice>,
    /// In place of the design a truss of many rings, by closed formulas.
    pub continuum: Option<ContinuumChoice>,
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
        let computing =
            Search { progress, searches: &self.frames, own: self.frames.begin(), next: Cell::default() };
        let request = self.frame_request(asked, FrameFiles::default())?;
        let (result, shapes) = drawn_frame(&self.installation(), &request, &computing)?;
        Ok(FrameShown { result, shapes })
    }

    pub(crate) fn stop_frame(&self, _: &StopFrame, _: &dyn Progress) -> Result<FrameStopped, ApiError> {
        self.frames.begin();
        Ok(FrameStopped {})
    }

    pub(crate) fn save_frame(
        &self,
        asked: &SaveFrame,
        progress: &dyn Progress,
    ) -> Result<SavedFrame, ApiError> {
        let loaded = FrameDesign { modes: 0, bow: None, close: None, ..asked.frame.clone() };
        let request = self.frame_request(&loaded, asked.files.clone())?;
        let FrameResponse { files, notes, .. } = frame(&self.installation(), &request, progress)?;
        Ok(SavedFrame { files, notes })
    }

    fn frame_request(&self, asked: &FrameDesign, files: FrameFiles) -> Result<FrameRequest, ApiError> {
        Ok(FrameRequest {
            design: self.as_input()?,
            choices: choices(asked.material.as_ref(), asked.double),
            supports: asked.supports.clone(),
            gravity: asked.gravity,
            loads: asked.loads.clone(),
            forces: asked.forces.clone(),
            files: Box::new(files),
            modes: asked.modes,
            pieces: PIECES,
            bow: asked.bow,
            close: asked.close.clone(),
        })
    }

    pub(crate) fn load_cases(
        &self,
        asked: &LoadCasesRequest,
        progress: &dyn Progress,
    ) -> Result<LoadCases, ApiError> {
        Ok(load_cases(&self.installation(), &self.as_input()?, &asked.file, progress)?)
    }

    pub(crate) fn tolerance(
        &self,
        asked: &ToleranceDesign,
        progress: &dyn Progress,
    ) -> Result<ToleranceResponse, ApiError> {
        let (of, material) = match asked.continuum {
            Some(truss) => {
                let own = || self.open().state().material;
                (ToleranceSubject::Continuum(truss), asked.material.clone().or_else(own))
            }
            None => (ToleranceSubject::Design(self.as_input()?), asked.material.clone()),
        };
        let request = ToleranceRequest {
            of,
            choices: choices(material.as_ref(), asked.double),
            required: asked.required,
            vary: asked.vary,
            feed_share: FEED_SHARE,
            closing: asked.closing,
            faces: asked.faces.clone(),
        };
        Ok(tolerance(&self.installation(), &request, progress)?)
    }
}

fn choices(material: Option<&String>, double: bool) -> PlanChoices {
    PlanChoices { material: material.cloned(), double, ..PlanChoices::default() }
}
