//! What is answered: a sequence with its figures, or why there is none.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::time::Instant;
use wirebend_core::checks::sequence::StepKind;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::checks::Diagnostic;
use wirebend_sequence::{
    Checked, GivenStep, Obstacle, ObstacleRule, Outcome, Partial, Step, Strategy, Structure, Task, cost,
};

use super::builder::BuilderSetup;
use super::findings;
use crate::design::Opened;
use crate::report::{DiagnosticReport, NoteReport};

/// The order in which a frame is built.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct SequenceResponse {
    /// The strut builder.
    pub machine: String,
    pub material: String,
    /// What is placed, the first step foremost; empty where no order was found.
    pub steps: Vec<SequenceStepReport>,
    /// The largest sag of all steps; null without steps, or where what is built does not stand.
    pub max_displacement_mm: Option<f64>,
    /// How far a joint may be from where it is drawn.
    pub epsilon_mm: f64,
    /// How many steps share a vertex with the one before.
    pub sharing: usize,
    /// How far the head travels between struts; null where a sequence is checked.
    pub travel_mm: Option<f64>,
    /// How many directions of the head are free where fewest are; null where a sequence is checked.
    pub min_free_directions: Option<usize>,
    /// The edges of each layer, from the ground; null where nobody asked, or the frame as a whole cannot be built.
    pub layers: Option<Vec<Vec<u32>>>,
    /// Whether the frame can be built in this order.
    pub feasible: bool,
    /// Whether that is certain; a search that ended early knows nothing of orders that it did not try.
    pub proved: bool,
    /// How the order was found; null where none was, or one is checked.
    pub strategy: Option<StrategyName>,
    /// What was in the way where a search came farthest.
    pub obstacle: Option<ObstacleReport>,
    /// The longest part of an order that was found; null where all of it was, or none can be.
    pub partial: Option<PartialReport>,
    pub diagnostics: Vec<DiagnosticReport>,
    /// What was merged, ignored or assumed while reading.
    pub notes: Vec<NoteReport>,
    /// How long the machine takes; null where a sequence is checked.
    pub time_s: Option<f64>,
    pub timings_ms: BTreeMap<&'static str, f64>,
    #[serde(skip)]
    pub files: Vec<PathBuf>,
}

/// A part of an order: the edges of each step.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct PartialReport {
    /// How it begins; empty where the search takes the frame apart from its end.
    pub first: Vec<Vec<u32>>,
    /// How it ends; empty where the search builds it up.
    pub last: Vec<Vec<u32>>,
}

/// What is placed at once.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct SequenceStepReport {
    /// Its edge, or the first of several.
    pub edge: u32,
    /// The vertex from which the head draws it, or at which it stands first.
    pub from_vertex: Option<u32>,
    #[serde(rename = "type")]
    pub kind: StepTypeName,
    /// The direction of the head's axis, from the tip into the head.
    pub direction: Option<[f64; 3]>,
    /// How many directions are free, at the joint with the fewest; where a sequence is checked, of those that it gives.
    pub free_directions: usize,
    /// The largest displacement of a vertex once it is placed; null where what is built does not stand.
    pub max_displacement_mm: Option<f64>,
    /// All edges of a wire or rod; not there for a strut that is drawn.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub edges: Vec<u32>,
    /// How the head stands at each joint of a wire or rod; not there for a strut that is drawn.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub joints: Vec<SequenceJoint>,
}

/// How the head stands at a joint.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct SequenceJoint {
    pub vertex: u32,
    pub direction: [f64; 3],
    pub free_directions: usize,
}

/// What a step adds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum StepTypeName {
    /// What stands on the ground.
    Ground,
    /// A strut into the open.
    Create,
    /// A strut between vertices that are built.
    Connect,
}

impl From<StepKind> for StepTypeName {
    fn from(kind: StepKind) -> Self {
        match kind {
            StepKind::Ground => Self::Ground,
            StepKind::Create => Self::Create,
            StepKind::Connect => Self::Connect,
        }
    }
}

impl From<StepTypeName> for StepKind {
    fn from(name: StepTypeName) -> Self {
        match name {
            StepTypeName::Ground => Self::Ground,
            StepTypeName::Create => Self::Create,
            StepTypeName::Connect => Self::Connect,
        }
    }
}

/// How an order was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum StrategyName {
    /// What is farthest from the ground is built last.
    FromGround,
    /// What keeps the frame stiffest is built first.
    StiffnessPlan,
    /// What was in the way of earlier searches is built later.
    Restart,
    /// Going back from dead ends.
    Backtracking,
    /// Layer by layer, by the cost of `FrameFab`.
    PaperCost,
}

