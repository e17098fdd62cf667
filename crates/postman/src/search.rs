//! Dijkstra's algorithm from one vertex, as far as it is wanted.

use std::collections::BinaryHeap;

use crate::graph::{Graph, NONE};

/// A vertex in a queue: the nearest is taken first, by its distance alone.
#[derive(Clone, Copy)]
pub(crate) struct Queued {
    pub distance: i64,
    pub vertex: u32,
}

impl Ord for Queued {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        other.distance.cmp(&self.distance)
    }
}

impl PartialOrd for Queued {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Queued {
    fn eq(&self, other: &Self) -> bool {
        self.distance == other.distance
    }
}

impl Eq for Queued {}

/// Distances from a vertex; its memory is used again by the next search.
pub(crate) struct Search {
    reached: Vec<Reached>,
    round: u32,
    queue: BinaryHeap<Queued>,
    ends: Vec<u32>,
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
        Self { reached, round: 0, queue: BinaryHeap::new(), ends: Vec::new() }
    }

    /// Finds vertices that are ends, no further than `longest` on paths through no other one, until there are so many. Gives the
    /// distance within which all are found. The lightest edges of each vertex come first.
    pub fn ends(
        &mut self,
        graph: &Graph,
        root: u32,
        longest: i64,
        count: usize,
        is_end: impl Fn(u32) -> bool,
    ) -> i64 {
        let mut is_cut = false;
        self.begin(root);
        while let Some(Queued { distance, vertex }) = self.queue.pop() {
            if distance > self.reached[vertex as usize].distance {
                continue;
            }
            if self.ends.len() >= count {
                return distance;
            }
            for arc in graph.at(vertex) {
                let further = distance + arc.weight;
                if further > longest {
                    is_cut = true;
                    break;
                }
                let known = self.reached[arc.to as usize].round == self.round;
                if known && further >= self.reached[arc.to as usize].distance {
                    continue;
                }
                self.reached[arc.to as usize] =
                    Reached { distance: further, round: self.round, via: arc.edge };
                if !is_end(arc.to) {
                    self.queue.push(Queued { distance: further, vertex: arc.to });
                } else if !known {
                    self.ends.push(arc.to);
                }
            }
        }
        if is_cut { longest } else { i64::MAX }
    }

    /// What the last search has found as ends, and how far they are: the shortest way, where all are found.
    pub fn found(&self) -> impl Iterator<Item = (u32, i64)> {
        self.ends.iter().map(|&end| (end, self.reached[end as usize].distance))
    }

    /// Goes the shortest way to a vertex that is no further than `longest`.
    pub fn go(&mut self, graph: &Graph, root: u32, goal: u32, longest: i64) {
        self.begin(root);
        while let Some(Queued { distance, vertex }) = self.queue.pop() {
            if vertex == goal {
                return;
            }
            if distance > self.reached[vertex as usize].distance {
                continue;
            }
            for arc in graph.at(vertex) {
                let further = distance + arc.weight;
                if further <= longest {
                    self.reach(arc.to, further, arc.edge);
                }
            }
        }
    }

    fn begin(&mut self, root: u32) {
        self.round += 1;
        self.queue.clear();
        self.ends.clear();
        self.reach(root, 0, NONE);
    }

    fn reach(&mut self, vertex: u32, distance: i64, via: u32) {
        let reached = &mut self.reached[vertex as usize];
        if reached.round != self.round || distance < reached.distance {
            *reached = Reached { distance, round: self.round, via };
            self.queue.push(Queued { distance, vertex });
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
