//! The program of the open design, step by step as it is played, and the wire as its machine makes it.

use nalgebra::Point3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::compensate::CompensatedProgram;
use wirebend_core::estimate::TimeModel;
use wirebend_core::plan::WirePlan;
use wirebend_core::simulate::{perfect_wire, scheduled_start};
use wirebend_core::units::Angle;

use super::Desk;
use crate::design::Opened;
use crate::plan::Planned;
use crate::report::{NoteReport, StepReport};
use crate::simulate::{KeptWire, on_machine};
use crate::{App, AppError, PlanChoices, Progress};

/// Asks for the program of the open design.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ProgramRequest {}

/// A step as it is played.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct PlayedStep {
    /// What it does to the wire, as designed.
    pub designed: StepReport,
    /// What the machine is told, in canonical signs; null where the wire is not compensated.
    pub told: Option<StepReport>,
    /// Seconds for feed, rotate, the bend axis there and back, and for waiting.
    pub seconds: [f64; 4],
    /// The vertex at which it bends, or at which the wire ends.
    pub vertex: Option<u32>,
    /// The edges along which it feeds.
    pub edges: Vec<u32>,
}

/// A wire as it is played.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct PlayedWire {
    /// The steps.
    pub steps: Vec<PlayedStep>,
    /// Where the wire begins, and where it is after each step: one more than there are steps. mm, in the design's frame.
    pub corners_mm: Vec<[f64; 3]>,
    /// The bend axis at the beginning, a vector of length 1 in the design's frame.
    pub bend_axis: [f64; 3],
    /// Stock to load, mm.
    pub stock_mm: Option<f64>,
    /// Time on the machine, s.
    pub time_s: Option<f64>,
}

/// The program of the open design.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ProgramResponse {
    /// The machine.
    pub machine: String,
    /// The material.
    pub material: String,
    /// Diameter of the wire, mm.
    pub diameter_mm: f64,
    /// Whether the machine can make it.
    pub feasible: bool,
    /// Hash of the job that arming the design as it is would make; null where none can be made. A wire of the
    /// connected machine whose job has this hash is one of this very program.
    pub job_hash: Option<String>,
    /// The wires that have a program.
    pub wires: Vec<PlayedWire>,
    /// Wires that have none: the checks say why.
    pub without: usize,
}

/// Asks how the machine makes the open design.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct MadeRequest {}

/// A wire as it is made.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MadeWire {
    /// Its ends and corners, one more than there are steps, mm, laid beside the design with the first edge in place.
    pub corners_mm: Vec<[f64; 3]>,
    /// Points along its middle, mm; empty where only formulas made it.
    pub wire_mm: Vec<[f64; 3]>,
    /// How far each vertex of the route is from the design, mm.
    pub deviations_mm: Vec<f64>,
    /// The largest of them.
    pub worst_mm: f64,
}

/// How the machine makes the open design.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MadeResponse {
    /// Whether the driver's simulated machine made it; otherwise the formulas of the compensation did, backwards.
    pub by_machine: bool,
    /// The wires, in the order of the program.
    pub wires: Vec<MadeWire>,
    /// What the machine told, and what was left out.
    pub notes: Vec<NoteReport>,
}

impl Desk {
    /// The open design through the whole pipeline; the desk is free meanwhile.
    pub(super) fn planned(
        &self,
        progress: &dyn Progress,
    ) -> Result<(std::sync::Arc<App>, Planned), AppError> {
        let (app, opened) = (self.app(), self.copy());
        let planned = app.plan_design(opened, &PlanChoices::default(), progress)?;
        Ok((app, planned))
    }

    /// The open design without its stencil, which is no part of what is bent.
    pub(super) fn copy(&self) -> Opened {
        let open = self.open();
        Opened::of(open.state().name, open.without_stencil())
    }