impl From<Strategy> for StrategyName {
    fn from(strategy: Strategy) -> Self {
        match strategy {
            Strategy::FromGround => Self::FromGround,
            Strategy::StiffnessPlan => Self::StiffnessPlan,
            Strategy::Restart(_) => Self::Restart,
            Strategy::Backtracking => Self::Backtracking,
            Strategy::PaperCost => Self::PaperCost,
        }
    }
}

/// What was in the way where a search came farthest.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ObstacleReport {
    /// The step, from 1, that none of what stands then can be.
    pub step: usize,
    pub rule: ObstacleRuleName,
    /// The strut that cannot be placed then; null where it is the frame as a whole.
    pub edge: Option<u32>,
    /// The struts in its way, or at the vertex that sags.
    pub edges: Vec<u32>,
    /// The vertex that sags or is out of reach.
    pub vertex: Option<u32>,
    /// How far it sags.
    pub displacement_mm: Option<f64>,
}

/// A rule of building.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ObstacleRuleName {
    /// The finished frame sags too far.
    WholeFrame,
    /// What stands sags too far.
    Sag,
    /// The head cannot stand in any direction.
    HeadDirection,
    /// Something hangs on nothing.
    Floating,
    /// The tip does not get there.
    Workspace,
}

/// An answer while its parts come in.
pub(super) struct Answer {
    response: SequenceResponse,
}

impl Answer {
    pub fn new(opened: &Opened, setup: &BuilderSetup) -> Self {
        let response = SequenceResponse {
            machine: setup.machine.clone(),
            material: setup.material.id.clone(),
            steps: Vec::new(),
            max_displacement_mm: None,
            epsilon_mm: setup.builder.max_sag.mm(),
            sharing: 0,
            travel_mm: None,
            min_free_directions: None,
            layers: None,
            feasible: false,
            proved: true,
            strategy: None,
            obstacle: None,
            partial: None,
            diagnostics: Vec::new(),
            notes: opened.notes.clone(),
            time_s: None,
            timings_ms: BTreeMap::new(),
            files: Vec::new(),
        };
        Self { response }
    }

    pub fn took(&mut self, part: &'static str, since: Instant) {
        self.response.timings_ms.insert(part, since.elapsed().as_secs_f64() * 1000.0);
    }

    pub fn notes(&mut self, notes: impl IntoIterator<Item = NoteReport>) {
        self.response.notes.extend(notes);
    }

    pub fn layers(&mut self, structure: &Structure, layer: &[usize]) {
        let count = layer.iter().max().map_or(0, |top| top + 1);
        let mut layers = vec![Vec::new(); count];
        for (strut, &layer) in layer.iter().enumerate() {
            layers[layer].push(structure.struts()[strut].edge.0);
        }
        self.response.layers = Some(layers);
    }

    /// A design that is no frame.
    pub fn refused(mut self, diagnostics: &[Diagnostic]) -> SequenceResponse {
        self.response.diagnostics.extend(diagnostics.iter().map(DiagnosticReport::from));
        self.response
    }

    /// What came of a search. `refused` is what an independent check says against it.
    pub fn found(mut self, task: &Task<'_>, outcome: &Outcome, refused: Vec<Diagnostic>) -> SequenceResponse {
        let mut diagnostics = refused;
        let found = outcome.is_found();
        let response = &mut self.response;
        response.feasible = found && diagnostics.is_empty();
        response.proved = outcome.proved;
        if found {
            let cost = cost(&outcome.steps, task.structure, task.builder);
            response.sharing = cost.sharing;
            response.travel_mm = Some(cost.travel.mm());
            response.min_free_directions = Some(cost.least_free);
            response.time_s = Some(cost.seconds);
            response.max_displacement_mm =
                Some(outcome.steps.iter().map(|step| step.max_sag_mm).fold(0.0, f64::max));
            response.strategy = outcome.strategy.map(StrategyName::from);
            response.steps = outcome.steps.iter().map(|step| step_report(task, step)).collect();
        } else {
            response.partial = partial_report(task, outcome);
            response.obstacle = outcome.obstacle.as_ref().map(|obstacle| obstacle_report(task, obstacle));
            diagnostics.extend(findings::not_found(task, outcome.obstacle.as_ref(), outcome.proved));
        }
        response.diagnostics = diagnostics.iter().map(DiagnosticReport::from).collect();
        self.response
    }

