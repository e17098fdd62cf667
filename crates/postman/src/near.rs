//! Odd vertices near each other, and paths between them.
//!
//! Only pairs with a path that no other odd vertex lies on are looked for. A moat around one end of any path, and not around the
//! other, is crossed between two odd vertices that follow each other on it: where moats do not overlap between those, they do
//! not between the ends. Nor do they between two that are no nearer than the reach of either, while no radius is more than half
//! of that. So nothing is missed.

use crate::graph::{Graph, NONE, id};
use crate::search::Search;

/// Looks around in a graph with some vertices that are odd.
pub(crate) struct Near<'a> {
    graph: &'a Graph,
    odd: &'a [u32],
    /// Which odd vertex a vertex is.
    number: Vec<u32>,
    search: Search,
}

impl<'a> Near<'a> {
    pub fn new(graph: &'a Graph, odd: &'a [u32]) -> Self {
        let mut number = vec![NONE; graph.vertices()];
        for (k, &vertex) in odd.iter().enumerate() {
            number[vertex as usize] = id(k);
        }
        Self { graph, odd, number, search: Search::new(graph) }
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

    /// About so many of the nearest of each, with four times their distance; and the reach of each: four times the distance below
    /// which all are found.
    pub fn nearest(&mut self, count: usize) -> (Vec<([u32; 2], i64)>, Vec<i64>) {
        let mut found = Vec::with_capacity(self.odd.len() * count);
        let mut reach = vec![0; self.odd.len()];
        for own in 0..id(self.odd.len()) {
            let far = self.around(own, i64::MAX, count, &reach, |other, distance| {
                found.push(([own, other], distance));
            });
            reach[own as usize] = far;
        }
        (found, reach)
    }

    /// Those of one up to a distance, but for those in the known reach of either; and how far its reach is then.
    pub fn further(&mut self, own: u32, longest: i64, known: &[i64]) -> (Vec<(u32, i64)>, i64) {
        let mut found = Vec::new();
        let far =
            self.around(own, longest, usize::MAX, known, |other, distance| found.push((other, distance)));
        (found, far)
    }

    /// Calls with others around one and four times their distance, up to `longest` or about so many of them, but for those in the
    /// known reach of either. Gives how far its reach is then.
    fn around(
        &mut self,
        own: u32,
        longest: i64,
        count: usize,
        known: &[i64],
        mut take: impl FnMut(u32, i64),
    ) -> i64 {
        let Self { graph, odd, number, search } = self;
        let root = odd[own as usize];
        let far = search.ends(graph, root, longest, count, |vertex| number[vertex as usize] != NONE);
        for (vertex, distance) in search.found() {
            let other = number[vertex as usize];
            if distance <= far && 4 * distance >= known[own as usize].max(known[other as usize]) {
                take(other, 4 * distance);
            }
        }
        if far == i64::MAX { far } else { 4 * far }
    }

    /// The edges of the shortest path between two, of a known length.
    pub fn path(&mut self, from: u32, to: u32, length: i64) -> impl Iterator<Item = u32> + '_ {
        let [root, goal] = [from, to].map(|k| self.odd[k as usize]);
        self.search.go(self.graph, root, goal, length);
        self.search.path(self.graph, goal)
    }
}
