//! A wire as it is played on its machine: what is drawn follows from these values without a rule of bending.

use std::num::NonZeroU32;

use nalgebra::Point3;
use schemars::JsonSchema;
use serde::Serialize;
use wirebend_core::bend::{Frame, Step, replay};
use wirebend_core::compensate::{CompensatedProgram, ToldStep};
use wirebend_core::estimate::{StepSeconds, TimeModel};
use wirebend_core::motion::{MachineStep, Moment, Pose, moments, poses};
use wirebend_core::plan::WirePlan;
use wirebend_core::simulate::scheduled_start;
use wirebend_core::units::{Angle, Length};

use crate::report::JobStep;

/// How the wire lies in the machine while it runs a step. Frame of the machine: mm, right-handed, the origin is the bend
/// point, x the way the wire leaves, z the bend axis of the head at its reference. The point of the wire that is just
/// leaving lies at the origin.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct PoseReport {
    /// From the frame of the design to that of the machine, while the wire is fed and the head rotates: a quaternion of
    /// length 1, x, y, z, w.
    pub turn: [f64; 4],
    /// The axis through the origin about which the wire that is out then turns, a vector of length 1 in the machine's frame.
    pub bend_axis: [f64; 3],
    /// How far it turns, right-handed, degrees.
    pub bend_deg: f64,
}

impl From<&Pose> for PoseReport {
    fn from(pose: &Pose) -> Self {
        Self {
            turn: pose.turn.coords.into(),
            bend_axis: pose.bend_axis.into_inner().into(),
            bend_deg: pose.bend.deg(),
        }
    }
}

/// Where wire and machine are at one moment of a step. Between two moments everything moves evenly.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MomentReport {
    /// The part of the step's time that has passed, from 0 to 1. Two moments at the same time: it jumps.
    pub at: f64,
    /// How much of the feed is through the bend point, from 0 to 1.
    pub fed: f64,
    /// How much of the bend is in the wire, from 0 to 1: it stays.
    pub bent: f64,
    /// How far the head has turned, right-handed about x of the machine's frame, degrees.
    pub head_deg: f64,
    /// How far the bend axis has turned, right-handed about z of the head, degrees: it goes there and comes back.
    pub bend_axis_deg: f64,
    /// Where the peg is along its own axis: at 0 it is in, so that the wire can pass it, at 1 it is out and bends.
    pub peg_out: f64,
}

impl From<&Moment> for MomentReport {
    fn from(moment: &Moment) -> Self {
        let &Moment { at, fed, bent, head, bend_axis, peg_out } = moment;
        Self { at, fed, bent, head_deg: head.deg(), bend_axis_deg: bend_axis.deg(), peg_out }
    }
}

/// A vertex, and which time the wires come to it: where a pause point can be put.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
pub struct PausePlace {
    pub vertex: u32,
    /// From 1, over all wires in their order.
    pub pass: NonZeroU32,
}

/// A step as it is played.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct PlayedStep {
    /// What it does to the wire, as designed.
    pub designed: JobStep,
    /// What is sent to the machine, in canonical signs; null where the wire is not compensated.
    pub told: Option<JobStep>,
    /// Seconds for feed, rotate, the bend axis there and back, and for waiting.
    pub seconds: [f64; 4],
    /// The vertex at which it bends, or at which the wire ends.
    pub vertex: Option<u32>,
    /// The edges along which it feeds.
    pub edges: Vec<u32>,
    /// Where a pause point after it is put; null after the last step, and where the wire is of no open design.
    pub place: Option<PausePlace>,
    /// What a person has to do after it before the machine goes on; null where it does not wait.
    pub pause: Option<String>,
    /// How the wire lies in the machine.
    pub pose: PoseReport,
    /// Where wire and machine are, from the step's beginning to its end.
    pub moments: Vec<MomentReport>,
}

/// A wire as it is played.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct PlayedWire {
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