    /// A sequence that was given, as it was checked.
    pub fn checked(mut self, task: &Task<'_>, given: &[GivenStep], checked: &Checked) -> SequenceResponse {
        let response = &mut self.response;
        let structure = task.structure;
        let mut before: Vec<usize> = Vec::new();
        for (k, step) in given.iter().enumerate() {
            let struts = step.edges.iter().filter_map(|&edge| structure.strut_of(edge));
            let nodes: Vec<usize> = struts.flat_map(|strut| structure.struts()[strut].ends).collect();
            response.sharing += usize::from(nodes.iter().any(|node| before.contains(node)));
            before = nodes;
            let free = checked.free.get(k).map(Vec::as_slice).unwrap_or_default();
            let (is, sag_mm) =
                (checked.kinds.get(k).copied().flatten(), checked.sags_mm.get(k).copied().flatten());
            response.steps.push(given_report(task, step, is, free, sag_mm));
        }
        let sags: Option<Vec<f64>> = checked.sags_mm.iter().copied().collect();
        response.max_displacement_mm =
            sags.filter(|sags| !sags.is_empty()).map(|sags| sags.into_iter().fold(0.0, f64::max));
        response.feasible = checked.violations.is_empty();
        let diagnostics = checked.violations.iter().map(findings::violation);
        response.diagnostics = diagnostics.map(|found| DiagnosticReport::from(&found)).collect();
        self.response
    }
}

fn step_report(task: &Task<'_>, step: &Step) -> SequenceStepReport {
    let structure = task.structure;
    let joint = |joint: &wirebend_sequence::Joint| SequenceJoint {
        vertex: structure.nodes()[joint.node].vertex.0,
        direction: task.builder.directions.all()[joint.direction].into_inner().into(),
        free_directions: joint.free.len(),
    };
    let joints: Vec<SequenceJoint> = step.joints.iter().map(joint).collect();
    let edges: Vec<u32> = step.struts.iter().map(|&strut| structure.struts()[strut].edge.0).collect();
    let placed = task.builder.is_placed(edges.len());
    SequenceStepReport {
        edge: edges.first().copied().unwrap_or_default(),
        from_vertex: joints.first().map(|joint| joint.vertex),
        kind: step.kind.into(),
        direction: joints.first().map(|joint| joint.direction),
        free_directions: joints.iter().map(|joint| joint.free_directions).min().unwrap_or(0),
        max_displacement_mm: Some(step.max_sag_mm),
        edges: if placed { edges } else { Vec::new() },
        joints: if placed { joints } else { Vec::new() },
    }
}

fn given_report(
    task: &Task<'_>,
    step: &GivenStep,
    is: Option<StepKind>,
    free: &[usize],
    sag_mm: Option<f64>,
) -> SequenceStepReport {
    let placed = task.builder.is_placed(step.edges.len());
    let direction = |joint: &wirebend_sequence::GivenJoint| joint.directions.first().map(|way| (*way).into());
    let joints = step.joints.iter().zip(free).filter_map(|(joint, &free_directions)| {
        Some(SequenceJoint { vertex: joint.vertex.0, direction: direction(joint)?, free_directions })
    });
    SequenceStepReport {
        edge: step.edges.first().map_or(0, |edge| edge.0),
        from_vertex: step.joints.first().map(|joint| joint.vertex.0),
        // A step that builds nothing is what it is said to be.
        kind: is.or(step.kind).map_or(StepTypeName::Connect, StepTypeName::from),
        direction: step.joints.first().and_then(direction),
        free_directions: free.iter().copied().min().unwrap_or(0),
        max_displacement_mm: sag_mm,
        edges: if placed { step.edges.iter().map(|edge| edge.0).collect() } else { Vec::new() },
        joints: if placed { joints.collect() } else { Vec::new() },
    }
}

fn partial_report(task: &Task<'_>, outcome: &Outcome) -> Option<PartialReport> {
    let Partial { first, last } = &outcome.partial;
    let edge = |strut: &usize| task.structure.struts()[*strut].edge.0;
    let edges = |steps: &[Vec<usize>]| steps.iter().map(|step| step.iter().map(edge).collect()).collect();
    (first.len() + last.len() > 0).then(|| PartialReport { first: edges(first), last: edges(last) })
}

fn obstacle_report(task: &Task<'_>, obstacle: &Obstacle) -> ObstacleReport {
    let structure = task.structure;
    let edge = |strut: &usize| structure.struts()[*strut].edge.0;
    let (rule, node, displacement_mm) = match obstacle.rule {
        ObstacleRule::WholeFrame { node, sag_mm } => (ObstacleRuleName::WholeFrame, Some(node), sag_mm),
        ObstacleRule::Sags { node, sag_mm } | ObstacleRule::SagsWith { node, sag_mm } => {
            (ObstacleRuleName::Sag, Some(node), sag_mm)
        }
        ObstacleRule::NoDirection => (ObstacleRuleName::HeadDirection, None, None),
        ObstacleRule::Floating => (ObstacleRuleName::Floating, None, None),
        ObstacleRule::OutOfReach { node } => (ObstacleRuleName::Workspace, Some(node), None),
    };
    ObstacleReport {
        step: obstacle.step,
        rule,
        edge: obstacle.strut.as_ref().map(edge),
        edges: obstacle.struts.iter().map(edge).collect(),
        vertex: node.map(|node| structure.nodes()[node].vertex.0),
        displacement_mm,
    }
}
