//! Edits that change where vertices are, and what they and their edges are marked with.

use nalgebra::{Affine3, Vector3};

use super::super::delta::Draft;
use super::super::graph::{Edge, EdgeId, VertexId, WireframeError};
use super::super::{Joint, Vertex};
use super::{EditError, check_edges, check_listed};

pub(super) fn shift(draft: &mut Draft, vertices: &[VertexId], by: &Vector3<f64>) -> Result<(), EditError> {
    check_listed(draft, vertices)?;
    for &id in vertices {
        draft.move_vertex(id, draft.position(id)? + by)?;
    }
    Ok(())
}

pub(super) fn transform(
    draft: &mut Draft,
    vertices: &[VertexId],
    transform: &Affine3<f64>,
) -> Result<(), EditError> {
    check_listed(draft, vertices)?;
    check_invertible(transform)?;
    for &id in vertices {
        draft.move_vertex(id, transform * draft.position(id)?)?;
    }
    Ok(())
}

pub(super) fn set_support(draft: &mut Draft, vertices: &[VertexId], support: bool) -> Result<(), EditError> {
    check_listed(draft, vertices)?;
    for &id in vertices {
        let vertex = draft.vertex(id).ok_or(WireframeError::NoVertex(id))?;
        draft.set_vertex(id, Vertex { support, free: [false; 6], ..vertex })?;
    }
    Ok(())
}

pub(super) fn set_joint(
    draft: &mut Draft,
    vertices: &[VertexId],
    joint: Option<Joint>,
) -> Result<(), EditError> {
    check_listed(draft, vertices)?;
    for &id in vertices {
        let vertex = draft.vertex(id).ok_or(WireframeError::NoVertex(id))?;
        draft.set_vertex(id, Vertex { joint, ..vertex })?;
    }
    Ok(())
}

pub(super) fn set_ceiling(draft: &mut Draft, edges: &[EdgeId], ceiling: bool) -> Result<(), EditError> {
    check_edges(draft, edges)?;
    for &id in edges {
        let edge = draft.edge(id).ok_or(EditError::NoEdge(id))?;
        draft.set_edge(id, Edge { ceiling, ..edge });
    }
    Ok(())
}

/// A transform that is not finite or squeezes space flat cannot be undone by a person's eye.
pub(super) fn check_invertible(transform: &Affine3<f64>) -> Result<(), EditError> {
    let linear = transform.matrix().fixed_view::<3, 3>(0, 0).into_owned();
    let size = linear.norm();
    let finite = transform.matrix().iter().all(|c| c.is_finite());
    if finite && linear.determinant().abs() > 1e-12 * size.powi(3) {
        Ok(())
    } else {
        Err(EditError::Singular)
    }
}