/// A planned wire; `None` where it has no program.
#[must_use]
pub fn played(plan: &WirePlan, time: &TimeModel) -> Option<PlayedWire> {
    let (nominal, scheduled) = (plan.nominal.as_ref()?, plan.scheduled.as_ref()?);
    let route = plan.route.as_ref()?;
    let told: Vec<ToldStep> = plan.compensated.iter().flat_map(CompensatedProgram::told).collect();
    let start = scheduled_start(plan.start, &scheduled.steps);
    let machine = machine_steps(plan, time)?;
    let poses = poses(start, &scheduled.steps);
    let steps = machine.iter().zip(&poses).zip(moments(&machine)).zip(&nominal.spans).enumerate();
    let steps = steps.map(|(index, (((step, pose), moments), span))| {
        let along = route.traversals.get(span.clone()).unwrap_or_default();
        PlayedStep {
            told: told.get(index).copied().map(JobStep::from),
            vertex: along.last().map(|traversal| traversal.to.0),
            edges: along.iter().map(|traversal| traversal.edge.0).collect(),
            ..played_step(&step.designed, step.seconds, pose, &moments)
        }
    });
    let ends = nominal.spans.iter().map(|span| span.end);
    let corners = std::iter::once(0).chain(ends).filter_map(|k| plan.path.get(k));
    Some(PlayedWire {
        steps: steps.collect(),
        corners_mm: corners.map(array).collect(),
        bend_axis: start.b().into(),
        stock_mm: plan.stock.map(Length::mm),
        time_s: plan.seconds,
    })
}

/// What the machine does in each step of a planned wire; `None` where it has no program.
pub(crate) fn machine_steps(plan: &WirePlan, time: &TimeModel) -> Option<Vec<MachineStep>> {
    let program = plan.compensated.as_ref();
    let told: Vec<ToldStep> = program.into_iter().flat_map(CompensatedProgram::told).collect();
    let steps = plan.scheduled.as_ref()?.steps.iter().enumerate().map(|(index, designed)| {
        let told = told.get(index).copied().unwrap_or_else(|| ToldStep::from(*designed));
        let detour = program.map(|program| program.peg_detour(index)).unwrap_or_default();
        let comes_out = program.and_then(|program| program.peg_comes_out(index));
        let seconds = time.step_seconds(&told, detour);
        MachineStep { designed: *designed, told: told.step, comes_out, seconds }
    });
    Some(steps.collect())
}

/// A wire that moves by hand have bent, as ordered, in the frame of the turtle that begins it: x along the wire, z its bend
/// axis. Each step has its end alone. `bending`: the bend of the last one is under way, and its axis stands there.
#[must_use]
pub fn played_by_hand(steps: &[Step], bending: Option<Angle>) -> PlayedWire {
    let start = Frame::default();
    let mut head = Angle::ZERO;
    let played = |(step, pose): (&Step, Pose)| {
        head -= step.rotate;
        // A bend by hand is a whole one: the peg is in again at its end.
        let end = Moment { at: 1.0, fed: 1.0, bent: 1.0, head, bend_axis: Angle::ZERO, peg_out: 0.0 };
        played_step(step, StepSeconds::default(), &pose, &[end])
    };
    let mut played: Vec<PlayedStep> = steps.iter().zip(poses(start, steps)).map(played).collect();
    let end = played.last_mut().and_then(|step| step.moments.last_mut());
    if let (Some(end), Some(bend_axis)) = (end, bending) {
        (end.bend_axis_deg, end.peg_out) = (bend_axis.deg(), 1.0);
    }
    PlayedWire {
        steps: played,
        corners_mm: replay(start, steps).iter().map(array).collect(),
        bend_axis: start.b().into(),
        stock_mm: None,
        time_s: None,
    }
}

fn played_step(designed: &Step, seconds: StepSeconds, pose: &Pose, moments: &[Moment]) -> PlayedStep {
    let StepSeconds { feed, rotate, bend, wait } = seconds;
    PlayedStep {
        designed: JobStep::from(*designed),
        told: None,
        seconds: [feed, rotate, bend, wait],
        vertex: None,
        edges: Vec::new(),
        place: None,
        pause: None,
        pose: PoseReport::from(pose),
        moments: moments.iter().map(MomentReport::from).collect(),
    }
}

fn array(point: &Point3<f64>) -> [f64; 3] {
    point.coords.into()
}
