//! Which edges of a design the struts of a sequence are: files of sequences know positions alone.

use std::collections::BTreeMap;

use nalgebra::Point3;
use wirebend_core::units::{Length, Mm};
use wirebend_core::wireframe::{EdgeId, VertexId, Wireframe};
use wirebend_error::{ErrorCode, ErrorRemedy};

use super::SequenceFile;

/// A step of a sequence as an edge of the design.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MatchedStep {
    pub edge: EdgeId,
    /// The end at which the tool begins.
    pub from: VertexId,
}

/// Why a sequence is not of this design. Steps count from 1.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StrutMatchError {
    /// No vertex is where a strut begins or ends.
    #[error("step {step} of the sequence: no vertex of the design within {} of ({:.3}, {:.3}, {:.3})", Mm(*tolerance_mm), at[0], at[1], at[2])]
    NoVertex { step: usize, at: [f64; 3], tolerance_mm: f64 },
    /// No edge joins the two vertices.
    #[error("step {step} of the sequence: no edge of the design joins vertices {a} and {b}")]
    NoEdge { step: usize, a: VertexId, b: VertexId },
    /// A strut is built twice.
    #[error("step {step} of the sequence: edge {edge} is built in step {first} already")]
    Repeated { step: usize, edge: EdgeId, first: usize },
    /// Some edges of the design are never built.
    #[error("{count} edges of the design are not in the sequence, the first is edge {first}")]
    Missing { count: usize, first: EdgeId },
}

impl StrutMatchError {
    #[must_use]
    pub fn code(&self) -> ErrorCode {
        ErrorCode::ReadOtherDesign
    }

    /// What can be done about it.
    #[must_use]
    pub fn remedies(&self) -> Vec<ErrorRemedy> {
        vec![ErrorRemedy::CheckRightFile]
    }
}

wirebend_error::reported!(StrutMatchError);

impl SequenceFile {
    /// The steps as edges of a design, each edge once.
    ///
    /// # Errors
    /// [`StrutMatchError`] where a strut is no edge, is built twice, or an edge is not built.
    pub fn match_edges(
        &self,
        wireframe: &Wireframe,
        tolerance: Length,
    ) -> Result<Vec<MatchedStep>, StrutMatchError> {
        let mut edges: BTreeMap<(VertexId, VertexId), Vec<EdgeId>> = BTreeMap::new();
        for (id, edge) in wireframe.edges() {
            edges.entry(edge.ends()).or_default().push(id);
        }
        let vertices: Vec<(VertexId, Point3<f64>)> =
            wireframe.vertices().map(|(id, vertex)| (id, vertex.position)).collect();
        let mut built: BTreeMap<EdgeId, usize> = BTreeMap::new();
        let mut steps = Vec::with_capacity(self.steps.len());
        for (step, strut) in (1..).zip(&self.steps) {
            let end = |at: &Point3<f64>| {
                nearest(&vertices, at, tolerance).ok_or(StrutMatchError::NoVertex {
                    step,
                    at: at.coords.into(),
                    tolerance_mm: tolerance.mm(),
                })
            };
            let (from, to) = (end(&strut.start)?, end(&strut.end)?);
            let joining = edges.get(&(from.min(to), from.max(to))).map(Vec::as_slice).unwrap_or_default();
            // Of parallel edges each step takes another one.
            let Some(&edge) = joining.iter().find(|id| !built.contains_key(id)).or(joining.first()) else {
                return Err(StrutMatchError::NoEdge { step, a: from, b: to });
            };
            if let Some(&first) = built.get(&edge) {
                return Err(StrutMatchError::Repeated { step, edge, first });
            }
            built.insert(edge, step);
            steps.push(MatchedStep { edge, from });
        }
        let missing: Vec<EdgeId> =
            wireframe.edges().map(|(id, _)| id).filter(|id| !built.contains_key(id)).collect();
        match missing.first() {
            Some(&first) => Err(StrutMatchError::Missing { count: missing.len(), first }),
            None => Ok(steps),
        }
    }
}

/// The vertex that is nearest, within the tolerance.
fn nearest(vertices: &[(VertexId, Point3<f64>)], at: &Point3<f64>, tolerance: Length) -> Option<VertexId> {
    let distance = |(_, position): &&(VertexId, Point3<f64>)| (position - at).norm();
    let nearest = vertices.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
    (distance(&nearest) <= tolerance.mm()).then_some(nearest.0)
}
