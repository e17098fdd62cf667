//! Of which bend a fact is.

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
