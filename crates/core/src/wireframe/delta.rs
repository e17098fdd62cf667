//! The exact difference between two states of a wireframe: what undo, redo and a journal keep.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::Point3;

use super::graph::{
    Edge, EdgeId, EdgeMark, NextIds, Vertex, VertexId, Wireframe, WireframeError, check_vertex,
};

/// One thing before and after; `None` where it does not exist.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Change<T> {
    /// As it was.
    pub before: Option<T>,
    /// As it becomes.
    pub after: Option<T>,
}

impl<T: Clone> Change<T> {
    /// The one that leads back.
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self { before: self.after.clone(), after: self.before.clone() }
    }
}

/// A difference: what changes, from what, to what.
#[derive(Debug, Clone, PartialEq)]
pub struct Delta {
    /// Vertices that are added, removed or changed.
    pub vertices: BTreeMap<VertexId, Change<Vertex>>,
    /// Edges that are added, removed or joined to other vertices.
    pub edges: BTreeMap<EdgeId, Change<Edge>>,
    /// The next ids before and after.
    pub next: (NextIds, NextIds),
}

/// A difference was committed to a wireframe that it was not made for.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum StaleDelta {
    /// A vertex is not as the difference found it.
    #[error("vertex {0} is not as this change found it")]
    Vertex(VertexId),
    /// An edge is not as the difference found it, or would end at a vertex that is not there.
    #[error("edge {0} is not as this change found it")]
    Edge(EdgeId),
    /// The ids to come differ.
    #[error("vertices or edges were added since this change was made")]
    Next,
}

impl Delta {
    /// The difference that leads back.
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self {
            vertices: self.vertices.iter().map(|(&id, change)| (id, change.inverse())).collect(),
            edges: self.edges.iter().map(|(&id, change)| (id, change.inverse())).collect(),
            next: (self.next.1, self.next.0),
        }
    }

    /// The difference that changes nothing.
    #[must_use]
    pub const fn none(wireframe: &Wireframe) -> Self {
        let next = wireframe.next_ids();
        Self { vertices: BTreeMap::new(), edges: BTreeMap::new(), next: (next, next) }
    }

    /// This difference and then another as one. The other has to be made for what this one leads to.
    #[must_use]
    pub fn then(mut self, other: &Self) -> Self {
        fn follow<K: Ord + Copy, T: Copy + PartialEq>(
            first: &mut BTreeMap<K, Change<T>>,
            then: &BTreeMap<K, Change<T>>,
        ) {
            for (&id, change) in then {
                first.entry(id).and_modify(|whole| whole.after = change.after).or_insert(*change);
            }
            first.retain(|_, change| change.before != change.after);
        }
        follow(&mut self.vertices, &other.vertices);
        follow(&mut self.edges, &other.edges);
        self.next.1 = other.next.1;
        self
    }

    /// Whether nothing changes.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.vertices.is_empty() && self.edges.is_empty()
    }

    fn check_against(&self, wireframe: &Wireframe) -> Result<(), StaleDelta> {
        if wireframe.next_ids() != self.next.0 {
            return Err(StaleDelta::Next);
        }
        for (&id, change) in &self.vertices {
            if wireframe.vertex(id) != change.before {
                return Err(StaleDelta::Vertex(id));
            }
        }
        for (&id, change) in &self.edges {
            if wireframe.edge(id) != change.before {
                return Err(StaleDelta::Edge(id));
            }
        }
        let draft = Draft { base: wireframe, delta: self.clone(), changed_at: BTreeMap::new() };
        let ends_exist = |edge: Edge| draft.vertex(edge.a).is_some() && draft.vertex(edge.b).is_some();
        for (&id, change) in &self.edges {
            if change.after.is_some_and(|edge| !ends_exist(edge)) {
                return Err(StaleDelta::Edge(id));
            }
        }
        let removed = self.vertices.iter().filter(|(_, change)| change.after.is_none());
        for edge in removed.flat_map(|(&id, _)| wireframe.incident(id)) {
            if draft.edge(edge).is_some_and(|edge| !ends_exist(edge)) {
                return Err(StaleDelta::Edge(edge));
            }
        }
        Ok(())
    }
}

impl Wireframe {
    /// Commits a difference. On success `self` is exactly what the difference says; on failure it is
    /// untouched.
    ///
    /// # Errors
    /// [`StaleDelta`] when the wireframe is not the one that the difference was made for.
    pub fn commit(&mut self, delta: &Delta) -> Result<(), StaleDelta> {
        delta.check_against(self)?;
        for (&id, change) in &delta.edges {
            if change.before.is_some()
                && let Some(index) = self.edges.remove(&id)
            {
                self.graph.remove_edge(index);
            }
        }
        for (&id, change) in &delta.vertices {
            match (self.vertices.get(&id).copied(), change.after) {
                (Some(index), Some(vertex)) => {
                    if let Some(weight) = self.graph.node_weight_mut(index) {
                        weight.1 = vertex;
                    }
                }
                (Some(index), None) => {
                    self.graph.remove_node(index);
                    self.vertices.remove(&id);
                }
                (None, Some(vertex)) => {
                    self.vertices.insert(id, self.graph.add_node((id, vertex)));
                }
                (None, None) => {}
            }
        }
        for (&id, change) in &delta.edges {
            if let Some(edge) = change.after
                && let (Some(&a), Some(&b)) = (self.vertices.get(&edge.a), self.vertices.get(&edge.b))
            {
                self.edges.insert(id, self.graph.add_edge(a, b, EdgeMark { id, ceiling: edge.ceiling }));
            }
        }
        self.next = delta.next.1;
        Ok(())
    }
}

