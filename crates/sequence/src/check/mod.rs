//! Whether a sequence can be built: everything anew from the drawing, with nothing of the search.
//!
//! The head's distance is measured to its real surface, by narrowing down over motion and strut; the stiffness is that of a frame
//! of only what stands.

mod given;
mod head;
mod stands;

pub use given::{GivenJoint, GivenStep};

use std::collections::{BTreeMap, BTreeSet};

use wirebend_core::checks::sequence::{StepKind, Violation};
use wirebend_core::units::{Angle, Length};
use wirebend_core::wireframe::{EdgeId, VertexId};

use super::search::Task;

/// What was found out about a sequence.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Checked {
    /// All that is wrong, step by step; nothing where it can be built.
    pub violations: Vec<Violation>,
    /// The largest sag after each step, mm; none where it does not stand.
    pub sags_mm: Vec<Option<f64>>,
    /// What each step is; none where it builds nothing.
    pub kinds: Vec<Option<StepKind>>,
    /// Of each step and each joint that is given, how many of its directions are free.
    pub free: Vec<Vec<usize>>,
    /// The first of them that is free, by its place among those that are given.
    pub first_free: Vec<Vec<Option<usize>>>,
}

/// Checks a sequence, all of it: a step that cannot be made is taken as made for those after it.
#[must_use]
pub fn check(task: &Task<'_>, steps: &[GivenStep]) -> Checked {
    let structure = task.structure;
    let mut run = Run {
        task,
        checked: Checked::default(),
        standing: Vec::new(),
        built: BTreeMap::new(),
        unreached: BTreeSet::new(),
        fallen: false,
        others: false,
    };
    for node in structure.nodes().iter().filter(|node| node.support) {
        run.built.insert(node.vertex, 0);
    }
    let mut first: BTreeMap<EdgeId, usize> = BTreeMap::new();
    for (k, step) in steps.iter().enumerate() {
        let number = k + 1;
        run.checked.kinds.push(None);
        run.checked.free.push(vec![0; step.joints.len()]);
        run.checked.first_free.push(vec![None; step.joints.len()]);
        let mut struts = Vec::new();
        for &edge in &step.edges {
            match (structure.strut_of(edge), first.get(&edge)) {
                (None, _) => run.found(Violation::UnknownEdge { step: number, edge }),
                (Some(_), Some(&first)) => run.found(Violation::Twice { step: number, edge, first }),
                (Some(strut), None) => {
                    first.insert(edge, number);
                    struts.push(strut);
                }
            }
        }
        if struts.is_empty() {
            if step.edges.is_empty() {
                run.found(Violation::Empty { step: number });
            }
            run.checked.sags_mm.push(run.checked.sags_mm.last().copied().flatten());
            continue;
        }
        run.place(number, step, &struts);
    }
    let edges: Vec<EdgeId> =
        structure.struts().iter().map(|strut| strut.edge).filter(|edge| !first.contains_key(edge)).collect();
    if !edges.is_empty() {
        run.found(Violation::Missing { edges });
    }
    run.checked
}

/// A sequence while it is followed.
struct Run<'a> {
    task: &'a Task<'a>,
    checked: Checked,
    standing: Vec<usize>,
    /// The step that built each vertex; 0 of the ground.
    built: BTreeMap<VertexId, usize>,
    /// The vertices that were named as out of reach.
    unreached: BTreeSet<VertexId>,
    /// Whether something was built that did not stand.
    fallen: bool,
    /// Whether a strut stands that is not on the ground.
    others: bool,
}

