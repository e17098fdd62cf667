//! A sequence for a view that plays it, and one whose steps a person has put in another order.

use std::collections::BTreeSet;

use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::wireframe::{EdgeId, VertexId};
use wirebend_sequence::{Checked, GivenJoint, GivenStep, Outcome, Structure, Task};

use super::SequenceRequest;
use super::builder::BuilderSetup;
use super::report::SequenceResponse;
use crate::{Installation, PlanningError, Progress};

/// A step where a person wants it.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
pub struct OrderedStep {
    pub edge: u32,
    /// All edges of a wire or rod, which is fastened wherever it meets what is built by then; not there for a strut that is drawn.
    #[serde(default)]
    pub edges: Vec<u32>,
    /// The vertex from which the head draws it, where that is built by then; otherwise it is its other end.
    pub from_vertex: Option<u32>,
    /// The direction of the head's axis that is tried first; where it is not free, and where it is absent, all of the machine are.
    pub direction: Option<[f64; 3]>,
}

/// A sequence with what a view draws of it.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct DrawnSequence {
    pub sequence: SequenceResponse,
    /// Half section of the head from its tip: how far along its axis, and its radius, mm.
    pub head_mm: Vec<[f64; 2]>,
    pub strut_radius_mm: f64,
    /// All directions of the head that the machine has.
    pub directions: Vec<[f64; 3]>,
    /// How the head moves in each step.
    pub moves: Vec<HeadMove>,
    /// Whether somebody has stopped the search.
    pub stopped: bool,
}

/// The tip of the head while a strut is built.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct HeadMove {
    pub from_mm: [f64; 3],
    pub to_mm: [f64; 3],
    /// The directions that are free, by their places; of a sequence that is checked only the one that is taken.
    pub free: Vec<usize>,
}

/// What a view draws of an answer.
#[derive(Default)]
pub(super) struct Drawing {
    pub head_mm: Vec<[f64; 2]>,
    pub strut_radius_mm: f64,
    pub directions: Vec<[f64; 3]>,
    pub moves: Vec<HeadMove>,
}

/// Finds a sequence, or checks an order in which a person has put its steps.
pub fn drawn_sequence(
    app: &Installation,
    request: &SequenceRequest,
    order: Option<&[OrderedStep]>,
    progress: &dyn Progress,
) -> Result<DrawnSequence, PlanningError> {
    let (sequence, drawing) = super::run(app, request, order, progress)?;
    let Drawing { head_mm, strut_radius_mm, directions, moves } = drawing;
    Ok(DrawnSequence { sequence, head_mm, strut_radius_mm, directions, moves, stopped: false })
}

impl Drawing {
    pub fn new(setup: &BuilderSetup) -> Self {
        let directions = setup.builder.directions.all().iter();
        Self {
            head_mm: setup.outline.clone(),
            strut_radius_mm: setup.section.radius,
            directions: directions.map(|way| way.into_inner().into()).collect(),
            moves: Vec::new(),
        }
    }

    /// How the head moves in the steps of an answer.
    pub fn moves(&mut self, structure: &Structure, response: &SequenceResponse, outcome: Option<&Outcome>) {
        for (k, step) in response.steps.iter().enumerate() {
            let from = step.from_vertex.unwrap_or_default();
            let strut = structure.strut_of(EdgeId(step.edge));
            let ends = strut.map(|strut| structure.struts()[strut].ends.map(|node| &structure.nodes()[node]));
            let Some([a, b]) = ends else {
                self.moves.push(HeadMove { from_mm: [0.0; 3], to_mm: [0.0; 3], free: Vec::new() });
                continue;
            };
            let (start, end) = if step.edges.is_empty() {
                if b.vertex.0 == from { (b, a) } else { (a, b) }
            } else {
                // It stands still where a wire is fastened first.
                let joint = structure.nodes().iter().find(|node| node.vertex.0 == from).unwrap_or(a);
                (joint, joint)
            };
            let found = outcome.and_then(|outcome| outcome.steps.get(k)?.joints.first());
            let taken = || {
                let direction = step.direction?;
                self.directions.iter().position(|way| is_same(*way, direction))
            };
            let free =
                found.map_or_else(|| taken().into_iter().collect(), |joint| joint.free.iter().collect());
            self.moves.push(HeadMove { from_mm: start.at.coords.into(), to_mm: end.at.coords.into(), free });
        }
    }
}

