//! The faces of a frame that are to be flat.

use std::collections::BTreeSet;

use nalgebra::Point3;
use wirebend_core::accuracy::Surface;
use wirebend_core::wireframe::{VertexId, Wireframe};
use wirebend_error::InputName;

use crate::PlanningError;
use crate::design::{Input, Opened};

/// Faces as a person writes them: `[[0, 1, 2], [3, 4, 5]]`, by the ids of their vertices.
pub(super) fn faces(input: &Input, opened: &Opened) -> Result<Vec<Vec<VertexId>>, PlanningError> {
    let (name, bytes) = input.load()?;
    let wrong = |reason: String| PlanningError::Faces { name: name.clone(), reason };
    let faces: Vec<Vec<u32>> = serde_json::from_slice(&bytes).map_err(|error| wrong(error.to_string()))?;
    if faces.is_empty() {
        return Err(wrong("there is no face in it".to_owned()));
    }
    for (k, face) in faces.iter().enumerate() {
        if let Some(&vertex) =
            face.iter().find(|&&id| opened.document.wireframe.vertex(VertexId(id)).is_none())
        {
            return Err(opened.no_vertex(vertex, InputName::Faces));
        }
        let different: BTreeSet<u32> = face.iter().copied().collect();
        if different.len() < face.len() || face.len() < 4 {
            let held = format!("face {} has {} different vertices of {}", k + 1, different.len(), face.len());
            return Err(wrong(format!("{held}: it takes 4 or more, each once, to be off a plane")));
        }
        let loose = |id: &&u32| opened.document.wireframe.incident(VertexId(**id)).is_empty();
        if let Some(vertex) = face.iter().find(loose) {
            return Err(wrong(format!(
                "no strut ends at vertex {vertex} of face {}: it is never off",
                k + 1
            )));
        }
        let at = |id: &u32| opened.document.wireframe.vertex(VertexId(*id)).map(|vertex| vertex.position);
        let points: Vec<Point3<f64>> = face.iter().filter_map(at).collect();
        if Surface::faces(&points, &[(0..points.len()).collect()]).face_count() == 0 {
            let held = format!("the vertices of face {} are all on one line", k + 1);
            return Err(wrong(format!("{held}: it has no plane that they could be off")));
        }
    }
    Ok(faces.into_iter().map(|face| face.into_iter().map(VertexId).collect()).collect())
}

/// What is measured: the faces, or all vertices at which struts end.
pub(super) fn surface(
    points: &[Point3<f64>],
    vertices: &[VertexId],
    faces: Option<&[Vec<VertexId>]>,
    wireframe: &Wireframe,
) -> Surface {
    let place = |id: &VertexId| vertices.binary_search(id).ok();
    if let Some(faces) = faces {
        let faces: Vec<Vec<usize>> =
            faces.iter().map(|face| face.iter().filter_map(place).collect()).collect();
        Surface::faces(points, &faces)
    } else {
        let used = vertices.iter().enumerate().filter(|(_, id)| !wireframe.incident(**id).is_empty());
        Surface::whole(points, &used.map(|(k, _)| k).collect::<Vec<_>>())
    }
}
