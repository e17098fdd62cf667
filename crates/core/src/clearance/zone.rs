//! Which parts of the wire count for a body.

use std::collections::BTreeMap;

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

/// Where the wire passes vertices and edges.
#[derive(Debug, Clone, Default)]
pub(super) struct Passed {
    /// For each passage of the route, in its order: what it runs along, and how long the wire is at its ends.
    passages: Vec<(Passage, Interval)>,
    at_vertex: BTreeMap<VertexId, Vec<usize>>,
    on_edge: BTreeMap<EdgeId, Vec<usize>>,
    /// For each step its passages.
    of_step: Vec<std::ops::Range<usize>>,
}

/// What sums of the same lengths may differ by, mm: no part of the wire is as short.
const ROUNDING: f64 = 1e-6;

/// How the wire may touch what is asked about.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Touch {
    /// The stock, which the struts of a vertex meet there and nowhere else.
    Stock,
    /// A body: the wire that is being bent within so many mm, and other struts within so many mm of their vertex.
    Body { wire: f64, vertex: f64 },
}

impl Passed {
    /// `legs`: for each step its passages and where its straight part lies along the wire, with the arcs on both sides.
    pub fn new(legs: impl Iterator<Item = (Vec<(Passage, Length)>, Interval)>) -> Self {
        let mut passed = Self::default();
        for (passages, leg) in legs {
            let first = passed.passages.len();
            let whole: f64 = passages.iter().map(|(_, length)| length.mm()).sum();
            let scale = if whole > 0.0 { (leg.to - leg.from) / whole } else { 0.0 };
            let mut from = leg.from;
            for (passage, length) in passages {
                let index = passed.passages.len();
                let to = from + length.mm() * scale;
                for vertex in [passage.from, passage.to] {
                    passed.at_vertex.entry(vertex).or_default().push(index);
                }
                passed.on_edge.entry(passage.edge).or_default().push(index);
                passed.passages.push((passage, Interval { from, to }));
                from = to;
            }
            passed.of_step.push(first..passed.passages.len());
        }
        passed
    }

    /// The parts of the wire that count while a step is in a phase. `out`: how long the rigid part of the wire is.
    pub fn counting(&self, step: usize, phase: Phase, touch: Touch, out: f64) -> Vec<Interval> {
        let mut excluded = Vec::new();
        match touch {
            Touch::Body { wire, .. } if wire <= 0.0 => {}
            Touch::Body { wire, vertex } => {
                excluded.push(Interval { from: out - wire, to: f64::INFINITY });
                self.exclude(step, phase, vertex, &mut excluded);
            }
            Touch::Stock => self.exclude(step, phase, f64::INFINITY, &mut excluded),
        }
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

    /// `zone`: how much of the struts at a vertex, mm.
    fn exclude(&self, step: usize, phase: Phase, zone: f64, excluded: &mut Vec<Interval>) {
        let own = self.of_step.get(step).cloned().unwrap_or_default();
        let next = self.of_step.get(step + 1).cloned().unwrap_or_default();
        // The stock lies along the edges that are fed, or along those that are fed next.
        let coming = if matches!(phase, Phase::Feed | Phase::Rotate) { own.clone() } else { next.clone() };
        let ends = self.passages[coming].iter().flat_map(|(passage, _)| [passage.from, passage.to]);
        for vertex in ends {
            for &index in self.at_vertex.get(&vertex).into_iter().flatten().filter(|&&index| index < own.end)
            {
                let (passage, part) = self.passages[index];
                if passage.from == vertex {
                    excluded.push(Interval { from: part.from, to: part.to.min(part.from + zone) });
                }
                if passage.to == vertex {
                    excluded.push(Interval { from: part.from.max(part.to - zone), to: part.to });
                }
            }
        }
        // What is doubled lies beside.
        for index in own.clone().chain(next) {
            for &other in self.on_edge.get(&self.passages[index].0.edge).into_iter().flatten() {
                if other < own.end {
                    excluded.push(self.passages[other].1);
                }
            }
        }
    }
}