    pub(super) fn program(
        &self,
        _: &ProgramRequest,
        progress: &dyn Progress,
    ) -> Result<ProgramResponse, AppError> {
        let (_, planned) = self.planned(progress)?;
        let time = &planned.setup.model.time;
        let wires: Vec<PlayedWire> = planned.wires.iter().filter_map(|plan| played(plan, time)).collect();
        Ok(ProgramResponse {
            machine: planned.setup.machine_id().to_owned(),
            material: planned.setup.material_id().to_owned(),
            diameter_mm: planned.setup.model.wire.diameter.mm(),
            feasible: planned.feasible(),
            job_hash: planned.job()?.map(|job| job.hash().to_owned()),
            without: planned.wires.len() - wires.len(),
            wires,
        })
    }

    pub(super) fn made(&self, _: &MadeRequest, progress: &dyn Progress) -> Result<MadeResponse, AppError> {
        let (app, planned) = self.planned(progress)?;
        let unreached =
            || AppError::StageNotReached { stage: "compensated", report: Box::new(planned.report()) };
        let job = planned.job()?.ok_or_else(unreached)?;
        progress.stage("bending on the simulated machine");
        let mut notes = Vec::new();
        let made = on_machine(&app, &planned.setup, &job, &mut notes);
        let mut wires = Vec::new();
        let mut by_machine = made.is_some();
        for (index, wire) in job.contents().wires.iter().enumerate() {
            let kept = KeptWire::new(&planned.opened.name, wire, &planned.setup)?;
            let made = made.as_ref().and_then(|made| made.get(index));
            let placed = made.and_then(|made| Some((made, kept.vertices(&made.corners_mm)?)));
            by_machine &= placed.is_some();
            let (vertices, wire_mm) = placed.map_or_else(
                || (perfect_wire(&kept.trial(&planned.setup)), Vec::new()),
                |(made, vertices)| (vertices, kept.wire(&made.wire_mm)),
            );
            let deviations_mm: Vec<f64> =
                kept.design.iter().zip(&vertices).map(|(design, made)| (design - made).norm()).collect();
            let ends = wire.spans.iter().map(|&[_, end]| end);
            let corners = std::iter::once(0).chain(ends).filter_map(|k| vertices.get(k));
            wires.push(MadeWire {
                corners_mm: corners.map(|&point| array(point)).collect(),
                wire_mm: wire_mm.into_iter().map(array).collect(),
                worst_mm: deviations_mm.iter().copied().fold(0.0, f64::max),
                deviations_mm,
            });
        }
        Ok(MadeResponse { by_machine, wires, notes })
    }
}

fn array(point: Point3<f64>) -> [f64; 3] {
    point.coords.into()
}

fn played(plan: &WirePlan, time: &TimeModel) -> Option<PlayedWire> {
    let (nominal, scheduled) = (plan.nominal.as_ref()?, plan.scheduled.as_ref()?);
    let route = plan.route.as_ref()?;
    let told = plan.compensated.as_ref().map(CompensatedProgram::steps);
    let steps = scheduled.steps.iter().zip(&nominal.spans).enumerate().map(|(index, (step, span))| {
        let told = told.and_then(|told| told.get(index));
        let moved = told.unwrap_or(step);
        let bends = moved.bend != Angle::ZERO;
        let wait = if bends { time.fixed_per_bend_s } else { 0.0 };
        let along = route.traversals.get(span.clone()).unwrap_or_default();
        PlayedStep {
            designed: StepReport::from(step),
            told: told.map(StepReport::from),
            seconds: [
                moved.feed.abs().mm() / time.feed_mm_per_s,
                moved.rotate.abs().deg() / time.rotate_deg_per_s,
                if bends { time.bend_seconds(moved.bend) - wait } else { 0.0 },
                wait,
            ],
            vertex: along.last().map(|traversal| traversal.to.0),
            edges: along.iter().map(|traversal| traversal.edge.0).collect(),
        }
    });
    let ends = nominal.spans.iter().map(|span| span.end);
    let corners = std::iter::once(0).chain(ends).filter_map(|k| plan.path.get(k));
    Some(PlayedWire {
        steps: steps.collect(),
        corners_mm: corners.map(|&point| array(point)).collect(),
        bend_axis: scheduled_start(plan.start, &scheduled.steps).b().into(),
        stock_mm: plan.stock.map(wirebend_core::units::Length::mm),
        time_s: plan.seconds,
    })
}