fn is_same(one: [f64; 3], other: [f64; 3]) -> bool {
    one.iter().zip(other).all(|(a, b)| (a - b).abs() < 1e-6)
}

/// Steps in the order of a person: each is drawn from the end that is built by then, with the head as it stood, where it still can.
fn ordered(order: &[OrderedStep], task: &Task<'_>) -> Vec<GivenStep> {
    let structure = task.structure;
    let mut built: BTreeSet<VertexId> =
        structure.nodes().iter().filter(|node| node.support).map(|node| node.vertex).collect();
    let steps = order.iter().map(|step| {
        if task.builder.is_placed(step.edges.len()) {
            let edges = if step.edges.is_empty() { &[step.edge][..] } else { &step.edges };
            return ordered_wire(edges, &mut built, task);
        }
        let edge = EdgeId(step.edge);
        let strut = structure.strut_of(edge);
        let ends =
            strut.map(|strut| structure.struts()[strut].ends.map(|node| structure.nodes()[node].vertex));
        let wanted = step.from_vertex.map(VertexId);
        let from = wanted
            .filter(|vertex| built.contains(vertex))
            .or_else(|| ends.into_iter().flatten().find(|vertex| built.contains(vertex)))
            .or(wanted);
        built.extend(ends.into_iter().flatten());
        let direction = step.direction.filter(|_| from == wanted);
        let directions = direction.map_or_else(|| all_directions(task), |way| vec![way.into()]);
        GivenStep {
            edges: vec![edge],
            kind: None,
            joints: from.map(|vertex| GivenJoint { vertex, directions }).into_iter().collect(),
        }
    });
    steps.collect()
}

/// A wire is fastened wherever it meets what is built by then, in any direction.
fn ordered_wire(edges: &[u32], built: &mut BTreeSet<VertexId>, task: &Task<'_>) -> GivenStep {
    let structure = task.structure;
    let edges: Vec<EdgeId> = edges.iter().copied().map(EdgeId).collect();
    let struts = edges.iter().filter_map(|&edge| structure.strut_of(edge));
    let ends = struts.flat_map(|strut| structure.struts()[strut].ends);
    let vertices: BTreeSet<VertexId> = ends.map(|node| structure.nodes()[node].vertex).collect();
    let joined = vertices.intersection(built).copied();
    let joints = joined.map(|vertex| GivenJoint { vertex, directions: all_directions(task) }).collect();
    built.extend(vertices);
    GivenStep { edges, kind: None, joints }
}

fn all_directions(task: &Task<'_>) -> Vec<Vector3<f64>> {
    task.builder.directions.all().iter().map(|way| way.into_inner()).collect()
}

/// Checks an order, and once more where the head of a step cannot stand as it stood: in all directions of the machine. To try them at
/// every step would take minutes.
pub(super) fn check_ordered(order: &[OrderedStep], task: &Task<'_>) -> (Vec<GivenStep>, Checked) {
    let mut given = ordered(order, task);
    let mut checked = wirebend_sequence::check(task, &given);
    let mut again = false;
    for (step, free) in given.iter_mut().zip(&checked.free) {
        for (joint, &free) in step.joints.iter_mut().zip(free) {
            if free == 0 && joint.directions.len() == 1 {
                joint.directions = all_directions(task);
                again = true;
            }
        }
    }
    if again {
        checked = wirebend_sequence::check(task, &given);
    }
    (given, checked)
}
