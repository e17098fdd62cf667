//! Edits that add images of what is there: mirror and array.

use std::collections::BTreeMap;

use nalgebra::{Affine3, Matrix3, Matrix4, Point3, Unit, Vector3};

use super::super::Vertex;
use super::super::delta::Draft;
use super::super::graph::{Edge, VertexId, WireframeError};
use super::super::welder::Welder;
use super::{EditError, check_listed, placement};
use crate::units::Length;

/// The most vertices that one array may add.
const MAX_ARRAY_VERTICES: usize = 1_000_000;

/// The reflection in a plane through `point`.
#[must_use]
pub fn reflection(point: Point3<f64>, normal: Unit<Vector3<f64>>) -> Affine3<f64> {
    let linear = Matrix3::identity() - 2.0 * normal.into_inner() * normal.transpose();
    let offset = point.coords - linear * point.coords;
    let mut matrix = Matrix4::identity();
    matrix.fixed_view_mut::<3, 3>(0, 0).copy_from(&linear);
    matrix.fixed_view_mut::<3, 1>(0, 3).copy_from(&offset);
    Affine3::from_matrix_unchecked(matrix)
}

/// Adds the image of vertices and of the edges between them; returns the image of each vertex. An
/// image within `weld` of one of the originals shares that vertex.
pub(super) fn copy(
    draft: &mut Draft,
    vertices: &[VertexId],
    image: &Affine3<f64>,
    weld: Length,
) -> Result<Vec<VertexId>, EditError> {
    check_listed(draft, vertices)?;
    placement::check_invertible(image)?;
    let mut image_of = BTreeMap::new();
    let mut images = Vec::with_capacity(vertices.len());
    let mut originals = Welder::new(weld);
    for &id in vertices {
        originals.put(id.0, draft.position(id)?);
    }
    for &id in vertices {
        let vertex = draft.vertex(id).ok_or(WireframeError::NoVertex(id))?;
        let position = image * vertex.position;
        let copied = match originals.near(position) {
            Some(shared) => VertexId(shared),
            None => draft.add_vertex(Vertex { position, ..vertex })?,
        };
        image_of.insert(id, copied);
        images.push(copied);
    }
    for edge in draft.edges().into_values() {
        if let (Some(&a), Some(&b)) = (image_of.get(&edge.a), image_of.get(&edge.b)) {
            let copied = Edge { a, b, ..edge };
            if a != b && !draft.joined(copied, None) {
                draft.add_edge(copied)?;
            }
        }
    }
    Ok(images)
}

pub(super) fn array(
    draft: &mut Draft,
    vertices: &[VertexId],
    step: &Affine3<f64>,
    count: u32,
    weld: Length,
) -> Result<(), EditError> {
    if (count as usize).saturating_mul(vertices.len()) > MAX_ARRAY_VERTICES {
        return Err(EditError::ArrayCount { copies: count, max: MAX_ARRAY_VERTICES });
    }
    let mut last = vertices.to_vec();
    for _ in 0..count {
        last = copy(draft, &last, step, weld)?;
        // Vertices that were shared stand once in the next copy's list.
        let mut seen = std::collections::BTreeSet::new();
        last.retain(|&id| seen.insert(id));
        if last.is_empty() {
            break;
        }
    }
    Ok(())
}
