//! A frame that is built step by step.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::{Point3, Vector3};

use crate::fault::Fault;
use crate::head::nearest;
use crate::standing::Standing;
use crate::{Kind, Step, Task};

/// Figures that are computed in two ways differ by less, mm.
const ROUNDING_MM: f64 = 0.002;
const ROUNDING_OF_SAG_MM: f64 = 1e-6;

pub(crate) fn faults(task: &Task, steps: &[Step]) -> Vec<Fault> {
    let supports = task.vertices.iter().filter(|(_, vertex)| vertex.support).map(|(&vertex, _)| vertex);
    let mut building = Building {
        task,
        frame: Standing::new(task),
        built: supports.collect(),
        standing: Vec::new(),
        first: BTreeMap::new(),
        beyond: BTreeSet::new(),
        fallen: false,
        others: false,
        faults: Vec::new(),
    };
    for (k, step) in steps.iter().enumerate() {
        building.take(k + 1, step);
    }
    let left = task.edges.keys().copied().filter(|edge| !building.first.contains_key(edge));
    let edges: Vec<u32> = left.collect();
    if !edges.is_empty() {
        building.faults.push(Fault::NeverBuilt { edges });
    }
    building.faults
}

struct Building<'a> {
    task: &'a Task,
    frame: Standing<'a>,
    /// The vertices where something is built, with the ground.
    built: BTreeSet<u32>,
    standing: Vec<u32>,
    /// The step that built each edge.
    first: BTreeMap<u32, usize>,
    /// The vertices that were said to be out of reach.
    beyond: BTreeSet<u32>,
    fallen: bool,
    /// Whether something was placed that is not on the ground.
    others: bool,
    faults: Vec<Fault>,
}

impl Building<'_> {
    fn take(&mut self, step: usize, given: &Step) {
        let mut edges = Vec::new();
        for &edge in &given.edges {
            if !self.task.edges.contains_key(&edge) {
                self.faults.push(Fault::UnknownEdge { step, edge });
            } else if let Some(&first) = self.first.get(&edge) {
                self.faults.push(Fault::BuiltTwice { step, edge, first });
            } else {
                self.first.insert(edge, step);
                edges.push(edge);
            }
        }
        if given.edges.is_empty() {
            self.faults.push(Fault::Empty { step });
        }
        if !edges.is_empty() {
            self.place(step, given, &edges);
        }
    }

    fn place(&mut self, step: usize, given: &Step, edges: &[u32]) {
        let task = self.task;
        let vertices: BTreeSet<u32> = edges.iter().flat_map(|edge| task.edges[edge]).collect();
        let joined: Vec<u32> = vertices.intersection(&self.built).copied().collect();
        let on_ground = |edge: &u32| task.edges[edge].iter().any(|end| task.vertices[end].support);
        let is = if edges.iter().any(on_ground) {
            Kind::Ground
        } else if joined.len() == vertices.len() {
            Kind::Connect
        } else {
            Kind::Create
        };
        if joined.is_empty() {
            self.faults.push(Fault::Floating { step });
        }
        if let Some(said) = given.kind.filter(|said| *said != is) {
            self.faults.push(Fault::OtherKind { step, said, is });
        }
        if is == Kind::Ground && self.others && task.machine.ground_first {
            self.faults.push(Fault::GroundLate { step });
        }
        self.others |= is != Kind::Ground;
        for (vertex, axes) in &given.joints {
            if !vertices.contains(vertex) {
                self.faults.push(Fault::NotAnEnd { step, vertex: *vertex });
            } else if !self.built.contains(vertex) {
                self.faults.push(Fault::NothingBuilt { step, vertex: *vertex });
            } else {
                let into_the_open = joined.len() < vertices.len();
                self.stand(step, edges, *vertex, axes, into_the_open);
            }
        }
        // A strut is drawn from one of its ends, a wire or rod is fastened at all.
        let placed = task.machine.is_placed(edges.len());
        let needed = if placed { &joined[..] } else { &joined[..joined.len().min(1)] };
        for &vertex in needed {
            let there = given.joints.iter().any(|(joint, _)| !placed || *joint == vertex);
            if !there {
                self.faults.push(Fault::JointMissing { step, vertex });
            }
        }
        for &vertex in &vertices {
            let at = task.at(vertex);
            let reached = task
                .machine
                .workspace
                .is_none_or(|[low, high]| (0..3).all(|axis| (low[axis]..=high[axis]).contains(&at[axis])));
            if !reached && self.beyond.insert(vertex) {
                self.faults.push(Fault::OutOfReach { step, vertex });
            }
        }
        self.built.extend(vertices);
        self.standing.extend(edges);
        match self.frame.sag(&self.standing) {
            Some((vertex, mm)) if mm > task.machine.max_sag_mm + ROUNDING_OF_SAG_MM => {
                self.faults.push(Fault::Sags { step, vertex, mm });
            }
            None if !std::mem::replace(&mut self.fallen, true) => self.faults.push(Fault::Falls { step }),
            _ => {}
        }
    }

    /// The head at a vertex of what is placed, or on its way from there along a strut.
    fn stand(&mut self, step: usize, edges: &[u32], vertex: u32, axes: &[Vector3<f64>], into_the_open: bool) {
        let task = self.task;
        let at = task.at(vertex);
        let (mut motion, mut touched, mut seen) = ([at; 2], vec![vertex], self.standing.clone());
        let placed = task.machine.is_placed(edges.len());
        if let ([strut], false) = (edges, placed) {
            let ends = task.edges[strut];
            motion[1] = task.at(if ends[0] == vertex { ends[1] } else { ends[0] });
            touched = ends.to_vec();
        } else {
            // It is there as a whole when it is fastened.
            seen.extend(edges);
        }
        let max = if into_the_open { task.machine.max_create_deg } else { task.machine.max_connect_deg };
        let mut leans: Option<f64> = None;
        let mut hits: Option<(u32, f64)> = None;
        let mut none = axes.is_empty();
        for axis in axes {
            let length = axis.norm();
            if !(length.is_finite() && length > 1e-9) {
                none = true;
                continue;
            }
            let axis = axis / length;
            let deg = if placed { 0.0 } else { axis.angle(&(motion[1] - motion[0])).to_degrees() };
            if deg >= max {
                leans = Some(leans.map_or(deg, |least| least.min(deg)));
                continue;
            }
            match self.hit(&axis, motion, &touched, &seen) {
                None => return,
                Some(hit) => hits = hits.or(Some(hit)),
            }
        }
        if none {
            self.faults.push(Fault::NoDirection { step, vertex });
        }
        if let Some((edge, mm)) = hits {
            self.faults.push(Fault::Hits { step, edge, mm });
        } else if let Some(deg) = leans {
            self.faults.push(Fault::Leans { step, deg });
        }
    }

    /// The first of what stands that the head hits, and how near it comes to it.
    fn hit(
        &self,
        axis: &Vector3<f64>,
        motion: [Point3<f64>; 2],
        touched: &[u32],
        seen: &[u32],
    ) -> Option<(u32, f64)> {
        let task = self.task;
        seen.iter().find_map(|edge| {
            let ends = task.edges[edge];
            let least = if ends.iter().any(|end| touched.contains(end)) {
                -task.machine.touch_mm
            } else {
                task.machine.clearance_mm + task.section.radius_mm
            };
            let strut = ends.map(|end| task.at(end));
            let mm = nearest(&task.machine.outline, axis, motion, strut, least);
            (mm < least - ROUNDING_MM).then_some((*edge, mm))
        })
    }
}
