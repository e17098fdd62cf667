//! Blossoms: an odd cycle of tight edges becomes one node, and is opened again when its dual is 0.

use super::{Label, Matching, Node, Set};
use crate::graph::{NONE, id};

impl Matching {
    /// Makes a blossom of the cycle that a tight arc between two even nodes of a tree closes.
    pub(super) fn shrink(&mut self, arc: u32) {
        let ends = [self.top(self.from(arc)), self.top(self.to(arc))];
        let base = self.meeting(ends);
        let [down, up] = ends.map(|end| self.path(end, base));
        let mut cycle = Vec::with_capacity(down.len() + up.len() + 1);
        let mut member = base;
        for &(below, to_above) in down.iter().rev() {
            cycle.push((member, to_above ^ 1));
            member = below;
        }
        cycle.push((member, arc));
        cycle.extend(up);
        self.enclose(base, cycle);
    }

    /// Where the ways of two even nodes to the root meet.
    fn meeting(&mut self, ends: [u32; 2]) -> u32 {
        self.round += 1;
        let round = self.round;
        let [mut node, mut other] = ends.map(Some);
        loop {
            if let Some(even) = node {
                if std::mem::replace(&mut self.node_mut(even).mark, round) == round {
                    return even;
                }
                node = self.above(even).map(|(_, _, above)| above);
            }
            std::mem::swap(&mut node, &mut other);
        }
    }

    /// The nodes from an even one up to another, without it, each with the arc to the next.
    fn path(&self, from: u32, to: u32) -> Vec<(u32, u32)> {
        let mut path = Vec::new();
        let mut at = from;
        while at != to
            && let Some((mate, up, above)) = self.above(at)
        {
            path.push((at, mate));
            path.push((self.top(self.to(mate)), up));
            at = above;
        }
        path
    }

    fn enclose(&mut self, base: u32, cycle: Vec<(u32, u32)>) {
        let (mate, tree) = (self.node(base).mate, self.node(base).tree);
        let shrank: Vec<u32> =
            cycle.iter().map(|&(n, _)| n).filter(|&n| self.node(n).label == Label::Odd).collect();
        // Their duals stand still from here on.
        for &(member, _) in &cycle {
            let label = self.node(member).label;
            self.relabel(member, label);
        }
        let sizes = cycle.iter().map(|&(n, _)| self.node(n).size);
        let size = sizes.sum();
        let largest = cycle.iter().map(|&(n, _)| n).max_by_key(|&n| (self.node(n).size, n)).unwrap_or(base);
        let set = self.node(largest).set;
        let offset = self.sets[set as usize].offset;
        let mut inside = Vec::new();
        for &(member, _) in cycle.iter().filter(|&&(member, _)| member != largest) {
            let further = self.sets[self.node(member).set as usize].offset - offset;
            inside.clear();
            self.vertices_of(member, &mut inside);
            for &v in &inside {
                self.radius[v as usize] += further;
                self.set_of[v as usize] = set;
            }
        }
        let blossom = Node {
            parent: NONE,
            label: Label::Even,
            dual: 0,
            set,
            size,
            mate,
            up: NONE,
            tree,
            cycle,
            mark: 0,
        };
        let number = if let Some(number) = self.unused.pop() {
            *self.node_mut(number) = blossom;
            number
        } else {
            self.nodes.push(blossom);
            id(self.nodes.len() - 1)
        };
        for k in 0..self.node(number).cycle.len() {
            let member = self.node(number).cycle[k].0;
            self.node_mut(member).parent = number;
        }
        self.sets[set as usize] = Set { node: number, offset, since: self.now, speed: 1 };
        self.enter(number, tree);
        for node in shrank {
            self.wake(node);
        }
    }

    /// An odd node is at 0: a blossom is opened, and what a vertex lies between is joined through it.
    pub(super) fn spent(&mut self, node: u32) {
        if node as usize >= self.vertices {
            return self.open_odd(node);
        }
        // The way through the vertex is one between its neighbours, and is tight.
        let (up, mate) = (self.node(node).up, self.node(node).mate);
        let weight = self.weight(up) + self.weight(mate);
        let arc = self.add_edge(self.to(up), self.to(mate), weight);
        self.shrink(arc);
    }

    /// Makes the members of a blossom outermost, matched among each other but for the one with the vertex `out`, which has the
    /// mate of the blossom. Gives the cycle and where in it that one is.
    fn release(&mut self, blossom: u32, out: u32) -> (Vec<(u32, u32)>, usize) {
        let base = self.member_with(blossom, out);
        self.relabel(blossom, Label::Free);
        let pairs: Vec<_> = self.pairs(blossom, base).collect();
        let at = self.node_mut(blossom);
        let (cycle, set, mate) = (std::mem::take(&mut at.cycle), at.set, at.mate);
        let offset = self.sets[set as usize].offset;
        let mut inside = Vec::new();
        for &(member, _) in &cycle {
            let own = self.node(member).set;
            if own != set {
                inside.clear();
                self.vertices_of(member, &mut inside);
                for &v in &inside {
                    self.set_of[v as usize] = own;
                }
            }
            self.sets[own as usize] = Set { node: member, offset, since: self.now, speed: 0 };
            let at = self.node_mut(member);
            (at.parent, at.label, at.tree) = (NONE, Label::Free, NONE);
        }
        for (a, arc, b) in pairs {
            self.node_mut(a).mate = arc;
            self.node_mut(b).mate = arc ^ 1;
        }
        self.node_mut(cycle[base].0).mate = mate;
        self.unused.push(blossom);
        (cycle, base)
    }

    /// Opens an odd blossom within its tree: an even number of its members stay in it, the others are free.
    fn open_odd(&mut self, blossom: u32) {
        let (mate, up, tree) = {
            let at = self.node(blossom);
            (at.mate, at.up, at.tree)
        };
        let entry = self.member_with(blossom, self.from(up));
        let (cycle, base) = self.release(blossom, self.from(mate));
        let count = cycle.len();
        // The way from the entry to the base on which a matched edge comes first.
        let behind = (entry + count - base) % count;
        let forward = behind % 2 == 1;
        let (mut at, mut above) = (entry, up);
        let mut stays = vec![false; count];
        let next = |at: usize| if forward { (at + 1) % count } else { (at + count - 1) % count };
        // The arc of a member to the one that comes before it on the way.
        let back = |to: usize| if forward { cycle[(to + count - 1) % count].1 ^ 1 } else { cycle[to].1 };
        loop {
            let odd = cycle[at].0;
            stays[at] = true;
            self.relabel(odd, Label::Odd);
            self.enter(odd, tree);
            self.node_mut(odd).up = above;
            self.schedule_end(odd);
            if at == base {
                break;
            }
            at = next(at);
            stays[at] = true;
            self.relabel(cycle[at].0, Label::Even);
            self.enter(cycle[at].0, tree);
            at = next(at);
            above = back(at);
        }
        for (k, &(member, _)) in cycle.iter().enumerate() {
            if !stays[k] {
                let mut inside = Vec::new();
                self.vertices_of(member, &mut inside);
                for v in inside {
                    self.tell_neighbours(v);
                }
            } else if self.node(member).label == Label::Even {
                self.wake(member);
            }
        }
    }
}
