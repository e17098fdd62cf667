//! Dijkstra's algorithm from one vertex, as far as it is wanted; ties go to the lower index.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::graph::{Graph, NONE};

/// Distances from a vertex; its memory is used again by the next search.
pub(crate) struct Search {
    reached: Vec<Reached>,
    round: u32,
    queue: BinaryHeap<Reverse<(i64, u32)>>,
}

#[derive(Clone, Copy)]
struct Reached {
    distance: i64,
    round: u32,
    /// The edge by which.
    via: u32,
}

impl Search {
    pub fn new(graph: &Graph) -> Self {
        let reached = vec![Reached { distance: 0, round: 0, via: NONE }; graph.vertices()];
        Self { reached, round: 0, queue: BinaryHeap::new() }
    }

    /// Settles vertices in the order of their distance, until one is told to `is_last` for which it is true.
    pub fn run(&mut self, graph: &Graph, root: u32, mut is_last: impl FnMut(u32, i64) -> bool) {
        self.round += 1;
        self.queue.clear();
        self.reach(root, 0, NONE);
        while let Some(Reverse((distance, vertex))) = self.queue.pop() {
            if distance > self.reached[vertex as usize].distance {
                continue;
            }
            if is_last(vertex, distance) {
                return;
            }
            for arc in graph.at(vertex) {
                self.reach(arc.to, distance + arc.weight, arc.edge);
            }
        }
    }

    fn reach(&mut self, vertex: u32, distance: i64, via: u32) {
        let reached = &mut self.reached[vertex as usize];
        if reached.round != self.round || distance < reached.distance {
            *reached = Reached { distance, round: self.round, via };
            self.queue.push(Reverse((distance, vertex)));
        }
    }

    /// The edges from the root of the last search to a vertex that it settled, the last first.
    pub fn path<'a>(&'a self, graph: &'a Graph, to: u32) -> impl Iterator<Item = u32> + 'a {
        let mut at = to;
        std::iter::from_fn(move || {
            let via = self.reached[at as usize].via;
            (via != NONE).then(|| {
                let [a, b] = graph.ends(via);
                at ^= a ^ b;
                via
            })
        })
    }
}
