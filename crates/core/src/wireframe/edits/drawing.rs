//! Edits that draw: strands point by point, and whole pieces at once.

use nalgebra::Point3;

use super::super::Vertex;
use super::super::delta::Draft;
use super::super::graph::{Edge, VertexId};
use super::{EditError, topology};

/// The most vertices that are drawn at once.
pub(super) const MAX_DRAWN: usize = 1_000_000;

/// A chain of edges from a vertex that is there, if any, through new ones, to one that is there, if any.
pub(super) fn strand(
    draft: &mut Draft,
    from: Option<VertexId>,
    through: &[Point3<f64>],
    to: Option<VertexId>,
) -> Result<(), EditError> {
    if through.len() > MAX_DRAWN {
        return Err(EditError::TooMuch { count: through.len(), max: MAX_DRAWN });
    }
    let mut last = from;
    for &position in through {
        let next = draft.add_vertex(Vertex::at(position))?;
        if let Some(last) = last {
            topology::connect(draft, last, next)?;
        }
        last = Some(next);
    }
    match (last, to) {
        (Some(last), Some(to)) => topology::connect(draft, last, to),
        (None, None) => Err(EditError::EmptyStrand),
        _ => Ok(()),
    }
}

/// New vertices, and edges between them by their places in the list.
pub(super) fn piece(
    draft: &mut Draft,
    vertices: &[Vertex],
    edges: &[(usize, usize)],
) -> Result<(), EditError> {
    if vertices.len() > MAX_DRAWN || edges.len() > MAX_DRAWN {
        return Err(EditError::TooMuch { count: vertices.len().max(edges.len()), max: MAX_DRAWN });
    }
    let ids: Vec<VertexId> =
        vertices.iter().map(|&vertex| draft.add_vertex(vertex)).collect::<Result<_, _>>()?;
    let id =
        |index: usize| ids.get(index).copied().ok_or(EditError::NotInPiece { index, count: vertices.len() });
    for &(a, b) in edges {
        let edge = Edge::between(id(a)?, id(b)?);
        if edge.a == edge.b {
            return Err(EditError::Loop(edge.a));
        }
        draft.add_edge(edge)?;
    }
    Ok(())
}
