//! What is walked: the edges of a component as often as they are to be passed, and how many wires what is left of them needs.

use std::collections::BTreeMap;

use nalgebra::Point3;
use petgraph::unionfind::UnionFind;

use crate::wireframe::{Component, EdgeId, VertexId, Wireframe};

/// An edge that is to be passed once; a doubled one has several.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pass {
    pub edge: EdgeId,
    /// Its vertices, by their places in the list.
    pub ends: [usize; 2],
}

impl Pass {
    pub const fn other(&self, end: usize) -> usize {
        if self.ends[0] == end { self.ends[1] } else { self.ends[0] }
    }
}

/// The passes of a component.
#[derive(Debug, Clone)]
pub(super) struct Passes {
    pub all: Vec<Pass>,
    /// For each vertex the passes that end there.
    pub at: Vec<Vec<usize>>,
    pub vertices: Vec<VertexId>,
    pub positions: Vec<Point3<f64>>,
}

impl Passes {
    pub fn new(wireframe: &Wireframe, component: &Component, doubled: &[EdgeId]) -> Self {
        let position = |id: &VertexId| wireframe.vertex(*id).map(|vertex| (*id, vertex.position));
        let (vertices, positions): (Vec<_>, Vec<_>) = component.vertices.iter().filter_map(position).unzip();
        let mut passes = Self { all: Vec::new(), at: vec![Vec::new(); vertices.len()], vertices, positions };
        for &id in component.edges.iter().chain(doubled) {
            let Some(edge) = wireframe.edge(id) else { continue };
            let place = |vertex| passes.vertices.binary_search(&vertex);
            let (Ok(a), Ok(b)) = (place(edge.a), place(edge.b)) else { continue };
            let index = passes.all.len();
            passes.at[a].push(index);
            passes.at[b].push(index);
            passes.all.push(Pass { edge: id, ends: [a, b] });
        }
        passes
    }

    /// How many wires are needed for what is not used, of which one continues at `here`, where it has something left to run
    /// along: that wire counts, too.
    pub fn wires_needed(&self, used: &[bool], here: Option<usize>) -> usize {
        let Left { mut parts, odd, odd_in } = self.left(used);
        let begins = here.map(|here| (parts.find_mut(here), odd[here]));
        let of_part = |(part, odd): (usize, usize)| match begins {
            // A wire that begins at an even vertex of a part that has odd ones ends at an odd one, and there is one more.
            Some((begins_in, false)) if begins_in == part && odd > 0 => odd / 2 + 1,
            _ => (odd / 2).max(1),
        };
        let needed = odd_in.iter().map(|(&part, &odd)| of_part((part, odd))).sum();
        let stuck = begins.is_some_and(|(part, _)| !odd_in.contains_key(&part));
        if stuck { needed + 1 } else { needed }
    }

    /// The vertices where a further wire can begin without one more being needed: the odd ones, and where a part has none, all.
    pub fn starts(&self, used: &[bool]) -> Vec<usize> {
        let Left { mut parts, odd, odd_in } = self.left(used);
        let mut may_begin = |&vertex: &usize| match odd_in.get(&parts.find_mut(vertex)) {
            Some(0) => true,
            Some(_) => odd[vertex],
            None => false,
        };
        (0..self.positions.len()).filter(|vertex| may_begin(vertex)).collect()
    }

    fn left(&self, used: &[bool]) -> Left {
        let mut parts = UnionFind::<usize>::new(self.positions.len());
        let mut odd = vec![false; self.positions.len()];
        let left = || self.all.iter().zip(used).filter(|(_, used)| !**used).map(|(pass, _)| pass);
        for pass in left() {
            parts.union(pass.ends[0], pass.ends[1]);
            for end in pass.ends {
                odd[end] ^= true;
            }
        }
        let mut odd_in: BTreeMap<usize, usize> = BTreeMap::new();
        for pass in left() {
            odd_in.entry(parts.find_mut(pass.ends[0])).or_default();
        }
        for vertex in (0..odd.len()).filter(|&vertex| odd[vertex]) {
            *odd_in.entry(parts.find_mut(vertex)).or_default() += 1;
        }
        Left { parts, odd, odd_in }
    }
}

/// What is not used.
struct Left {
    /// Vertices that are joined by it.
    parts: UnionFind<usize>,
    /// Whether a vertex has an odd number of its ends.
    odd: Vec<bool>,
    /// For each part with edges, by a vertex of it, how many odd vertices it has.
    odd_in: BTreeMap<usize, usize>,
}

#[cfg(test)]
mod tests;
