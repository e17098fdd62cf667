//! What is walked: the edges of a component as often as they are to be passed, and how many wires what is left of them needs.

use nalgebra::Point3;
use petgraph::unionfind::UnionFind;

use crate::route::Traversal;
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
        let mut parts = UnionFind::<usize>::new(self.positions.len());
        let mut odd = vec![false; self.positions.len()];
        for pass in self.left(used) {
            parts.union(pass.ends[0], pass.ends[1]);
            for end in pass.ends {
                odd[end] ^= true;
            }
        }
        // Of each part with edges: how many odd vertices it has.
        let mut odd_in: std::collections::BTreeMap<usize, usize> = std::collections::BTreeMap::new();
        for pass in self.left(used) {
            odd_in.entry(parts.find_mut(pass.ends[0])).or_default();
        }
        for vertex in (0..odd.len()).filter(|&vertex| odd[vertex]) {
            *odd_in.entry(parts.find_mut(vertex)).or_default() += 1;
        }
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

    /// The vertices where a further wire can begin without one more being needed.
    pub fn starts(&self, used: &[bool]) -> Vec<usize> {
        let needed = self.wires_needed(used, None);
        let with_edges =
            (0..self.positions.len()).filter(|&vertex| self.at[vertex].iter().any(|&pass| !used[pass]));
        with_edges.filter(|&vertex| self.wires_needed(used, Some(vertex)) == needed).collect()
    }

    pub fn traversal(&self, pass: usize, from: usize, walked: &[(usize, usize)]) -> Traversal {
        let Pass { edge, .. } = self.all[pass];
        let to = self.all[pass].other(from);
        let again = walked.iter().any(|&(before, _)| self.all[before].edge == edge);
        Traversal { edge, from: self.vertices[from], to: self.vertices[to], again }
    }

    fn left<'a>(&'a self, used: &'a [bool]) -> impl Iterator<Item = &'a Pass> {
        self.all.iter().zip(used).filter(|(_, used)| !**used).map(|(pass, _)| pass)
    }
}
