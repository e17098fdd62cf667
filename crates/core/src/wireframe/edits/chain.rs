//! Edges one after the other, in the order in which they hang together.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::Point3;

use super::super::Vertex;
use super::super::delta::Draft;
use super::super::graph::{Edge, EdgeId, VertexId};
use super::{EditError, check_edges};

/// An open chain of two or more edges that comes through no vertex twice. It begins at the end with the lower id.
#[derive(Debug)]
pub(super) struct Chain {
    /// One more than there are edges.
    pub vertices: Vec<VertexId>,
    pub edges: Vec<EdgeId>,
    /// Where the vertices are, mm.
    pub points: Vec<Point3<f64>>,
}

impl Chain {
    /// Puts edges into order.
    pub fn of(draft: &Draft, edges: &[EdgeId]) -> Result<Self, EditError> {
        check_edges(draft, edges)?;
        if edges.len() < 2 {
            return Err(EditError::ChainCount(edges.len()));
        }
        let mut at: BTreeMap<VertexId, Vec<EdgeId>> = BTreeMap::new();
        for &id in edges {
            let edge = draft.edge(id).ok_or(EditError::NoEdge(id))?;
            at.entry(edge.a).or_default().push(id);
            at.entry(edge.b).or_default().push(id);
        }
        if let Some((&vertex, meeting)) = at.iter().find(|(_, meeting)| meeting.len() > 2) {
            return Err(EditError::Branched { vertex, edges: meeting.len() });
        }
        let Some((&first, _)) = at.iter().find(|(_, meeting)| meeting.len() == 1) else {
            return Err(EditError::ClosedChain);
        };
        let (mut vertices, mut ordered) = (vec![first], Vec::with_capacity(edges.len()));
        let (mut last, mut left) = (first, edges.iter().copied().collect::<BTreeSet<_>>());
        while let Some(&next) = at.get(&last).into_iter().flatten().find(|id| left.contains(id)) {
            left.remove(&next);
            last = draft.edge(next).ok_or(EditError::NoEdge(next))?.other(last);
            ordered.push(next);
            vertices.push(last);
        }
        if let Some(&apart) = left.first() {
            return Err(EditError::BrokenChain(apart));
        }
        let points = vertices.iter().map(|&id| draft.position(id)).collect::<Result<_, _>>()?;
        Ok(Self { vertices, edges: ordered, points })
    }

    /// Whether the vertex at a place carries edges that are not of the chain.
    pub fn carries_others(&self, draft: &Draft, place: usize) -> bool {
        let own = [place.checked_sub(1), Some(place)].map(|k| k.and_then(|k| self.edges.get(k)));
        draft.incident(self.vertices[place]).iter().any(|id| !own.contains(&Some(id)))
    }

    /// Whether the design holds the vertex at a place fixed, or a joint sits there.
    pub fn is_held(&self, draft: &Draft, place: usize) -> bool {
        draft.vertex(self.vertices[place]).is_some_and(|vertex| vertex.support || vertex.joint.is_some())
    }

    /// Draws the chain between two of its places anew, through other points. Vertices and edges keep their ids in
    /// order, as far as there are as many; the rest is added or goes. The vertices between the places must be free.
    pub fn redraw(
        &self,
        draft: &mut Draft,
        (from, to): (usize, usize),
        through: &[Point3<f64>],
    ) -> Result<(), EditError> {
        let old = &self.vertices[from + 1..to];
        let mut vertices = vec![self.vertices[from]];
        for (k, &point) in through.iter().enumerate() {
            vertices.push(match old.get(k) {
                Some(&kept) => {
                    draft.move_vertex(kept, point)?;
                    kept
                }
                None => draft.add_vertex(Vertex::at(point))?,
            });
        }
        vertices.push(self.vertices[to]);
        let edges = &self.edges[from..to];
        let ceiling = edges.iter().any(|&id| draft.edge(id).is_some_and(|edge| edge.ceiling));
        for (k, ends) in vertices.windows(2).enumerate() {
            let forward = Edge { a: ends[0], b: ends[1], ceiling };
            let Some(&id) = edges.get(k) else {
                draft.add_edge(forward)?;
                continue;
            };
            if edges.len() > 1 && through.is_empty() && draft.joined(forward, Some(id)) {
                return Err(EditError::Connected(forward.a, forward.b));
            }
            // An edge keeps the direction in which it was drawn.
            let drawn_forward = draft.edge(id).is_none_or(|edge| edge.a == self.vertices[from + k]);
            draft.set_edge(id, if drawn_forward { forward } else { forward.reversed() });
        }
        for &gone in edges.iter().skip(vertices.len() - 1) {
            draft.remove_edge(gone);
        }
        for &gone in old.iter().skip(through.len()) {
            draft.remove_vertex(gone);
        }
        Ok(())
    }
}