/// A wireframe with a difference laid over it: what an edit reads and writes while it is resolved.
pub(super) struct Draft<'a> {
    base: &'a Wireframe,
    delta: Delta,
    /// Edges that were changed, by the vertices that they were made to end at.
    changed_at: BTreeMap<VertexId, BTreeSet<EdgeId>>,
}

impl<'a> Draft<'a> {
    pub fn new(base: &'a Wireframe) -> Self {
        let next = base.next_ids();
        Self {
            base,
            delta: Delta { vertices: BTreeMap::new(), edges: BTreeMap::new(), next: (next, next) },
            changed_at: BTreeMap::new(),
        }
    }

    pub fn vertex(&self, id: VertexId) -> Option<Vertex> {
        self.delta.vertices.get(&id).map_or_else(|| self.base.vertex(id), |change| change.after)
    }

    pub fn position(&self, id: VertexId) -> Result<Point3<f64>, WireframeError> {
        self.vertex(id).map(|vertex| vertex.position).ok_or(WireframeError::NoVertex(id))
    }

    pub fn edge(&self, id: EdgeId) -> Option<Edge> {
        self.delta.edges.get(&id).map_or_else(|| self.base.edge(id), |change| change.after)
    }

    /// All edges as they stand now, in order of id.
    pub fn edges(&self) -> BTreeMap<EdgeId, Edge> {
        let mut edges: BTreeMap<EdgeId, Edge> = self.base.edges().collect();
        for (&id, change) in &self.delta.edges {
            match change.after {
                Some(edge) => edges.insert(id, edge),
                None => edges.remove(&id),
            };
        }
        edges
    }

    /// The edges at a vertex as they stand now, in order of id.
    pub fn incident(&self, vertex: VertexId) -> BTreeSet<EdgeId> {
        let touches = |edge: Edge| edge.a == vertex || edge.b == vertex;
        let kept = self.base.incident(vertex).into_iter();
        let changed = self.changed_at.get(&vertex).into_iter().flatten().copied();
        kept.chain(changed).filter(|&id| self.edge(id).is_some_and(touches)).collect()
    }

    /// Whether some edge other than `except` joins the same two vertices.
    pub fn joined(&self, edge: Edge, except: Option<EdgeId>) -> bool {
        self.joining(edge, except).is_some()
    }

    /// The first edge other than `except` that joins the same two vertices.
    pub fn joining(&self, edge: Edge, except: Option<EdgeId>) -> Option<(EdgeId, Edge)> {
        let around = self.incident(edge.a).into_iter().filter(|id| Some(*id) != except);
        around.filter_map(|id| Some((id, self.edge(id)?))).find(|(_, other)| other.ends() == edge.ends())
    }

    pub fn set_vertex(&mut self, id: VertexId, vertex: Vertex) -> Result<(), WireframeError> {
        check_vertex(vertex)?;
        self.write_vertex(id, Some(vertex));
        Ok(())
    }

    pub fn move_vertex(&mut self, id: VertexId, to: Point3<f64>) -> Result<(), WireframeError> {
        let vertex = self.vertex(id).ok_or(WireframeError::NoVertex(id))?;
        self.set_vertex(id, Vertex { position: to, ..vertex })
    }

    pub fn add_vertex(&mut self, vertex: Vertex) -> Result<VertexId, WireframeError> {
        let id = VertexId(self.delta.next.1.vertex);
        self.delta.next.1.vertex = id.0.checked_add(1).ok_or(WireframeError::Full)?;
        self.set_vertex(id, vertex)?;
        Ok(id)
    }

    pub fn add_edge(&mut self, edge: Edge) -> Result<EdgeId, WireframeError> {
        self.position(edge.a)?;
        self.position(edge.b)?;
        let id = EdgeId(self.delta.next.1.edge);
        self.delta.next.1.edge = id.0.checked_add(1).ok_or(WireframeError::Full)?;
        self.write_edge(id, Some(edge));
        Ok(id)
    }

    pub fn set_edge(&mut self, id: EdgeId, edge: Edge) {
        self.write_edge(id, Some(edge));
    }

    /// An edge that another one is merged into keeps the mark of both.
    pub fn keep_mark(&mut self, id: EdgeId, merged: Edge) {
        if let Some(edge) = self.edge(id).filter(|edge| merged.ceiling && !edge.ceiling) {
            self.write_edge(id, Some(Edge { ceiling: true, ..edge }));
        }
    }

    pub fn remove_edge(&mut self, id: EdgeId) {
        self.write_edge(id, None);
    }

    /// Removes a vertex and the edges at it.
    pub fn remove_vertex(&mut self, id: VertexId) {
        for edge in self.incident(id) {
            self.remove_edge(edge);
        }
        self.write_vertex(id, None);
    }

    fn write_vertex(&mut self, id: VertexId, after: Option<Vertex>) {
        let before = self.base.vertex(id);
        self.delta.vertices.insert(id, Change { before, after });
    }

    fn write_edge(&mut self, id: EdgeId, after: Option<Edge>) {
        for vertex in after.into_iter().flat_map(|edge| [edge.a, edge.b]) {
            self.changed_at.entry(vertex).or_default().insert(id);
        }
        let before = self.base.edge(id);
        self.delta.edges.insert(id, Change { before, after });
    }

    pub fn finish(mut self) -> Delta {
        self.delta.vertices.retain(|_, change| change.before != change.after);
        self.delta.edges.retain(|_, change| change.before != change.after);
        self.delta
    }
}
