//! An undirected graph with weights, compressed for searches.

/// Weights of all edges together stay below this, so that no sum of a solution overflows.
const MAX_TOTAL: u64 = 1 << 58;

/// No vertex, edge or node.
pub(crate) const NONE: u32 = u32::MAX;

/// The number of something that is known to be less than 2^32.
pub(crate) fn id(position: usize) -> u32 {
    u32::try_from(position).unwrap_or(NONE)
}

/// Vertices `0..vertices`, and edges between two of them, each with a weight. Loops and parallel edges are edges.
#[derive(Debug, Clone)]
pub struct Graph {
    first: Vec<u32>,
    arcs: Vec<Arc>,
    edges: Vec<([u32; 2], i64)>,
}

/// An edge seen from one of its ends.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Arc {
    pub to: u32,
    pub edge: u32,
    pub weight: i64,
}

/// Why edges are no graph.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum GraphError {
    /// An edge ends at a vertex that there is not.
    #[error("edge {edge} ends at vertex {vertex}: there are {vertices} vertices, from 0")]
    NoVertex {
        /// The edge, from 0.
        edge: usize,
        /// Its end.
        vertex: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// The weights add up to more than is computed with.
    #[error("the weights up to edge {edge} add up to 2^58 or more: choose a coarser unit")]
    TooHeavy {
        /// The edge with which they do, from 0.
        edge: usize,
    },
    /// More vertices or edges than are numbered with 32 bits.
    #[error("{0} vertices or edges: up to 2^30 can be numbered")]
    TooMany(usize),
}

impl Graph {
    /// The graph of so many vertices and these edges: two ends and a weight each, numbered in this order.
    ///
    /// # Errors
    /// [`GraphError`] where an end is no vertex, or weights or counts are beyond what is computed with.
    pub fn new(vertices: usize, edges: &[(u32, u32, u64)]) -> Result<Self, GraphError> {
        if let Some(&many) = [vertices, edges.len()].iter().find(|&&count| count >= 1 << 30) {
            return Err(GraphError::TooMany(many));
        }
        let mut first = vec![0_u32; vertices + 2];
        let mut total = 0_u64;
        for (edge, &(a, b, weight)) in edges.iter().enumerate() {
            if let Some(&vertex) = [a, b].iter().find(|&&end| end as usize >= vertices) {
                return Err(GraphError::NoVertex { edge, vertex, vertices });
            }
            total = total.saturating_add(weight);
            if total >= MAX_TOTAL {
                return Err(GraphError::TooHeavy { edge });
            }
            first[a as usize + 2] += 1;
            first[b as usize + 2] += 1;
        }
        for k in 2..first.len() {
            first[k] += first[k - 1];
        }
        // Each row is written from its beginning: `first[v + 1]` moves from there to where it ends.
        let mut arcs = vec![Arc { to: 0, edge: 0, weight: 0 }; 2 * edges.len()];
        for (edge, &(a, b, weight)) in edges.iter().enumerate() {
            for (from, to) in [(a, b), (b, a)] {
                let at = &mut first[from as usize + 1];
                arcs[*at as usize] = Arc { to, edge: id(edge), weight: weight.cast_signed() };
                *at += 1;
            }
        }
        first.pop();
        let edges = edges.iter().map(|&(a, b, weight)| ([a, b], weight.cast_signed())).collect();
        Ok(Self { first, arcs, edges })
    }

    /// The same with its vertices in another order, in which each has a place, and with the lightest edges of each first.
    pub(crate) fn in_order(&self, order: &[u32], place: &[u32]) -> Self {
        let mut first = Vec::with_capacity(self.first.len());
        let mut arcs = Vec::with_capacity(self.arcs.len());
        for &vertex in order {
            first.push(id(arcs.len()));
            let row = arcs.len();
            arcs.extend(self.at(vertex).iter().map(|&arc| Arc { to: place[arc.to as usize], ..arc }));
            arcs[row..].sort_unstable_by_key(|arc| arc.weight);
        }
        first.push(id(arcs.len()));
        let moved = |&(ends, weight): &([u32; 2], i64)| (ends.map(|end| place[end as usize]), weight);
        Self { first, arcs, edges: self.edges.iter().map(moved).collect() }
    }

    /// How many vertices it has.
    #[must_use]
    pub fn vertices(&self) -> usize {
        self.first.len() - 1
    }

    /// How many edges it has.
    #[must_use]
    pub fn edges(&self) -> usize {
        self.edges.len()
    }

    /// The ends of an edge.
    pub(crate) fn ends(&self, edge: u32) -> [u32; 2] {
        self.edges[edge as usize].0
    }

    pub(crate) fn weight(&self, edge: u32) -> i64 {
        self.edges[edge as usize].1
    }

    /// The edges at a vertex, in order; a loop twice.
    pub(crate) fn at(&self, vertex: u32) -> &[Arc] {
        let (from, to) = (self.first[vertex as usize], self.first[vertex as usize + 1]);
        &self.arcs[from as usize..to as usize]
    }

    /// The vertices with an odd number of edge ends, in order.
    #[must_use]
    pub fn odd(&self) -> Vec<u32> {
        let rows = self.first.windows(2).enumerate();
        rows.filter(|(_, row)| (row[1] - row[0]) % 2 == 1).map(|(vertex, _)| id(vertex)).collect()
    }
}
