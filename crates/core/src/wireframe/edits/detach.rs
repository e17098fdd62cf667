//! The edit that takes edges off the others: what was one wire becomes two that touch.

use std::collections::{BTreeMap, BTreeSet};

use super::super::Vertex;
use super::super::delta::Draft;
use super::super::graph::{Edge, EdgeId, VertexId, WireframeError};
use super::{EditError, check_edges};

/// Gives edges vertices of their own wherever others stay: one new vertex for each one that is shared, at the same
/// place and as fixed as that one. A joint stays with what stays.
pub(super) fn detach(draft: &mut Draft, edges: &[EdgeId]) -> Result<(), EditError> {
    check_edges(draft, edges)?;
    let taken: BTreeSet<EdgeId> = edges.iter().copied().collect();
    let mut own = BTreeMap::new();
    for &id in &taken {
        let edge = draft.edge(id).ok_or(EditError::NoEdge(id))?;
        let detached = Edge {
            a: own_vertex(draft, edge.a, &taken, &mut own)?,
            b: own_vertex(draft, edge.b, &taken, &mut own)?,
            ..edge
        };
        draft.set_edge(id, detached);
    }
    Ok(())
}

/// The vertex that the taken edges have where they had `shared`.
fn own_vertex(
    draft: &mut Draft,
    shared: VertexId,
    taken: &BTreeSet<EdgeId>,
    own: &mut BTreeMap<VertexId, VertexId>,
) -> Result<VertexId, EditError> {
    if let Some(&own) = own.get(&shared) {
        return Ok(own);
    }
    if draft.incident(shared).is_subset(taken) {
        return Ok(shared);
    }
    let vertex = draft.vertex(shared).ok_or(WireframeError::NoVertex(shared))?;
    let new = draft.add_vertex(Vertex { joint: None, ..vertex })?;
    own.insert(shared, new);
    Ok(new)
}
