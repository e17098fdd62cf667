//! What happens next: a vertex finds a tight edge, or a shrinking node is at 0.

use std::cmp::Reverse;

use super::{Label, Matching, Stop, Tree};
use crate::graph::{NONE, id};

impl Matching {
    /// Matches all that take part, as far as edges are known.
    pub fn run(&mut self) -> Stop {
        while self.growing > 0 {
            let Some(Reverse((time, what))) = self.queue.pop() else { return Stop::Stuck };
            // A vertex looks when it is due; nodes come behind the vertices, so that what joins does so before it opens.
            if (what as usize) < self.vertices {
                if self.due[what as usize] == time {
                    self.due[what as usize] = i64::MAX;
                    self.now = time;
                    if 2 * self.radius(what) >= self.reach[what as usize] && self.is_even(what) {
                        return Stop::AtReach(what);
                    }
                    self.look(what);
                }
            } else {
                self.now = time;
                let node = what - id(self.vertices);
                let is_odd =
                    self.is_used(node) && self.is_outermost(node) && self.node(node).label == Label::Odd;
                if is_odd && self.dual(node) == 0 {
                    self.spent(node);
                }
            }
        }
        Stop::Matched
    }

    /// Makes a root of every free node of the first `vertices`, with nothing else in a tree.
    pub fn plant(&mut self, vertices: usize) {
        self.now = 0;
        self.queue.clear();
        self.due.fill(i64::MAX);
        self.trees.clear();
        for set in &mut self.sets {
            set.since = 0;
        }
        let free: Vec<u32> = (0..id(self.nodes.len()))
            .filter(|&n| self.is_used(n) && (n as usize >= self.vertices || (n as usize) < vertices))
            .filter(|&n| self.is_outermost(n) && self.node(n).mate == NONE)
            .collect();
        self.growing = free.len();
        for (tree, &root) in free.iter().enumerate() {
            self.trees.push(Tree::default());
            self.enter(root, id(tree));
            self.relabel(root, Label::Even);
        }
        for &root in &free {
            self.wake(root);
        }
    }

    /// Lets all vertices of a node that has become even look at their edges.
    pub(super) fn wake(&mut self, node: u32) {
        let mut inside = Vec::new();
        self.vertices_of(node, &mut inside);
        let tree = self.node(node).tree;
        for &v in &inside {
            self.has_looked[v as usize] = false;
            self.schedule(v, self.now);
        }
        self.trees[tree as usize].woken.append(&mut inside);
    }

    pub(super) fn schedule(&mut self, vertex: u32, time: i64) {
        if time < self.due[vertex as usize] {
            self.due[vertex as usize] = time;
            self.queue.push(Reverse((time, vertex)));
        }
    }

    /// When an odd node gets to 0; a vertex that is on no ways goes below.
    pub(super) fn schedule_end(&mut self, node: u32) {
        if (node as usize) < self.on_ways || node as usize >= self.vertices {
            self.queue.push(Reverse((self.now + self.node(node).dual, node + id(self.vertices))));
        }
    }

    /// Does what the tight edges of an even vertex ask for.
    fn look(&mut self, vertex: u32) {
        let (from, to) = (self.first[vertex as usize] as usize, self.first[vertex as usize + 1] as usize);
        let mut wait = i64::MAX;
        for k in from..to {
            if !self.look_along(vertex, self.arcs[k], &mut wait) {
                return;
            }
        }
        let mut arc = self.next_later(vertex, NONE);
        while arc != NONE {
            if !self.look_along(vertex, arc, &mut wait) {
                return;
            }
            arc = self.next_later(vertex, arc);
        }
        self.has_looked[vertex as usize] = true;
        if self.reach[vertex as usize] != i64::MAX {
            wait = wait.min(self.reach[vertex as usize] / 2 - self.radius(vertex));
        }
        if wait != i64::MAX {
            self.schedule(vertex, self.now + wait);
        }
    }

    /// False when the vertex is no longer in an even node.
    fn look_along(&mut self, vertex: u32, arc: u32, wait: &mut i64) -> bool {
        let (own, other) = (self.top(vertex), self.top(self.to(arc)));
        if self.node(own).label != Label::Even {
            return false;
        }
        if own == other {
            return true;
        }
        let slack = self.slack(arc);
        match self.node(other).label {
            Label::Odd => {}
            Label::Free if slack == 0 => self.grow(arc),
            Label::Even if slack == 0 && self.node(own).tree == self.node(other).tree => self.shrink(arc),
            Label::Even if slack == 0 => {
                self.augment(arc);
                return false;
            }
            Label::Free => *wait = (*wait).min(slack),
            // Either may be free again before, the other goes on towards it then.
            Label::Even => {
                *wait = (*wait).min(slack / 2);
                self.schedule(self.to(arc), self.now + slack / 2);
            }
        }
        true
    }

    /// An odd vertex that found no partner.
    pub fn unmatched(&self) -> u32 {
        (0..id(self.real)).find(|&v| self.is_even(v)).unwrap_or(NONE)
    }

    /// Whether a vertex is in an even node.
    fn is_even(&self, vertex: u32) -> bool {
        self.node(self.top(vertex)).label == Label::Even
    }

    /// Even vertices that go towards one that has become free look again when they may meet it.
    pub(super) fn tell_neighbours(&mut self, vertex: u32) {
        let (from, to) = (self.first[vertex as usize] as usize, self.first[vertex as usize + 1] as usize);
        for k in from..to {
            self.tell(self.arcs[k]);
        }
        let mut arc = self.next_later(vertex, NONE);
        while arc != NONE {
            self.tell(arc);
            arc = self.next_later(vertex, arc);
        }
    }

    fn tell(&mut self, arc: u32) {
        let other = self.to(arc);
        if self.node(self.top(other)).label == Label::Even {
            self.schedule(other, self.now + self.slack(arc));
        }
    }
}
