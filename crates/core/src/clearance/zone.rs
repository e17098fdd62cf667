//! Which parts of the wire count for a body.

use std::collections::BTreeMap;
use std::ops::Range;

use nalgebra::{Point3, Vector3};
use wirebend_collide::Interval;

use super::stroke::Phase;
use crate::route::Traversal;
use crate::units::Length;
use crate::wireframe::{EdgeId, VertexId, Wireframe};

/// An edge along which the wire runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Passage {
    /// The edge.
    pub edge: EdgeId,
    /// From here.
    pub from: VertexId,
    /// To here.
    pub to: VertexId,
}

/// For each step of a route the edges along which it is fed, with their lengths. `spans`: which traversals each step has.
#[must_use]
pub fn passages(
    wireframe: &Wireframe,
    traversals: &[Traversal],
    spans: &[std::ops::Range<usize>],
) -> Vec<Vec<(Passage, Length)>> {
    let passage = |&Traversal { edge, from, to, .. }: &Traversal| {
        (Passage { edge, from, to }, wireframe.edge_length(edge))
    };
    let of_step = |span: &std::ops::Range<usize>| traversals.get(span.clone()).unwrap_or_default();
    spans.iter().map(|span| of_step(span).iter().map(passage).collect()).collect()
}

/// Where the straight part of a step lies.
#[derive(Debug, Clone, Copy)]
pub(super) struct Laid {
    /// Along the wire, up to the middle of the arcs on both sides.
    pub part: Interval,
    /// How much of that is arc, at its begin and at its end, mm.
    pub arcs: [f64; 2],
    /// Its corners, in the frame of the design.
    pub corners: [Point3<f64>; 2],
}

/// What the wire runs along, and where it lies.
#[derive(Debug, Clone, Copy)]
struct Strut {
    passage: Passage,
    laid: Laid,
}

impl Strut {
    /// At which of its corners a vertex is.
    fn at(&self, vertex: VertexId) -> impl Iterator<Item = usize> + use<> {
        let ends = [self.passage.from, self.passage.to];
        [0, 1].into_iter().filter(move |&end| ends[end] == vertex)
    }

    /// From one of its corners to the other; nothing where it has no length.
    fn leaves(&self, end: usize) -> Vector3<f64> {
        let corners = &self.laid.corners;
        (corners[1 - end] - corners[end]).try_normalize(0.0).unwrap_or_default()
    }
}

/// Where the wire passes vertices and edges.
#[derive(Debug, Clone, Default)]
pub(super) struct Passed {
    /// One for each passage of the route, in its order.
    struts: Vec<Strut>,
    at_vertex: BTreeMap<VertexId, Vec<usize>>,
    on_edge: BTreeMap<EdgeId, Vec<usize>>,
    /// For each step its struts.
    of_step: Vec<Range<usize>>,
}

/// What sums of the same lengths may differ by, mm: no part of the wire is as short.
const ROUNDING: f64 = 1e-6;

/// How the wire may touch what is asked about.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Touch {
    /// A body: the wire that is being bent within so many mm, and other struts within so many mm of their vertex.
    Body { wire: f64, vertex: f64 },
    /// The stock where it lies along an edge, which the struts of its vertices meet there and nowhere else.
    Stock,
    /// The stock while the wire turns to where it lies along the next edge: the struts of a vertex of that edge sweep past it, and touch it
    /// there only as far as they come nearer than so many mm to where it lies before and after.
    StockPassing { near: f64 },
}

impl Passed {
    /// `legs`: for each step its passages and where its straight part lies.
    pub fn new(legs: impl Iterator<Item = (Vec<(Passage, Length)>, Laid)>) -> Self {
        let mut passed = Self::default();
        for (passages, laid) in legs {
            let first = passed.struts.len();
            let whole: f64 = passages.iter().map(|(_, length)| length.mm()).sum();
            let scale = if whole > 0.0 { (laid.part.to - laid.part.from) / whole } else { 0.0 };
            let last = first + passages.len().saturating_sub(1);
            let [begin, end] = laid.corners;
            let (mut from, mut corner, mut fed) = (laid.part.from, begin, 0.0);
            for (passage, length) in passages {
                let index = passed.struts.len();
                let to = from + length.mm() * scale;
                for vertex in [passage.from, passage.to] {
                    passed.at_vertex.entry(vertex).or_default().push(index);
                }
                passed.on_edge.entry(passage.edge).or_default().push(index);
                let arcs = [(first, laid.arcs[0]), (last, laid.arcs[1])]
                    .map(|(has_it, arc)| if index == has_it { arc } else { 0.0 });
                fed += length.mm();
                let next = if whole > 0.0 { begin + (end - begin) * (fed / whole) } else { begin };
                let laid = Laid { part: Interval { from, to }, arcs, corners: [corner, next] };
                passed.struts.push(Strut { passage, laid });
                (from, corner) = (to, next);
            }
            passed.of_step.push(first..passed.struts.len());
        }
        passed
    }

