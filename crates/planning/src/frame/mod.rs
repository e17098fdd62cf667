//! `frame`: a design as a structure: what its struts carry, how it vibrates, and how accurate it is once its joints are closed.
//! `tolerance`: how good a machine must be for that.

mod closing;
mod conmech;
mod faces;
mod figures;
mod findings;
mod loads;
mod material;
mod modes;
mod notes;
mod report;
mod results;
mod runs;
mod shapes;
mod statics;
mod structure;
mod supports;
mod tolerance;
mod wires;

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::time::Instant;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::checks::{Diagnostic, Fact, Location, Remedy, Severity, check_crossings};
use wirebend_error::InputName;
use wirebend_files::read::NoteKind;

use crate::choices::PlanChoices;
use crate::design::{DesignInput, default_weld};
use crate::report::{DiagnosticReport, NoteReport, SeverityName};
use crate::{Installation, PlanningError, Progress};
pub use closing::{ClosingChoice, ClosingName, ClosingReport, ClosingRuns, ResourcesReport};
pub use faces::FacesChoice;
pub use figures::ClosingFigures;
pub use loads::{LoadCaseEntry, LoadCases, LoadsChoice, VertexForce, load_cases};
pub(crate) use material::FrameMaterial;
pub use modes::{BowChoice, BowedReport, ModeKindName, ModeReport};
pub(crate) use notes::{doubled_struts, unused_supports};
pub use report::{MemberReport, ReactionReport, StaticReport};
pub use results::FrameFiles;
pub(crate) use results::built_result;
use results::{Loaded, Wanted};
pub use shapes::{ClosedShapes, FrameShapes, MadeLine, StrutLine, StrutShape};
use structure::Structure;
pub use supports::FrameSupports;
pub use tolerance::{
    AchievedReport, ContinuumChoice, RequirementName, RequirementsChoice, ToleranceRequest,
    ToleranceResponse, ToleranceSubject, TrussFrequency, VaryName, tolerance,
};

/// The most modes.
const MAX_MODES: u32 = 1000;
/// The most pieces of a strut.
const MAX_PIECES: u32 = 100;

#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct FrameRequest {
    pub design: DesignInput,
    /// The wire, and where joints are closed, the machine and how its wires run.
    pub choices: PlanChoices,
    /// What holds the frame.
    #[serde(default)]
    pub supports: FrameSupports,
    /// Gravity along x, y and z, as multiples of standard gravity; absent, that of the loads, and without loads 1 against z.
    pub gravity: Option<[f64; 3]>,
    /// What acts on it besides.
    pub loads: Option<LoadsChoice>,
    /// Forces at vertices, besides.
    #[serde(default)]
    pub forces: Vec<VertexForce>,
    /// What is written for other programs.
    #[serde(default)]
    pub files: Box<FrameFiles>,
    /// How many modes to look for, the rigid ones aside.
    #[serde(default)]
    pub modes: u32,
    /// How many pieces a strut is cut into to vibrate.
    #[serde(default = "four")]
    #[schemars(range(min = 1))]
    pub pieces: u32,
    /// Struts that bow while it vibrates, beside straight ones. An arc is cut into at least 9 pieces.
    pub bow: Option<BowChoice>,
    /// How its joints are closed, where that is asked for.
    pub close: Option<ClosingChoice>,
}

const fn four() -> u32 {
    4
}

/// The frame that was computed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct FrameFigures {
    /// Vertices at which struts end.
    pub nodes: usize,
    /// Struts, each edge once.
    pub members: usize,
    /// Vertices that are held.
    pub supports: usize,
    /// Length of all struts.
    pub length_mm: f64,
    /// Their mass, without joints.
    pub mass_g: f64,
}

/// A design as a structure. Linear: small displacements, Hooke's law, rigid joints.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct FrameResponse {
    pub material: String,
    pub frame: FrameFigures,
    /// What loads do; null where nothing holds the frame, or it does not stand.
    #[serde(rename = "static")]
    pub statics: Option<StaticReport>,
    /// By rising frequency, rigid ones foremost.
    pub modes: Vec<ModeReport>,
    /// The same where struts bow; null where nobody asked.
    pub bowed: Option<BowedReport>,
    /// The frame once its joints are closed; null where nobody asked. Roots of mean squares: over the runs, or expected of all wires.
    pub closing: Option<ClosingReport>,
    /// How many wires were drawn; null where the figures are the exact expectation, or nobody asked.
    pub runs: Option<u32>,
    /// Over the runs.
    pub of_runs: Option<ClosingRuns>,
    /// What the wires take, as Bend-Forming reckons it; null where joints are not closed.
    pub resources: Option<ResourcesReport>,
    /// Whether it holds what acts on it.
    pub holds: bool,
    /// What is wrong, worst first.
    pub diagnostics: Vec<DiagnosticReport>,
    /// What was merged, ignored or assumed while reading.
    pub notes: Vec<NoteReport>,
    pub timings_ms: BTreeMap<&'static str, f64>,
    /// Those that were written.
    pub files: Vec<PathBuf>,
}

pub fn frame(
    app: &Installation,
    request: &FrameRequest,
    progress: &dyn Progress,
) -> Result<FrameResponse, PlanningError> {
    Ok(compute(app, request, false, progress)?.0)
}

/// The same with what a view draws of it.
pub fn drawn_frame(
    app: &Installation,
    request: &FrameRequest,
    progress: &dyn Progress,
) -> Result<(FrameResponse, FrameShapes), PlanningError> {
    compute(app, request, true, progress)
}