impl Run<'_> {
    fn found(&mut self, violation: Violation) {
        self.checked.violations.push(violation);
    }

    fn place(&mut self, number: usize, step: &GivenStep, struts: &[usize]) {
        let structure = self.task.structure;
        let mut vertices: Vec<VertexId> = struts
            .iter()
            .flat_map(|&strut| structure.struts()[strut].ends)
            .map(|node| structure.nodes()[node].vertex)
            .collect();
        vertices.sort_unstable();
        vertices.dedup();
        let edge = structure.struts()[struts[0]].edge;
        let grounded = struts.iter().any(|&strut| structure.is_grounded(strut));
        let joined: Vec<VertexId> =
            vertices.iter().copied().filter(|vertex| self.built.contains_key(vertex)).collect();
        if joined.is_empty() {
            self.found(Violation::Floating { step: number, edge, vertex: None });
        }
        let is = match (grounded, joined.len() == vertices.len()) {
            (true, _) => StepKind::Ground,
            (false, true) => StepKind::Connect,
            (false, false) => StepKind::Create,
        };
        if let Some(kind) = self.checked.kinds.last_mut() {
            *kind = Some(is);
        }
        if let Some(said) = step.kind.filter(|said| *said != is) {
            self.found(Violation::WrongKind { step: number, said, is });
        }
        if grounded && self.others && self.task.builder.ground_first {
            self.found(Violation::GroundLate { step: number, edge });
        }
        for (place, joint) in step.joints.iter().enumerate() {
            if !vertices.contains(&joint.vertex) {
                self.found(Violation::NotAnEnd { step: number, vertex: joint.vertex });
            } else if !self.built.contains_key(&joint.vertex) {
                self.found(Violation::Floating { step: number, edge, vertex: Some(joint.vertex) });
            } else {
                let free = self.head(number, joint, struts, joined.len() == vertices.len());
                if let Some(of_joints) = self.checked.free.last_mut() {
                    of_joints[place] = free.len();
                }
                if let Some(of_joints) = self.checked.first_free.last_mut() {
                    of_joints[place] = free.first().copied();
                }
            }
        }
        // A strut is drawn from one end; a wire or rod is fastened wherever it meets what is built.
        let placed = self.task.builder.is_placed(struts.len());
        let needed = if placed { joined.len() } else { joined.len().min(1) };
        let given = |vertex: &VertexId| step.joints.iter().any(|joint| joint.vertex == *vertex);
        if placed || step.joints.is_empty() {
            for &vertex in joined[..needed].iter().filter(|vertex| !given(vertex)) {
                self.found(Violation::JointMissing { step: number, vertex });
            }
        }
        for node in struts.iter().flat_map(|&strut| structure.struts()[strut].ends) {
            let node = structure.nodes()[node];
            if !self.task.builder.reaches(&node.at) && self.unreached.insert(node.vertex) {
                self.found(Violation::OutOfReach { step: number, vertex: node.vertex });
            }
        }
        for vertex in vertices {
            self.built.entry(vertex).or_insert(number);
        }
        self.standing.extend(struts);
        self.others |= !grounded;
        self.sag(number);
    }

    fn sag(&mut self, step: usize) {
        let max = self.task.builder.max_sag;
        let sagging = stands::sag(self.task, &self.standing);
        self.checked.sags_mm.push(sagging.mm);
        if sagging.mm.is_none_or(|mm| mm > max.mm() + stands::ROUNDING_MM) {
            // What has fallen once stays down.
            if sagging.mm.is_none() && std::mem::replace(&mut self.fallen, true) {
                return;
            }
            let sag = sagging.mm.map(Length::computed);
            self.found(Violation::Sags { step, vertex: sagging.vertex, sag, max });
        }
    }

    /// The head at one joint: one of the given directions has to be free. Which are.
    fn head(&mut self, step: usize, joint: &GivenJoint, struts: &[usize], connects: bool) -> Vec<usize> {
        let (structure, builder) = (self.task.structure, self.task.builder);
        let placed = builder.is_placed(struts.len());
        let way = head::way(structure, (!placed).then_some(struts[0]), joint.vertex);
        let own = if placed { struts } else { &[] };
        let [mut steepest, mut contact] = [None::<Violation>, None];
        let mut free = Vec::new();
        for (place, direction) in joint.directions.iter().enumerate() {
            // Squares of large figures are no numbers, and a vector over its length is then none of length 1.
            let length = Some(direction.norm()).filter(|length| length.is_finite() && *length > 1e-9);
            let Some(axis) = length.map(|length| direction / length) else {
                self.found(Violation::NoDirection { step, vertex: joint.vertex });
                continue;
            };
            let max = if connects { builder.max_connect } else { builder.max_create };
            let angle = Angle::computed(way.along.map_or(0.0, |along| axis.angle(&along)));
            // Directions are often written with three digits.
            if !placed && angle.rad() > max.rad() + given::ROUNDING_RAD {
                let least =
                    matches!(&steepest, Some(Violation::Approach { angle: least, .. }) if *least <= angle);
                if !least {
                    steepest = Some(Violation::Approach { step, angle, max });
                }
                continue;
            }
            match head::first_met(self.task, &self.standing, own, &way, &axis) {
                None => free.push(place),
                Some(met) => {
                    contact.get_or_insert(Violation::HeadMeets {
                        step,
                        edge: structure.struts()[met.strut].edge,
                        distance: Length::computed(met.distance),
                        least: Length::computed(met.least),
                    });
                }
            }
        }
        if free.is_empty() {
            if let Some(violation) = contact.or(steepest) {
                self.found(violation);
            } else if joint.directions.is_empty() {
                self.found(Violation::NoDirection { step, vertex: joint.vertex });
            }
        }
        free
    }
}
