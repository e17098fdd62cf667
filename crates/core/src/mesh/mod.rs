//! The stencil: a surface that a person traces a wireframe on. It is looked at, never bent.

mod placement;

use std::collections::BTreeSet;

use nalgebra::Point3;

pub use placement::{Placement, PlacementError};

/// A polygon mesh in millimetres, right-handed, in the frame of the file it came from.
///
/// Every face has three or more vertices and every index is in range: [`Stencil::new`] checks it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Stencil {
    vertices: Vec<Point3<f64>>,
    faces: Vec<Vec<u32>>,
    bounds: [Point3<f64>; 2],
}

/// Why a mesh cannot be a stencil.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StencilError {
    /// A coordinate is NaN or infinite.
    #[error("vertex {vertex} has a coordinate that is not a finite number")]
    NotFinite {
        /// Index of the vertex, from 0.
        vertex: usize,
    },
    /// A face has fewer than three vertices.
    #[error("face {face} has {count} vertices; a face has at least 3")]
    TooFewVertices {
        /// Index of the face, from 0.
        face: usize,
        /// How many vertices it has.
        count: usize,
    },
    /// A face names a vertex that does not exist.
    #[error("face {face} names vertex {vertex}, but the last vertex is {last}")]
    NoSuchVertex {
        /// Index of the face, from 0.
        face: usize,
        /// The index that it names.
        vertex: u32,
        /// The largest index that exists (-1 when there is none).
        last: i64,
    },
}

impl Stencil {
    /// A stencil from vertices (mm) and faces (indices into the vertices, from 0).
    ///
    /// # Errors
    /// [`StencilError`] names the first vertex or face that is wrong.
    pub fn new(vertices: Vec<Point3<f64>>, faces: Vec<Vec<u32>>) -> Result<Self, StencilError> {
        if let Some(vertex) = vertices.iter().position(|p| !p.coords.iter().all(|c| c.is_finite())) {
            return Err(StencilError::NotFinite { vertex });
        }
        for (face, corners) in faces.iter().enumerate() {
            if corners.len() < 3 {
                return Err(StencilError::TooFewVertices { face, count: corners.len() });
            }
            if let Some(&vertex) = corners.iter().find(|&&v| v as usize >= vertices.len()) {
                let last = i64::try_from(vertices.len()).unwrap_or(i64::MAX) - 1;
                return Err(StencilError::NoSuchVertex { face, vertex, last });
            }
        }
        Ok(Self::of_parts(vertices, faces))
    }

    fn of_parts(vertices: Vec<Point3<f64>>, faces: Vec<Vec<u32>>) -> Self {
        let first = vertices.first().copied().unwrap_or_default();
        let bounds = vertices.iter().fold([first; 2], |[low, high], at| [low.inf(at), high.sup(at)]);
        Self { vertices, faces, bounds }
    }

    /// Positions in millimetres.
    #[must_use]
    pub fn vertices(&self) -> &[Point3<f64>] {
        &self.vertices
    }

    /// Faces as vertex indices, each counter-clockwise seen from outside as far as the file says.
    #[must_use]
    pub fn faces(&self) -> &[Vec<u32>] {
        &self.faces
    }

    /// The lowest and the highest corner of the box around it; both are the origin where it has no vertices.
    #[must_use]
    pub const fn bounds(&self) -> [Point3<f64>; 2] {
        self.bounds
    }

    /// Every side of every face once, lower index first, in ascending order.
    #[must_use]
    pub fn face_edges(&self) -> Vec<(u32, u32)> {
        let mut edges = BTreeSet::new();
        for face in &self.faces {
            for (k, &a) in face.iter().enumerate() {
                let b = face[(k + 1) % face.len()];
                if a != b {
                    edges.insert((a.min(b), a.max(b)));
                }
            }
        }
        edges.into_iter().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square() -> Vec<Point3<f64>> {
        [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| Point3::new(x, y, 0.0)).to_vec()
    }

    #[test]
    fn a_quad_keeps_its_four_sides_and_gets_no_diagonal() {
        let quad = Stencil::new(square(), vec![vec![0, 1, 2, 3]]).unwrap();
        assert_eq!(quad.face_edges(), [(0, 1), (0, 3), (1, 2), (2, 3)]);
    }

    #[test]
    fn two_triangles_share_their_common_side() {
        let mesh = Stencil::new(square(), vec![vec![0, 1, 2], vec![0, 2, 3]]).unwrap();
        assert_eq!(mesh.face_edges().len(), 5);
    }

    #[test]
    fn bad_meshes_are_refused_by_name() {
        assert_eq!(
            Stencil::new(square(), vec![vec![0, 1, 4]]),
            Err(StencilError::NoSuchVertex { face: 0, vertex: 4, last: 3 })
        );
        assert_eq!(
            Stencil::new(square(), vec![vec![0, 1]]),
            Err(StencilError::TooFewVertices { face: 0, count: 2 })
        );
        let mut nan = square();
        nan[2].x = f64::NAN;
        assert_eq!(Stencil::new(nan, vec![]), Err(StencilError::NotFinite { vertex: 2 }));
    }
}
