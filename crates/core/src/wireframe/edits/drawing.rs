//! Edits that draw: strands point by point, and whole pieces at once.

use nalgebra::Point3;

use super::super::Vertex;
use super::super::delta::Draft;
use super::super::graph::{Edge, VertexId};
use super::{EditError, topology};

/// The most vertices that are drawn at once.
const LARGEST_PIECE: usize = 1_000_000;

/// A chain of edges from a vertex that is there, if any, through new ones, to one that is there, if any.
pub(super) fn strand(
    draft: &mut Draft,
    from: Option<VertexId>,
    through: &[Point3<f64>],
    to: Option<VertexId>,
) -> Result<(), EditError> {
    if through.len() > LARGEST_PIECE {
        return Err(EditError::TooMuch(through.len()));
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
        (None, None) => Err(EditError::Nothing),
        _ => Ok(()),
    }
}

/// New vertices, and edges between them by their places in the list.
pub(super) fn piece(
    draft: &mut Draft,
    vertices: &[Vertex],
    edges: &[(usize, usize)],
) -> Result<(), EditError> {
    if vertices.len() > LARGEST_PIECE || edges.len() > LARGEST_PIECE {
        return Err(EditError::TooMuch(vertices.len().max(edges.len())));
    }
    let ids: Vec<VertexId> =
        vertices.iter().map(|&vertex| draft.add_vertex(vertex)).collect::<Result<_, _>>()?;
    let id =
        |place: usize| ids.get(place).copied().ok_or(EditError::NoPlace { place, count: vertices.len() });
    for &(a, b) in edges {
        let edge = Edge { a: id(a)?, b: id(b)? };
        if edge.a == edge.b {
            return Err(EditError::Loop(edge.a));
        }
        draft.add_edge(edge)?;
    }
    Ok(())
}
