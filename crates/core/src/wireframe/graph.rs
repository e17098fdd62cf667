//! The graph itself: a multigraph with stable ids over petgraph's stable graph.

use std::collections::BTreeMap;
use std::fmt;

use nalgebra::{Point3, Vector3};
use petgraph::stable_graph::{EdgeIndex, NodeIndex, StableUnGraph};

use super::joint::{Joint, MAX_JOINT_G};
use crate::units::Length;

/// Largest coordinate that is accepted, in mm. A kilometre of wire is beyond every bender, and the
/// square of this stays exact enough for every tolerance used here.
const MAX_COORDINATE_MM: f64 = 1.0e6;

/// Names a vertex for as long as its wireframe lives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct VertexId(pub u32);

/// Names an edge for as long as its wireframe lives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct EdgeId(pub u32);

impl fmt::Display for VertexId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl fmt::Display for EdgeId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// The ids that the next vertex and the next edge will get.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct NextIds {
    /// For the next vertex.
    pub vertex: u32,
    /// For the next edge.
    pub edge: u32,
}

/// A point of the wireframe where struts meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vertex {
    /// Position in mm.
    pub position: Point3<f64>,
    /// Whether the design holds this point fixed (a support of the structure).
    pub support: bool,
    /// The motions that a support leaves free: along x, y and z, then about them. It counts for supports alone.
    pub free: [bool; 6],
    /// What holds the struts together here; none where the wire itself runs through, or nothing does.
    pub joint: Option<Joint>,
}

impl Vertex {
    /// A free vertex at a position in mm.
    #[must_use]
    pub const fn at(position: Point3<f64>) -> Self {
        Self { position, support: false, free: [false; 6], joint: None }
    }

    /// Which motions are held: along x, y and z, then about them. None of a vertex that is no support.
    #[must_use]
    pub fn fixed(&self) -> [bool; 6] {
        self.free.map(|free| self.support && !free)
    }

    /// This vertex with what another one has that is merged into it: what either held is held, and its own joint goes first.
    pub(super) fn with_marks_of(self, merged: Self) -> Self {
        let (one, other) = (self.fixed(), merged.fixed());
        let support = self.support || merged.support;
        let free = std::array::from_fn(|k| support && !(one[k] || other[k]));
        Self { support, free, joint: self.joint.or(merged.joint), ..self }
    }
}

/// A strut: two vertices, in the order in which it was drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Edge {
    /// Where it starts.
    pub a: VertexId,
    /// Where it ends.
    pub b: VertexId,
    /// Whether the design marks it as part of its ceiling: the last layer that is built.
    pub ceiling: bool,
}

impl Edge {
    /// A strut without a mark.
    #[must_use]
    pub const fn between(a: VertexId, b: VertexId) -> Self {
        Self { a, b, ceiling: false }
    }

    /// The end that is not `vertex`; for a loop, or a vertex that it does not touch, its `a`.
    #[must_use]
    pub fn other(self, vertex: VertexId) -> VertexId {
        if self.a == vertex { self.b } else { self.a }
    }

    /// The same strut, drawn the other way.
    #[must_use]
    pub const fn reversed(self) -> Self {
        Self { a: self.b, b: self.a, ceiling: self.ceiling }
    }

    /// The ends, lower id first: equal for edges that join the same two vertices.
    #[must_use]
    pub fn ends(self) -> (VertexId, VertexId) {
        (self.a.min(self.b), self.a.max(self.b))
    }
}

/// Coordinates as "(x, y, z)", in powers of ten where they are long.
struct Coordinates<'a>(&'a Point3<f64>);

impl fmt::Display for Coordinates<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (c, before) in self.0.iter().zip(["(", ", ", ", "]) {
            if c.abs() < 1e12 { write!(f, "{before}{c}")? } else { write!(f, "{before}{c:e}")? }
        }
        f.write_str(")")
    }
}

/// Why a vertex or an edge cannot be added.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum WireframeError {
    /// A coordinate is NaN, infinite or beyond a kilometre.
    #[error("{} is not a position: each coordinate must be a number within ±1 000 000 mm", Coordinates(.0))]
    Position(Point3<f64>),
    /// The mass of a joint is NaN, infinite, negative or beyond a tonne.
    #[error("{0} g is no mass of a joint: it must be a number from 0 to 1 000 000 g")]
    JointMass(f64),
    /// An edge names a vertex that is not there.
    #[error("there is no vertex {0}")]
    NoVertex(VertexId),
    /// An id is already taken.
    #[error("vertex {0} exists already")]
    VertexExists(VertexId),
    /// An id is already taken.
    #[error("edge {0} exists already")]
    EdgeExists(EdgeId),
    /// All 2^32 ids are used up.
    #[error("there are no ids left for more vertices or edges")]
    Full,
}

