//! Which edge end is followed by which at every vertex.

use std::collections::BTreeMap;

use nalgebra::Vector3;

use super::matching::least_cost_pairs;
use super::trails::Copy;
use crate::units::Angle;
use crate::wireframe::{EdgeId, VertexId, Wireframe};

/// An end of a copy of an edge: twice the copy's index, plus one at its second vertex. The two
/// highest ones are the ends of the wire itself, where there are any.
pub(super) type End = usize;

/// Cost of a fold back, of a bend beyond the limit, and of a bend per square degree. One fold back
/// weighs more than all bends beyond the limit of a vertex, one of those more than all squares.
const FOLD_BACK: i64 = 1 << 50;
const BEYOND_LIMIT: i64 = 1 << 35;
const PER_SQUARE_DEGREE: f64 = 1000.0;

/// For every vertex a perfect matching of the edge ends that meet there.
pub(super) struct Pairing<'a> {
    copies: &'a [Copy],
    /// Unit vector out of the vertex for every end; none at the ends of the wire.
    directions: Vec<Option<Vector3<f64>>>,
    sharpest: f64,
    /// Who follows whom.
    mate: Vec<End>,
    /// The pairs at each vertex.
    at: BTreeMap<VertexId, Vec<(End, End)>>,
}

impl<'a> Pairing<'a> {
    /// The cheapest pairing at each vertex, on its own. `ends` are the vertices where the wire starts
    /// and ends; without them it is a closed loop.
    pub fn new(
        wireframe: &Wireframe,
        copies: &'a [Copy],
        ends: Option<(VertexId, VertexId)>,
        sharpest: Option<Angle>,
    ) -> Self {
        let mut meeting: BTreeMap<VertexId, Vec<End>> = BTreeMap::new();
        let mut directions = Vec::with_capacity(2 * copies.len() + 2);
        for (k, copy) in copies.iter().enumerate() {
            meeting.entry(copy.a).or_default().push(2 * k);
            meeting.entry(copy.b).or_default().push(2 * k + 1);
            for from in [copy.a, copy.b] {
                let out = wireframe
                    .direction(copy.edge, from)
                    .and_then(|v| v.try_normalize(0.0));
                directions.push(Some(out.unwrap_or_default()));
            }
        }
        if let Some((start, end)) = ends {
            for vertex in [start, end] {
                meeting.entry(vertex).or_default().push(directions.len());
                directions.push(None);
            }
        }
        let sharpest = sharpest.map_or(180.0, Angle::deg);
        let mate = vec![usize::MAX; directions.len()];
        let mut pairing = Self {
            copies,
            directions,
            sharpest,
            mate,
            at: BTreeMap::new(),
        };
        for (vertex, ends) in meeting {
            let mut pairs = Vec::new();
            for (k, &p) in ends.iter().enumerate() {
                for (j, &q) in ends.iter().enumerate().skip(k + 1) {
                    // The two ends of the wire follow nothing, least of all each other.
                    if pairing.directions[p].is_some() || pairing.directions[q].is_some() {
                        pairs.push((k, j, pairing.cost(p, q)));
                    }
                }
            }
            let matched = least_cost_pairs(ends.len(), &pairs);
            let matched: Vec<(End, End)> = matched.into_iter().map(|(k, j)| (ends[k], ends[j])).collect();
            for &(p, q) in &matched {
                pairing.set(p, q);
            }
            pairing.at.insert(vertex, matched);
        }
        pairing
    }

    /// What it costs that one end follows the other.
    pub fn cost(&self, p: End, q: End) -> i64 {
        let (Some(out), Some(on)) = (self.directions[p], self.directions[q]) else {
            return 0;
        };
        let bend = (-out).angle(&on).to_degrees();
        #[allow(clippy::cast_possible_truncation)] // at most 180² · 1000
        let sharpness = (bend * bend * PER_SQUARE_DEGREE).round() as i64;
        let beyond = if bend > self.sharpest { BEYOND_LIMIT } else { 0 };
        let fold = if self.edge(p) == self.edge(q) {
            FOLD_BACK
        } else {
            0
        };
        fold + beyond + sharpness
    }

    fn edge(&self, end: End) -> Option<EdgeId> {
        self.copies.get(end / 2).map(|copy| copy.edge)
    }

    fn set(&mut self, p: End, q: End) {
        self.mate[p] = q;
        self.mate[q] = p;
    }

    /// Who follows an end.
    pub fn mate(&self, end: End) -> End {
        self.mate[end]
    }

    /// How many copies of edges there are.
    pub fn copy_count(&self) -> usize {
        self.copies.len()
    }

    /// Every vertex with the pairs there.
    pub fn vertices(&self) -> impl Iterator<Item = (VertexId, &[(End, End)])> {
        self.at.iter().map(|(&vertex, pairs)| (vertex, pairs.as_slice()))
    }

    /// The pairs at a vertex.
    pub fn pairs(&self, vertex: VertexId) -> &[(End, End)] {
        self.at.get(&vertex).map_or(&[], Vec::as_slice)
    }

    /// Replaces two pairs of a vertex by two others of the same four ends.
    pub fn replace(&mut self, vertex: VertexId, old: [(End, End); 2], new: [(End, End); 2]) {
        for (p, q) in new {
            self.set(p, q);
        }
        if let Some(pairs) = self.at.get_mut(&vertex) {
            pairs.retain(|pair| !old.contains(pair));
            pairs.extend(new);
            pairs.sort_unstable();
        }
    }

    /// Whether an end is one where the wire starts or ends.
    pub fn is_wire_end(&self, end: End) -> bool {
        end >= 2 * self.copies.len()
    }

    /// Whether the wire has ends at all.
    pub fn has_wire_ends(&self) -> bool {
        self.directions.len() > 2 * self.copies.len()
    }
}
