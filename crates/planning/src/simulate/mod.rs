//! `simulate`: a job bent without a machine: on the simulated machine of its driver where there is one, and many times
//! by the closed formulas with the errors that machines make.

mod collisions;
mod drawing;
mod kept;
mod prediction;
mod resolution;
mod shares;
mod tolerance;
mod wire;

use std::ops::ControlFlow;
use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::simulate::{
    BadErrorTerm, ErrorModel, ErrorTerm, ImperfectWire, perfect_wire, simulate as simulate_wire,
};
use wirebend_files::document::{Clearance, Job, JobContents};

use crate::contacts::collision_margin;
use crate::design::Input;
use crate::job::open_job;
use crate::machine::{Setup, accepted_errors, restored};
use crate::output::Output;
use crate::report::NoteReport;
use crate::{Installation, PlanningError, Progress};
use collisions::CollisionSearch;
pub use collisions::{SimulatedCollisions, SimulatedContact};
use drawing::Drawing;
pub use kept::KeptWire;
pub use prediction::{Prediction, PredictionRequest, predict};
pub use resolution::ResolutionReport;
use resolution::resolution;
use shares::shares;
pub use shares::{ErrorSourceName, SourceShare, StepShare};
use tolerance::{Accuracy, tolerance};
pub use tolerance::{SimulatedTolerance, SourceTolerance};
use wire::{Figures, simulated_wire};
pub use wire::{GapReport, SimulatedWire, VertexReport};
use wirebend_error::InputName;

/// The most runs of one simulation.
const MAX_RUNS: u32 = 1_000_000;
/// The most distances that are kept, a gibibyte of them: one for each vertex and gap and run.
const MAX_DISTANCES: usize = 1 << 27;

#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct SimulateRequest {
    pub job: Input,
    /// The errors; absent, none are made.
    pub noise: Option<String>,
    /// How often the wire is bent.
    pub runs: u32,
    /// Where the random numbers start: the same seed, the same wires.
    pub seed: u64,
    /// How close each vertex, taken by itself, has to be to its place in 95 % of the wires, mm; then the response says how exact a machine must be.
    #[serde(default)]
    #[schemars(range(min = 0.0))]
    pub within_mm: Option<f64>,
    /// A picture as SVG.
    pub svg: Option<Output>,
    /// A picture as PNG.
    pub png: Option<Output>,
    /// Whether to look where the simulated wires hit the machine or themselves while they are bent.
    #[serde(default)]
    pub collisions: bool,
    /// How far the wire has to stay from what it could hit, besides, mm; with `collisions`. Absent: as the job says.
    #[serde(default)]
    #[schemars(range(min = 0.0))]
    pub collision_margin_mm: Option<f64>,
}