/// What the graph keeps of an edge; its ends are petgraph's.
#[derive(Debug, Clone, Copy)]
pub(super) struct EdgeMark {
    pub id: EdgeId,
    pub ceiling: bool,
}

/// A graph of struts with stable ids. Loops and parallel edges can be represented, because files
/// hold them and the checks have to name them.
#[derive(Debug, Clone, Default)]
pub struct Wireframe {
    pub(super) graph: StableUnGraph<(VertexId, Vertex), EdgeMark>,
    pub(super) vertices: BTreeMap<VertexId, NodeIndex>,
    pub(super) edges: BTreeMap<EdgeId, EdgeIndex>,
    pub(super) next: NextIds,
}

impl PartialEq for Wireframe {
    /// Same vertices, same edges, same ids, same ids to come.
    fn eq(&self, other: &Self) -> bool {
        self.next == other.next && self.vertices().eq(other.vertices()) && self.edges().eq(other.edges())
    }
}

impl Wireframe {
    /// An empty wireframe.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a vertex under the next free id.
    ///
    /// # Errors
    /// [`WireframeError::Position`] when a coordinate is not a number within a kilometre.
    pub fn add_vertex(&mut self, vertex: Vertex) -> Result<VertexId, WireframeError> {
        let id = VertexId(self.next.vertex);
        self.insert_vertex(id, vertex)?;
        Ok(id)
    }

    /// Adds an edge under the next free id.
    ///
    /// # Errors
    /// [`WireframeError::NoVertex`] when an end is not there.
    pub fn add_edge(&mut self, a: VertexId, b: VertexId) -> Result<EdgeId, WireframeError> {
        let id = EdgeId(self.next.edge);
        self.insert_edge(id, Edge::between(a, b))?;
        Ok(id)
    }

    /// Adds a vertex under an id of the caller's, as a file that is read back does.
    ///
    /// # Errors
    /// [`WireframeError`] when the position or the mass of its joint is not one or the id is taken.
    pub fn insert_vertex(&mut self, id: VertexId, vertex: Vertex) -> Result<(), WireframeError> {
        check_vertex(vertex)?;
        if self.vertices.contains_key(&id) {
            return Err(WireframeError::VertexExists(id));
        }
        let next = id.0.checked_add(1).ok_or(WireframeError::Full)?;
        self.next.vertex = self.next.vertex.max(next);
        self.vertices.insert(id, self.graph.add_node((id, vertex)));
        Ok(())
    }

    /// Adds an edge under an id of the caller's, as a file that is read back does.
    ///
    /// # Errors
    /// [`WireframeError`] when an end is missing or the id is taken.
    pub fn insert_edge(&mut self, id: EdgeId, edge: Edge) -> Result<(), WireframeError> {
        let a = *self.vertices.get(&edge.a).ok_or(WireframeError::NoVertex(edge.a))?;
        let b = *self.vertices.get(&edge.b).ok_or(WireframeError::NoVertex(edge.b))?;
        if self.edges.contains_key(&id) {
            return Err(WireframeError::EdgeExists(id));
        }
        let next = id.0.checked_add(1).ok_or(WireframeError::Full)?;
        self.next.edge = self.next.edge.max(next);
        self.edges.insert(id, self.graph.add_edge(a, b, EdgeMark { id, ceiling: edge.ceiling }));
        Ok(())
    }

    /// The ids that the next vertex and the next edge will get.
    #[must_use]
    pub const fn next_ids(&self) -> NextIds {
        self.next
    }

    /// Reserves ids: the next ones will be at least these, as a document that was saved says.
    pub fn reserve_ids(&mut self, next: NextIds) {
        self.next.vertex = self.next.vertex.max(next.vertex);
        self.next.edge = self.next.edge.max(next.edge);
    }

