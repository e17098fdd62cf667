//! Of which bend a fact is.

use crate::wireframe::VertexId;

/// Which bend a finding is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BendOf {
    /// The bend that the route makes at a step.
    Step,
    /// The same, where no route avoids one beyond the limit at this vertex.
    Forced,
    /// The least that the sharpest bend at a vertex can be, where there is no route yet.
    Vertex,
}

/// The bend that closes the gap between two edges that come too close.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ClosingBend {
    /// The vertex at which it is.
    pub vertex: VertexId,
    /// The step, where it is that of the only wire.
    pub step: Option<usize>,
    /// Whether one edge snaps past the other in it, rather than only coming to press on it.
    pub snaps_past: bool,
}
