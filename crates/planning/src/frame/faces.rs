//! The faces of a frame that are to be flat.

use std::collections::BTreeSet;

use nalgebra::Point3;
use schemars::JsonSchema;
use serde::Deserialize;
use wirebend_accuracy::Surface;
use wirebend_core::wireframe::VertexId;
use wirebend_error::InputName;

use crate::PlanningError;
use crate::design::{Input, Opened};

/// The faces that are to be flat, by the ids of their vertices: `[[0, 1, 2, 3], [4, 5, 6, 7]]`.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FacesChoice {
    /// A JSON list of lists of vertices.
    Input(Input),
    /// The vertices themselves.
    Vertices(Vec<Vec<u32>>),
}

impl FacesChoice {
    /// The name for messages and the faces.
    fn load(&self) -> Result<(String, Vec<Vec<u32>>), PlanningError> {
        match self {
            Self::Vertices(faces) => Ok(("what was selected".to_owned(), faces.clone())),
            Self::Input(input) => {
                let (name, bytes) = input.load()?;
                match serde_json::from_slice(&bytes) {
                    Ok(faces) => Ok((name, faces)),
                    Err(error) => Err(PlanningError::Faces { name, reason: error.to_string() }),
                }
            }
        }
    }
}

/// The faces that are chosen, each of vertices that can be off a plane.
pub(super) fn faces(chosen: &FacesChoice, opened: &Opened) -> Result<Vec<Vec<VertexId>>, PlanningError> {
    let (name, faces) = chosen.load()?;
    let wrong = |reason: String| PlanningError::Faces { name: name.clone(), reason };
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

/// What is measured of faces, by the vertices of the design, rising.
pub(super) fn surface(points: &[Point3<f64>], vertices: &[VertexId], faces: &[Vec<VertexId>]) -> Surface {
    let place = |id: &VertexId| vertices.binary_search(id).ok();
    let faces: Vec<Vec<usize>> = faces.iter().map(|face| face.iter().filter_map(place).collect()).collect();
    Surface::faces(points, &faces)
}
