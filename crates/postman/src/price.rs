//! Pairs that were no candidates: which of them the duals are too large for.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

use crate::graph::{Graph, NONE, id};
use crate::matching::{Laminar, Matching};
use crate::nested::{around, common};

/// Looks at the graph with the duals of a matching in mind.
pub(crate) struct Pricer<'a> {
    graph: &'a Graph,
    odd: &'a [u32],
    /// Which odd vertex a vertex is.
    number: Vec<u32>,
    /// All others at less than this, times four, were candidates.
    reach: Vec<i64>,
}

/// Which odd vertex a vertex lies nearest to, when from the distance the radius is taken.
#[derive(Clone, Copy)]
pub(crate) struct Nearest {
    pub odd: u32,
    /// Four times the distance, less the radius.
    pub beyond: i64,
}

/// From odd vertices on, each with its radius, as far as they reach. An odd vertex that is listed is its own at a tie.
pub(crate) fn flood(graph: &Graph, starts: &[(u32, u32, i64)], limit: i64) -> Vec<Nearest> {
    let mut nearest = vec![Nearest { odd: NONE, beyond: i64::MAX }; graph.vertices()];
    let mut queue = BinaryHeap::with_capacity(starts.len());
    for &(odd, vertex, radius) in starts {
        nearest[vertex as usize] = Nearest { odd, beyond: -radius };
        queue.push(Reverse((-radius, vertex)));
    }
    while let Some(Reverse((beyond, vertex))) = queue.pop() {
        let at = nearest[vertex as usize];
        if beyond > at.beyond {
            continue;
        }
        for arc in graph.at(vertex) {
            let further = beyond + 4 * arc.weight;
            let other = &mut nearest[arc.to as usize];
            if further < limit && further < other.beyond {
                *other = Nearest { odd: at.odd, beyond: further };
                queue.push(Reverse((further, arc.to)));
            }
        }
    }
    nearest
}

impl<'a> Pricer<'a> {
    pub fn new(graph: &'a Graph, odd: &'a [u32], number: Vec<u32>, reach: Vec<i64>) -> Self {
        Self { graph, odd, number, reach }
    }

    /// Whether each part of the graph has an even number of the vertices.
    pub fn is_even_everywhere(&self) -> bool {
        let mut seen = vec![false; self.graph.vertices()];
        let mut inside = Vec::new();
        for &root in self.odd {
            if std::mem::replace(&mut seen[root as usize], true) {
                continue;
            }
            let mut even = true;
            inside.push(root);
            while let Some(vertex) = inside.pop() {
                even ^= self.number[vertex as usize] != NONE;
                for arc in self.graph.at(vertex) {
                    if !std::mem::replace(&mut seen[arc.to as usize], true) {
                        inside.push(arc.to);
                    }
                }
            }
            if !even {
                return false;
            }
        }
        true
    }

    /// Pairs of vertices in different even nodes that lie beside each other: where no candidate is left, one of these is the
    /// next.
    pub fn between_trees(&self, matching: &Matching) -> Vec<(u32, u32, i64)> {
        let even = self.numbered().filter(|&(k, _)| matching.is_even(k));
        let starts: Vec<_> = even.map(|(k, vertex)| (k, vertex, matching.radius(k))).collect();
        let nearest = flood(self.graph, &starts, i64::MAX);
        let mut found = BTreeMap::new();
        for edge in 0..id(self.graph.edges()) {
            let [a, b] = self.graph.ends(edge).map(|end| nearest[end as usize]);
            if a.odd == NONE || b.odd == NONE || matching.is_together(a.odd, b.odd) {
                continue;
            }
            let radii = matching.radius(a.odd) + matching.radius(b.odd);
            let weight = a.beyond + b.beyond + radii + 4 * self.graph.weight(edge);
            let least = found.entry((a.odd.min(b.odd), a.odd.max(b.odd))).or_insert(weight);
            *least = weight.min(*least);
        }
        found.into_iter().map(|((a, b), weight)| (a, b, weight)).collect()
    }

    /// An odd vertex that found no partner.
    pub fn unmatched(&self, matching: &Matching) -> u32 {
        self.numbered().find(|&(k, _)| matching.is_even(k)).map_or(NONE, |(_, vertex)| vertex)
    }

    fn numbered(&self) -> impl Iterator<Item = (u32, u32)> {
        self.odd.iter().enumerate().map(|(k, &vertex)| (id(k), vertex))
    }

    /// Pairs that lie on a path shorter than the duals between them allow, with four times its length; none when no pair is.
    ///
    /// Of two vertices that were no candidates each has others nearer to it, so that one of them has a radius of more than half
    /// its reach. Where there is such a one, each vertex of the graph goes to the odd vertex that it lies deepest in. On the path
    /// of a pair that is too near, of those within the largest blossom, all belong to that blossom, and somewhere the next
    /// belongs to another of its members: the owners there are too near, too.
    pub fn missed(&self, matching: &Matching, vertices: usize) -> Vec<(u32, u32, i64)> {
        let mut missed = Vec::new();
        if self.numbered().all(|(k, _)| matching.radius(k) <= self.reach[k as usize] / 2) {
            return missed;
        }
        let Laminar { parents, duals } = matching.laminar(vertices);
        let around = around(&parents, &duals);
        let starts: Vec<_> = self.numbered().map(|(k, vertex)| (k, vertex, matching.radius(k))).collect();
        let nearest = flood(self.graph, &starts, 0);
        let mut try_pair = |a: u32, b: u32, beyond: i64| {
            if a != b && beyond < 0 && beyond + 2 * common(&parents, &around, a, b) < 0 {
                missed.push((a.min(b), a.max(b), beyond + matching.radius(a) + matching.radius(b)));
            }
        };
        for edge in 0..id(self.graph.edges()) {
            let [a, b] = self.graph.ends(edge).map(|end| nearest[end as usize]);
            if a.odd != NONE && b.odd != NONE {
                try_pair(a.odd, b.odd, a.beyond + b.beyond + 4 * self.graph.weight(edge));
            }
        }
        for (own, vertex) in self.numbered() {
            let at = nearest[vertex as usize];
            try_pair(own, at.odd, at.beyond - matching.radius(own));
        }
        missed.sort_unstable();
        missed.dedup_by_key(|&mut (a, b, _)| (a, b));
        missed
    }
}
