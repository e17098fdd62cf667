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

/// The bend that brings two edges together that come too close.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Brought {
    /// The vertex at which it is.
    pub vertex: VertexId,
    /// Whether one edge passes the other on the way, and does not only come to where it is.
    pub passes: bool,
}
