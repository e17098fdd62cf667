//! The blossoms as they are nested, and how an edge that was missed is taken in.

use super::Matching;
use crate::graph::{NONE, id};

/// The duals of the vertices and blossoms: a parent comes after its members.
pub(crate) struct Laminar {
    pub parents: Vec<u32>,
    pub duals: Vec<i64>,
}

impl Matching {
    /// The first `vertices`, which are all that take part, then the blossoms.
    pub fn laminar(&self, vertices: usize) -> Laminar {
        let mut order: Vec<u32> = (id(self.vertices)..id(self.nodes.len()))
            .filter(|&n| self.is_used(n) && self.node(n).parent == NONE)
            .collect();
        // From the outermost inwards, and then turned round.
        let mut k = 0;
        while k < order.len() {
            let members = self.node(order[k]).cycle.iter().map(|&(member, _)| member);
            order.extend(members.filter(|&member| member as usize >= self.vertices));
            k += 1;
        }
        order.extend((0..id(vertices)).rev());
        order.reverse();
        let mut place = vec![NONE; self.nodes.len()];
        for (k, &node) in order.iter().enumerate() {
            place[node as usize] = id(k);
        }
        let parent = |&node: &u32| place.get(self.node(node).parent as usize).copied().unwrap_or(NONE);
        let dual =
            |&node: &u32| if self.node(node).parent == NONE { self.dual(node) } else { self.node(node).dual };
        Laminar { parents: order.iter().map(parent).collect(), duals: order.iter().map(dual).collect() }
    }
}