impl SimulateRequest {
    /// One wire of a job, without errors.
    #[must_use]
    pub const fn of(job: Input) -> Self {
        Self {
            job,
            noise: None,
            runs: 1,
            seed: 1,
            within_mm: None,
            svg: None,
            png: None,
            collisions: false,
            collision_margin_mm: None,
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SimulationModel {
    /// The machine's driver has run the program on its simulated machine, which bends a wire that gives by physics.
    SimulatedMachine,
    /// The formulas of the compensation, the other way round: what is wrong in them is not seen.
    ClosedForm,
}

/// What the simulation found. Deviations are taken with the first vertex and the first direction in
/// place.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct SimulateResponse {
    pub machine: String,
    pub material: String,
    /// The errors; null without any.
    pub noise: Option<String>,
    /// How often the wire was bent.
    pub runs: u32,
    /// Where the random numbers started.
    pub seed: u64,
    /// With a simulated machine every wire has `machine_mm`. All other figures are those of closed formulas: a
    /// machine takes too long for many runs.
    pub model: SimulationModel,
    /// The least that the axes of the machine go.
    pub resolution: ResolutionReport,
    /// The wires of the job.
    pub wires: Vec<SimulatedWire>,
    /// How exact a machine must be; null where nobody asked.
    pub tolerance: Option<SimulatedTolerance>,
    /// What was left out, and what the simulated machine did that a real one would not survive.
    pub notes: Vec<NoteReport>,
    /// The pictures.
    pub files: Vec<PathBuf>,
}

/// Bends the wires of a job on the machine that its driver simulates.
pub trait SimulatedMachine {
    /// Every wire of a job; `None`, with a note that says why, where there is no such machine.
    fn bend(&self, setup: &Setup, job: &Job, notes: &mut Vec<NoteReport>) -> Option<Vec<Made>>;
}

/// One wire as a simulated machine bent it.
pub struct Made {
    /// Points along the middle of the wire, mm, in the frame of the turtle at its start, in the machine's signs.
    pub wire_mm: Vec<[f64; 3]>,
    /// Its ends and corners, in the same frame.
    pub corners_mm: Vec<[f64; 3]>,
}

/// How often a wire can be bent so that it is worth it, and its distances are kept.
fn check_runs(runs: u32, contents: &JobContents) -> Result<(), PlanningError> {
    let refused = |expected| PlanningError::Value {
        input: Some(InputName::Runs),
        name: "the number of runs",
        value: runs.to_string(),
        expected,
    };
    if runs == 0 || runs > MAX_RUNS {
        return Err(refused("1 to 1000000"));
    }
    let distances: usize = contents.wires.iter().map(|wire| 2 * wire.vertices.len()).sum();
    if distances.saturating_mul(runs as usize) > MAX_DISTANCES {
        return Err(refused("fewer: the distances of all vertices in all runs do not fit the memory"));
    }
    Ok(())
}

/// A distance that can be asked for.
fn check_within(within_mm: f64) -> Result<f64, PlanningError> {
    if within_mm.is_finite() && within_mm > 0.0 {
        return Ok(within_mm);
    }
    Err(PlanningError::Value {
        input: Some(InputName::Within),
        name: "the accuracy",
        value: within_mm.to_string(),
        expected: "a number of millimetres above zero",
    })
}

/// Bends a job without a machine: on `machine`, and by the formulas of the compensation turned round.
pub fn simulate(
    app: &Installation,
    request: &SimulateRequest,
    machine: &dyn SimulatedMachine,
    progress: &dyn Progress,
) -> Result<SimulateResponse, PlanningError> {
    for output in request.svg.iter().chain(&request.png) {
        output.check()?;
    }
    let runs = if request.noise.is_some() { request.runs } else { 1 };
    let margin = request.collision_margin_mm.map(collision_margin).transpose()?.map(Clearance::length);
    let errors = match &request.noise {
        Some(id) => noise_model(app, id)?,
        None => ErrorModel::default(),
    };
    progress.stage("reading");
    let (name, bytes) = request.job.load()?;
    let job = open_job(&name, &bytes)?;
    let contents = job.contents();
    let setup = restored(&name, contents)?;
    check_runs(runs, contents)?;
    let resolution = resolution(&setup)?;
    let within = request.within_mm.map(check_within).transpose()?;
    let mut notes = accepted_errors(contents);
    progress.stage("bending on the simulated machine");
    let made = machine.bend(&setup, &job, &mut notes);
    progress.stage("bending");
    let mut drawing = Drawing::default();
    let mut wires = Vec::with_capacity(contents.wires.len());
    for (index, wire) in contents.wires.iter().enumerate() {
        let kept = KeptWire::new(&name, wire, &setup)?;
        let mut done = 0;
        let placed = made.as_ref().and_then(|made| made.get(index));
        let made = placed.and_then(|made| kept.vertices(&made.corners_mm));
        let by_machine = made.is_some() && request.noise.is_none();
        let mut search = request.collisions.then(|| CollisionSearch::new(wire, &setup, margin)).transpose();
        if let Some(made) = placed.filter(|_| by_machine) {
            drawing.run(&kept.wire(&made.wire_mm));
        }
        let looked = match (placed.filter(|_| by_machine), &mut search) {
            (Some(made), Ok(Some(search))) => search.corners(&kept.wire(&made.corners_mm)),
            _ => false,
        };
        let bent = |bent: &ImperfectWire| {
            done += 1;
            if !by_machine {
                drawing.run(&bent.points);
            }
            if let (Ok(Some(search)), false) = (&mut search, looked) {
                search.imperfect(bent);
            }
            progress.advance(
                index as u64 * u64::from(runs) + done,
                contents.wires.len() as u64 * u64::from(runs),
            );
            ControlFlow::Continue(())
        };
        let wrong = |error| bad_errors(request.noise.as_deref(), error);
        let input = kept.input(&setup);
        let report = simulate_wire(&input, &errors, runs, request.seed, bent).map_err(wrong)?;
        let perfect = perfect_wire(&input);
        let (sources, steps) = match request.noise {
            Some(_) => shares(wire, &input, &errors).map_err(wrong)?,
            None => (Vec::new(), Vec::new()),
        };
        let figures = Figures { perfect: &perfect, made: made.as_deref(), report: &report };
        let collisions = match search {
            Ok(search) => search.map(CollisionSearch::finish),
            Err(why) => {
                notes.push(not_checked(index, &why));
                None
            }
        };
        wires.push(SimulatedWire { sources, steps, collisions, ..simulated_wire(wire, &kept, &figures) });
        drawing.design(kept);
    }
    let tolerance = match within {
        Some(within_mm) => {
            progress.stage("looking how exact a machine must be");
            let wires = KeptWire::all(&name, contents, &setup)?;
            let accuracy =
                Accuracy { within_mm, wires: &wires, setup: &setup, errors: &errors, seed: request.seed };
            tolerance(&accuracy, &|| true).map_err(|error| bad_errors(request.noise.as_deref(), error))?
        }
        None => None,
    };
    let by_machine = wires.iter().all(|wire| wire.worst_machine_mm.is_some()) && !wires.is_empty();
    let model = if by_machine { SimulationModel::SimulatedMachine } else { SimulationModel::ClosedForm };
    let files = drawing.write(request, &setup, &mut notes)?;
    Ok(SimulateResponse {
        machine: setup.machine_id().to_owned(),
        material: setup.material_id().to_owned(),
        noise: request.noise.clone(),
        runs,
        seed: request.seed,
        model,
        resolution: resolution.into(),
        wires,
        tolerance,
        notes,
        files,
    })
}

fn bad_errors(noise: Option<&str>, error: BadErrorTerm) -> PlanningError {
    PlanningError::Noise { noise: noise.unwrap_or("none").to_owned(), error }
}

pub(crate) fn noise_model(app: &Installation, id: &str) -> Result<ErrorModel, PlanningError> {
    let figures = app.library.noise(id)?.figures()?;
    let term = |figure: wirebend_profile::ErrorFigures| ErrorTerm { bias: figure.bias, sigma: figure.sigma };
    Ok(ErrorModel {
        feed_mm: term(figures.feed_mm),
        rotate_deg: term(figures.rotate_deg),
        bend_deg: term(figures.bend_deg),
        curvature: term(figures.curvature),
    })
}

fn not_checked(wire: usize, why: &str) -> NoteReport {
    NoteReport {
        code: "collisions-not-checked".into(),
        count: 1,
        message: format!("collisions of wire {} are not checked: {why}", wire + 1),
        remedies: Vec::new(),
    }
}
