//! Trees: they grow by a matched pair, and two of them that meet are matched from root to root and dissolve.

use super::{Label, Matching, Tree};
use crate::graph::NONE;

impl Matching {
    /// Takes the free node at the end of a tight arc into the tree, and its mate.
    pub(super) fn grow(&mut self, arc: u32) {
        let tree = self.node(self.top(self.from(arc))).tree;
        let odd = self.top(self.to(arc));
        let even = self.top(self.to(self.node(odd).mate));
        for (node, label) in [(odd, Label::Odd), (even, Label::Even)] {
            self.relabel(node, label);
            self.enter(node, tree);
        }
        self.node_mut(odd).up = arc ^ 1;
        self.schedule_end(odd);
        self.wake(even);
    }

    pub(super) fn enter(&mut self, node: u32, tree: u32) {
        self.node_mut(node).tree = tree;
        self.trees[tree as usize].nodes.push(node);
    }

    /// Matches the roots of two trees through a tight arc.
    pub(super) fn augment(&mut self, arc: u32) {
        let ends = [self.top(self.from(arc)), self.top(self.to(arc))];
        for (mut node, mut arc) in ends.into_iter().zip([arc, arc ^ 1]) {
            loop {
                let before = std::mem::replace(&mut self.node_mut(node).mate, arc);
                if before == NONE {
                    break;
                }
                let odd = self.top(self.to(before));
                let up = self.node(odd).up;
                self.node_mut(odd).mate = up;
                node = self.top(self.to(up));
                arc = up ^ 1;
            }
        }
        // Who was odd, or even for so short a time that it has not looked yet, is not expected by even ones beside it.
        let mut unexpected = Vec::new();
        for end in ends {
            let tree = self.node(end).tree;
            let Tree { nodes, woken } = std::mem::take(&mut self.trees[tree as usize]);
            unexpected.extend(
                woken.into_iter().filter(|&v| !std::mem::replace(&mut self.has_looked[v as usize], true)),
            );
            for node in nodes {
                // A number may have been given to another blossom meanwhile.
                if self.is_used(node) && self.is_outermost(node) && self.node(node).tree == tree {
                    if self.node(node).label == Label::Odd {
                        self.vertices_of(node, &mut unexpected);
                    }
                    self.leave(node);
                }
            }
        }
        self.growing -= 2;
        for vertex in unexpected {
            self.tell_neighbours(vertex);
        }
    }

    fn leave(&mut self, node: u32) {
        self.relabel(node, Label::Free);
        self.node_mut(node).tree = NONE;
    }

    /// The even node above an even one, and the arcs to it: to the odd one between, and from there.
    pub(super) fn above(&self, even: u32) -> Option<(u32, u32, u32)> {
        let mate = self.node(even).mate;
        (mate != NONE).then(|| {
            let up = self.node(self.top(self.to(mate))).up;
            (mate, up, self.top(self.to(up)))
        })
    }
}