    /// The parts of the wire that count while a step is in a phase. `out`: how long the rigid part of the wire is.
    pub fn counting(&self, step: usize, phase: Phase, touch: Touch, out: f64) -> Vec<Interval> {
        let mut excluded = match touch {
            Touch::Body { wire, .. } if wire <= 0.0 => Vec::new(),
            Touch::Body { wire, vertex } => {
                let mut excluded = self.excluded(step, phase, |_, _, _| vertex);
                excluded.push(Interval { from: out - wire, to: f64::INFINITY });
                excluded
            }
            Touch::Stock => self.excluded(step, phase, |_, _, _| f64::INFINITY),
            Touch::StockPassing { near } => self.excluded(step, phase, |vertex, strut, end| {
                self.beside_stock(step, vertex, (strut, end), near)
            }),
        };
        excluded.sort_by(|one, other| one.from.total_cmp(&other.from));
        let mut counting = Vec::new();
        let mut from = 0.0_f64;
        for part in excluded {
            if part.from > from + ROUNDING {
                counting.push(Interval { from, to: part.from.min(out) });
            }
            from = from.max(part.to);
            if from + ROUNDING >= out {
                return counting;
            }
        }
        counting.push(Interval { from, to: out });
        counting
    }

    /// `zone`: how much of a strut may touch at a vertex, mm, by the strut and the corner at which it has the vertex.
    fn excluded(
        &self,
        step: usize,
        phase: Phase,
        zone: impl Fn(VertexId, &Strut, usize) -> f64,
    ) -> Vec<Interval> {
        let mut excluded = Vec::new();
        let [own, next] = [self.of(step), self.of(step + 1)];
        // The stock lies along the edges that are fed, or along those that are fed next.
        let coming = if matches!(phase, Phase::Feed | Phase::Rotate) { own.clone() } else { next.clone() };
        let ends = self.struts[coming].iter().flat_map(|strut| [strut.passage.from, strut.passage.to]);
        for vertex in ends {
            for &index in self.at_vertex.get(&vertex).into_iter().flatten().filter(|&&index| index < own.end)
            {
                let strut = &self.struts[index];
                let Interval { from, to } = strut.laid.part;
                for end in strut.at(vertex) {
                    let zone = zone(vertex, strut, end);
                    excluded.push(if end == 0 {
                        Interval { from, to: to.min(from + zone) }
                    } else {
                        Interval { from: from.max(to - zone), to }
                    });
                }
            }
        }
        // What is doubled lies beside.
        for index in own.clone().chain(next) {
            for &other in self.on_edge.get(&self.struts[index].passage.edge).into_iter().flatten() {
                if other < own.end {
                    excluded.push(self.struts[other].laid.part);
                }
            }
        }
        excluded
    }

    /// The struts of a step, by their places.
    fn of(&self, step: usize) -> Range<usize> {
        self.of_step.get(step).cloned().unwrap_or_default()
    }

    /// How much of a strut at a vertex, mm, comes nearer than so many mm to where the stock lies when the bend of a step begins and ends.
    /// From the vertex of the bend it goes one way, through all others both ways.
    fn beside_stock(&self, step: usize, vertex: VertexId, (strut, end): (&Strut, usize), near: f64) -> f64 {
        let [own, next] = [self.of(step), self.of(step + 1)].map(|of| &self.struts[of]);
        let Some(first) = next.first() else { return 0.0 };
        let leaves = strut.leaves(end);
        let sine_to = |way: Vector3<f64>| leaves.cross(&way).norm();
        // Of a strut that goes away from the stock nothing is nearer than the vertex.
        let one_way = |way: Vector3<f64>| if leaves.dot(&way) > 0.0 { sine_to(way) } else { 1.0 };
        let sine = if first.passage.from == vertex {
            let before = own.first().map_or(1.0, |own| one_way(own.leaves(0)));
            before.min(one_way(first.leaves(0)))
        } else {
            sine_to(first.leaves(0))
        };
        // A wire that is not made as it is drawn misses the vertex by so much.
        let place = strut.laid.corners[end];
        let places = next.iter().flat_map(|one| one.at(vertex).map(|at| one.laid.corners[at]));
        let off = places.map(|other| (other - place).norm()).fold(f64::INFINITY, f64::min);
        // At s from the vertex they are s sin apart, but for what they miss it by, and once more as far as one of two wires that cross at a
        // vertex lies aside.
        if sine > 0.0 { strut.laid.arcs[end].max((near + off) / sine + near) } else { f64::INFINITY }
    }
}