    /// How many vertices there are.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.vertices.len()
    }

    /// How many edges there are.
    #[must_use]
    pub fn edge_count(&self) -> usize {
        self.edges.len()
    }

    /// A vertex by its id.
    #[must_use]
    pub fn vertex(&self, id: VertexId) -> Option<Vertex> {
        self.graph.node_weight(*self.vertices.get(&id)?).map(|&(_, vertex)| vertex)
    }

    /// An edge by its id.
    #[must_use]
    pub fn edge(&self, id: EdgeId) -> Option<Edge> {
        self.edge_at(*self.edges.get(&id)?)
    }

    fn edge_at(&self, index: EdgeIndex) -> Option<Edge> {
        let [(a, _), (b, _)] = self.ends(index)?;
        Some(Edge { a, b, ceiling: self.graph.edge_weight(index)?.ceiling })
    }

    fn ends(&self, index: EdgeIndex) -> Option<[(VertexId, Vertex); 2]> {
        let (a, b) = self.graph.edge_endpoints(index)?;
        Some([*self.graph.node_weight(a)?, *self.graph.node_weight(b)?])
    }

    /// All vertices in order of id.
    pub fn vertices(&self) -> impl Iterator<Item = (VertexId, Vertex)> + '_ {
        self.vertices.iter().filter_map(|(&id, &index)| Some((id, self.graph.node_weight(index)?.1)))
    }

    /// All edges in order of id.
    pub fn edges(&self) -> impl Iterator<Item = (EdgeId, Edge)> + '_ {
        self.edges.iter().filter_map(|(&id, &index)| Some((id, self.edge_at(index)?)))
    }

    /// The edges at a vertex in order of id, a loop once; empty for a vertex that is not there.
    #[must_use]
    pub fn incident(&self, id: VertexId) -> Vec<EdgeId> {
        let Some(&index) = self.vertices.get(&id) else {
            return Vec::new();
        };
        let mut edges: Vec<EdgeId> = self.graph.edges(index).map(|edge| edge.weight().id).collect();
        edges.sort_unstable();
        edges.dedup();
        edges
    }

    /// From `from` to the other end of an edge, in mm; `None` when either is not there.
    #[must_use]
    pub fn direction(&self, edge: EdgeId, from: VertexId) -> Option<Vector3<f64>> {
        let [(a, start), (b, end)] = self.ends(*self.edges.get(&edge)?)?;
        if from == a {
            return Some(end.position - start.position);
        }
        let at = if from == b { end } else { self.vertex(from)? };
        Some(start.position - at.position)
    }

    /// The length of an edge; zero for one that is not there.
    #[must_use]
    pub fn edge_length(&self, id: EdgeId) -> Length {
        let ends = self.edges.get(&id).and_then(|&index| self.ends(index));
        Length::computed(ends.map_or(0.0, |[(_, a), (_, b)]| (b.position - a.position).norm()))
    }

    /// The length of all edges together.
    #[must_use]
    pub fn total_length(&self) -> Length {
        self.edges.keys().map(|&id| self.edge_length(id)).sum()
    }
}

/// Refuses a coordinate that is NaN, infinite or beyond a kilometre.
fn check_position(position: Point3<f64>) -> Result<(), WireframeError> {
    if position.coords.iter().all(|c| c.abs() <= MAX_COORDINATE_MM) {
        Ok(())
    } else {
        Err(WireframeError::Position(position))
    }
}

/// Refuses what no vertex can be: its position, and the mass of its joint.
pub(super) fn check_vertex(vertex: Vertex) -> Result<(), WireframeError> {
    check_position(vertex.position)?;
    match vertex.joint {
        Some(Joint { mass_g, .. }) if !(0.0..=MAX_JOINT_G).contains(&mass_g) => {
            Err(WireframeError::JointMass(mass_g))
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x: f64) -> Vertex {
        Vertex::at(Point3::new(x, 0.0, 0.0))
    }

    #[test]
    fn what_cannot_be_a_wireframe_is_refused_by_name() {
        let mut w = Wireframe::new();
        let a = w.add_vertex(at(0.0)).unwrap();
        assert!(matches!(w.add_vertex(at(f64::NAN)), Err(WireframeError::Position(_))));
        assert!(matches!(w.add_vertex(at(1.1e6)), Err(WireframeError::Position(_))));
        assert_eq!(
            w.add_vertex(at(-1e300)).unwrap_err().to_string().split_once(" is").unwrap().0,
            "(-1e300, 0, 0)"
        );
        assert_eq!(w.add_edge(a, VertexId(7)), Err(WireframeError::NoVertex(VertexId(7))));
        assert_eq!(w.insert_vertex(a, at(1.0)), Err(WireframeError::VertexExists(a)));
        assert_eq!(w.insert_vertex(VertexId(u32::MAX), at(1.0)), Err(WireframeError::Full));
        let b = w.add_vertex(at(1.0)).unwrap();
        let e = w.add_edge(a, b).unwrap();
        assert_eq!(w.insert_edge(e, Edge::between(a, b)), Err(WireframeError::EdgeExists(e)));
    }

    #[test]
    fn parallel_edges_and_loops_are_kept_apart() {
        let mut w = Wireframe::new();
        let (a, b) = (w.add_vertex(at(0.0)).unwrap(), w.add_vertex(at(3.0)).unwrap());
        let edges = [w.add_edge(a, b).unwrap(), w.add_edge(b, a).unwrap(), w.add_edge(a, a).unwrap()];
        assert_eq!(w.incident(a), edges);
        assert_eq!(w.incident(b), edges[..2]);
        assert!((w.total_length().mm() - 6.0).abs() < 1e-12);
        assert_eq!(w.edge(edges[1]), Some(Edge::between(b, a)));
    }
}
