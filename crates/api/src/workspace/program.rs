//! The program of the open design, step by step as it is played, and the wire as its machine bends it.

use nalgebra::Point3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::simulate::perfect_wire;
use wirebend_files::document::Job;
use wirebend_planning::PlanningError;

use super::Workspace;
use crate::{ApiError, Installation, PlanChoices, Progress};
use wirebend_operation::simulate::OfDriver;
use wirebend_planning::design::Opened;
use wirebend_planning::machine::Setup;
use wirebend_planning::pauses::LeftOutPause;
use wirebend_planning::plan::Planned;
use wirebend_planning::playback::{PlayedWire, PoseReport, played};
use wirebend_planning::report::NoteReport;
use wirebend_planning::simulate::{KeptWire, SimulatedMachine};

/// Asks for the program of the open design, or of what is open to be run.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ProgramRequest {}

/// The program of the open design.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ProgramResponse {
    pub machine: String,
    pub material: String,
    /// Diameter of the wire, mm.
    pub diameter_mm: f64,
    /// Whether the machine can make it.
    pub feasible: bool,
    /// Hash of the job that arming the design as it is would give; null where none can be made. A wire of the
    /// connected machine whose job has this hash is one of this very program.
    pub job_hash: Option<String>,
    /// The wires that have a program.
    pub wires: Vec<PlayedWire>,
    /// Wires that have none: the checks say why.
    pub without: usize,
    /// Pause points of the design that no wire comes to.
    pub left_out: Vec<LeftOutPause>,
}

/// Asks how the machine bends the open design, or what is open to be run.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct MadeRequest {}

/// A wire as it is bent.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MadeWire {
    /// Its ends and corners, one more than there are steps, mm, laid beside the design with the first edge in place.
    pub corners_mm: Vec<[f64; 3]>,
    /// How it lies in the machine while each step bends it; fewer where it has fewer corners.
    pub poses: Vec<PoseReport>,
    /// Points along its middle, mm; empty where only formulas computed it.
    pub wire_mm: Vec<[f64; 3]>,
    /// How far each vertex of the route is from the design, mm.
    pub deviations_mm: Vec<f64>,
    /// The largest of them.
    pub worst_mm: f64,
}

/// How the machine bends the open design.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MadeResponse {
    /// Whether the driver's simulated machine bent it; otherwise the formulas of the compensation did, backwards.
    pub by_machine: bool,
    /// The wires, in the order of the program.
    pub wires: Vec<MadeWire>,
    /// What the machine reported, and what was left out.
    pub notes: Vec<NoteReport>,
}

impl Workspace {
    /// The open design through the whole pipeline; the workspace is free meanwhile.
    pub(crate) fn planned(
        &self,
        progress: &dyn Progress,
    ) -> Result<(std::sync::Arc<Installation>, Planned), ApiError> {
        let (app, opened) = (self.installation(), self.copy());
        let planned = app.plan_design(opened, &PlanChoices::default(), progress)?;
        Ok((app, planned))
    }

    /// The open design without its stencils, which are no part of what is bent.
    pub(crate) fn copy(&self) -> Opened {
        let open = self.open();
        Opened::of(open.state().name, open.without_stencils())
    }

    pub(crate) fn program(
        &self,
        _: &ProgramRequest,
        progress: &dyn Progress,
    ) -> Result<ProgramResponse, ApiError> {
        if let Some(file) = self.run_file() {
            return Ok(file.program());
        }
        let (_, planned) = self.planned(progress)?;
        let time = &planned.setup.model.time;
        let mut wires: Vec<PlayedWire> = planned.wires.iter().filter_map(|plan| played(plan, time)).collect();
        planned.pauses.show(&planned.wires, &mut wires);
        Ok(ProgramResponse {
            machine: planned.setup.machine_id().to_owned(),
            material: planned.setup.material_id().to_owned(),
            diameter_mm: planned.setup.model.wire.diameter.mm(),
            feasible: planned.feasible(),
            job_hash: planned.job()?.map(|job| job.hash().to_owned()),
            without: planned.wires.len() - wires.len(),
            left_out: planned.pauses.left_out.clone(),
            wires,
        })
    }

    pub(crate) fn made(&self, _: &MadeRequest, progress: &dyn Progress) -> Result<MadeResponse, ApiError> {
        if let Some(file) = self.run_file() {
            return self.made_of_file(&file, progress);
        }
        let (app, planned) = self.planned(progress)?;
        let unreached = || PlanningError::StageNotReached {
            stage: crate::StageName::Compensated,
            report: Box::new(planned.report()),
        };
        let job = planned.job()?.ok_or_else(unreached)?;
        made_of(&app, &planned.opened.name, &planned.setup, &job, progress)
    }
}

/// How the machine bends the wires of a job.
pub(super) fn made_of(
    app: &Installation,
    name: &str,
    setup: &Setup,
    job: &Job,
    progress: &dyn Progress,
) -> Result<MadeResponse, ApiError> {
    progress.stage("bending on the simulated machine");
    let mut notes = Vec::new();
    let made = OfDriver(app).bend(setup, job, &mut notes);
    let mut wires = Vec::new();
    let mut by_machine = made.is_some();
    for (index, wire) in job.contents().wires.iter().enumerate() {
        let kept = KeptWire::new(name, wire, setup)?;
        let made = made.as_ref().and_then(|made| made.get(index));
        let placed = made.and_then(|made| Some((made, kept.vertices(&made.corners_mm)?)));
        by_machine &= placed.is_some();
        let (vertices, wire_mm) = placed.map_or_else(
            || (perfect_wire(&kept.input(setup)), Vec::new()),
            |(made, vertices)| (vertices, kept.wire(&made.wire_mm)),
        );
        let deviations_mm: Vec<f64> =
            kept.design.iter().zip(&vertices).map(|(design, made)| (design - made).norm()).collect();
        let ends = wire.spans.iter().map(|&[_, end]| end);
        let corners: Vec<Point3<f64>> =
            std::iter::once(0).chain(ends).filter_map(|k| vertices.get(k)).copied().collect();
        wires.push(MadeWire {
            poses: kept.poses(&corners),
            corners_mm: corners.into_iter().map(array).collect(),
            wire_mm: wire_mm.into_iter().map(array).collect(),
            worst_mm: deviations_mm.iter().copied().fold(0.0, f64::max),
            deviations_mm,
        });
    }
    Ok(MadeResponse { by_machine, wires, notes })
}

fn array(point: Point3<f64>) -> [f64; 3] {
    point.coords.into()
}