fn compute(
    app: &Installation,
    request: &FrameRequest,
    drawn: bool,
    progress: &dyn Progress,
) -> Result<(FrameResponse, FrameShapes), PlanningError> {
    within(InputName::Modes, u64::from(request.modes), 0, u64::from(MAX_MODES), "0 to 1000")?;
    within(InputName::Pieces, u64::from(request.pieces), 1, u64::from(MAX_PIECES), "1 to 100")?;
    request.bow.map_or(Ok(()), |bow| bow.check(request.modes))?;
    let wanted = Wanted::of(&request.files)?;
    let mut timings = Timings::default();
    let opened = app
        .designed(request.design.open_with(app, &request.choices, progress)?, &request.choices)?
        .with_wireframe()?;
    let material = app.frame_material(&opened, &request.choices)?;
    let mut notes = opened.notes.clone();
    if material.of_file {
        // The reader has left out for others what is taken here.
        notes.retain(|note| note.code != NoteKind::MaterialIgnored.code());
    }
    let structure = Structure::new(&opened, &material, &request.supports, &mut notes)?;
    notes.extend(structure.without_stress(&material));
    timings.took("read");
    let mut found = Vec::new();
    if structure.edges.is_empty() {
        found.push(nothing_to_compute());
    }
    going_on(progress)?;
    progress.stage("solving");
    found.extend(check_crossings(&opened.document.wireframe, material.wire.diameter, default_weld()));
    let load = loads::loads(&opened, &structure, request.gravity, request.loads.as_ref(), &request.forces)?;
    let solved = structure.statics(&opened, &material, &request.supports, &load, &mut found)?;
    timings.took("static");
    let loaded = Loaded { opened: &opened, structure: &structure, material: &material, load: &load };
    let mut files = wanted.write(loaded, solved.as_ref(), &mut notes)?;
    going_on(progress)?;
    progress.stage("looking for modes");
    let (modes, mode_shapes) = structure.modes(request.modes, request.pieces, drawn)?;
    notes.extend(structure.too_coarse(&modes, request.pieces));
    timings.took("modes");
    let bowed = match request.bow {
        Some(bow) => {
            going_on(progress)?;
            progress.stage("looking for modes of bowed struts");
            let bowed = structure.bowed(bow, request.pieces, request.modes, &modes)?;
            timings.took("bowed");
            bowed
        }
        None => None,
    };
    going_on(progress)?;
    let closed = match &request.close {
        Some(choice) if !structure.edges.is_empty() => {
            let closed = app.close_joints(opened, &request.choices, choice, &structure, drawn, progress)?;
            timings.took("closing");
            notes.extend(material.of_file.then(|| closed_with(&closed.material)));
            Some(closed)
        }
        _ => None,
    };
    found.sort_by_key(|diagnostic| diagnostic.severity);
    let diagnostics: Vec<DiagnosticReport> = found.iter().map(DiagnosticReport::from).collect();
    let closed = closed.unwrap_or_default();
    notes.extend(closed.notes);
    files.extend(closed.files);
    let shapes = if drawn {
        FrameShapes {
            struts: structure.lines(),
            loaded: solved.as_ref().map(|(_, response)| structure.loaded(&load, response)),
            modes: mode_shapes,
            closed: closed.shapes,
        }
    } else {
        FrameShapes::default()
    };
    let response = FrameResponse {
        material: material.id.clone(),
        frame: structure.figures(),
        statics: solved.map(|(report, _)| report),
        modes,
        bowed,
        closing: closed.report,
        runs: closed.runs,
        of_runs: closed.of_runs,
        resources: closed.resources,
        holds: diagnostics.iter().all(|finding| finding.severity != SeverityName::Error),
        diagnostics,
        notes,
        timings_ms: timings.all,
        files,
    };
    Ok((response, shapes))
}

/// Ends what a person has stopped.
fn going_on(progress: &dyn Progress) -> Result<(), PlanningError> {
    if progress.goes_on() { Ok(()) } else { Err(PlanningError::Stopped) }
}

fn nothing_to_compute() -> Diagnostic {
    let (location, fact) = (Location::default(), Fact::NoEdges);
    Diagnostic { severity: Severity::Error, location, fact, remedies: vec![Remedy::DrawEdges] }
}

/// The file of a frame says what its struts are, and its wires are bent of another.
fn closed_with(wire: &str) -> NoteReport {
    NoteReport {
        code: "closed-with-wire".into(),
        count: 1,
        message: format!(
            "joints are closed with the wire that is planned, {wire}, and loads act on the struts of the file"
        ),
        remedies: Vec::new(),
    }
}

/// Refuses a number outside what makes sense.
fn within(
    input: InputName,
    value: u64,
    from: u64,
    to: u64,
    expected: &'static str,
) -> Result<(), PlanningError> {
    if (from..=to).contains(&value) {
        return Ok(());
    }
    Err(PlanningError::Value { input: Some(input), name: input.words(), value: value.to_string(), expected })
}

/// How long each part took.
struct Timings {
    since: Instant,
    all: BTreeMap<&'static str, f64>,
}

impl Default for Timings {
    fn default() -> Self {
        Self { since: Instant::now(), all: BTreeMap::new() }
    }
}

impl Timings {
    fn took(&mut self, part: &'static str) {
        self.all.insert(part, self.since.elapsed().as_secs_f64() * 1000.0);
        self.since = Instant::now();
    }
}
