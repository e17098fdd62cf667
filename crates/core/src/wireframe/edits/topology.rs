//! Edits that change what is joined to what.

use nalgebra::{Point3, Vector3};

use super::super::Vertex;
use super::super::delta::Draft;
use super::super::graph::{Edge, EdgeId, VertexId};
use super::{EditError, MergeAt, check_listed};

pub(super) fn connect(draft: &mut Draft, a: VertexId, b: VertexId) -> Result<(), EditError> {
    draft.position(a)?;
    draft.position(b)?;
    if a == b {
        return Err(EditError::Loop(a));
    }
    let edge = Edge::between(a, b);
    if draft.joined(edge, None) {
        return Err(EditError::Connected(a, b));
    }
    draft.add_edge(edge)?;
    Ok(())
}

pub(super) fn delete(draft: &mut Draft, vertices: &[VertexId], edges: &[EdgeId]) -> Result<(), EditError> {
    check_listed(draft, vertices)?;
    if let Some(&missing) = edges.iter().find(|&&id| draft.edge(id).is_none()) {
        return Err(EditError::NoEdge(missing));
    }
    for &id in edges {
        draft.remove_edge(id);
    }
    for &id in vertices {
        draft.remove_vertex(id);
    }
    Ok(())
}

pub(super) fn split(draft: &mut Draft, id: EdgeId, at: f64) -> Result<(), EditError> {
    let edge = draft.edge(id).ok_or(EditError::NoEdge(id))?;
    if !(at > 0.0 && at < 1.0) {
        return Err(EditError::SplitAt(at));
    }
    let (a, b) = (draft.position(edge.a)?, draft.position(edge.b)?);
    let middle = draft.add_vertex(Vertex::at(a + (b - a) * at))?;
    draft.set_edge(id, Edge { b: middle, ..edge });
    draft.add_edge(Edge { a: middle, ..edge })?;
    Ok(())
}

pub(super) fn merge(draft: &mut Draft, vertices: &[VertexId], at: MergeAt) -> Result<(), EditError> {
    check_listed(draft, vertices)?;
    let [survivor, gone @ ..] = vertices else {
        return Err(EditError::MergeCount(0));
    };
    let Some(last) = gone.last() else {
        return Err(EditError::MergeCount(1));
    };
    let position = match at {
        MergeAt::First => draft.position(*survivor)?,
        MergeAt::Last => draft.position(*last)?,
        MergeAt::Centre => centre(draft, vertices)?,
    };
    let all = vertices.iter().filter_map(|&id| draft.vertex(id));
    let merged = all.reduce(Vertex::with_marks_of).unwrap_or(Vertex::at(position));
    draft.set_vertex(*survivor, Vertex { position, ..merged })?;
    for &old in gone {
        for id in draft.incident(old) {
            let Some(edge) = draft.edge(id) else { continue };
            let onto = |v: VertexId| if v == old { *survivor } else { v };
            let moved = Edge { a: onto(edge.a), b: onto(edge.b), ..edge };
            if moved.a == moved.b {
                draft.remove_edge(id);
            } else if let Some((kept, _)) = draft.joining(moved, Some(id)) {
                draft.remove_edge(id);
                draft.keep_mark(kept, moved);
            } else {
                draft.set_edge(id, moved);
            }
        }
        draft.remove_vertex(old);
    }
    Ok(())
}

#[allow(clippy::cast_precision_loss)] // a selection has far fewer than 2^52 vertices
fn centre(draft: &Draft, vertices: &[VertexId]) -> Result<Point3<f64>, EditError> {
    let mut sum = Vector3::zeros();
    for &id in vertices {
        sum += draft.position(id)?.coords;
    }
    Ok(Point3::from(sum / vertices.len() as f64))
}
