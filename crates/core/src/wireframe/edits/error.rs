//! Why an edit cannot be made.

use super::super::graph::{EdgeId, VertexId, WireframeError};
use crate::units::{Angle, Length};

/// Why an edit cannot be made. The wireframe is untouched.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum EditError {
    /// A vertex, an edge end or a position is wrong.
    #[error(transparent)]
    Wireframe(#[from] WireframeError),
    /// An edge is not there.
    #[error("there is no edge {0}")]
    NoEdge(EdgeId),
    /// A vertex is listed twice.
    #[error("vertex {0} is listed twice")]
    Repeated(VertexId),
    /// An edge from a vertex to itself.
    #[error("vertex {0} cannot be connected to itself")]
    Loop(VertexId),
    /// An edge is listed twice.
    #[error("edge {0} is listed twice")]
    RepeatedEdge(EdgeId),
    /// Fewer than two edges for a chain.
    #[error("a chain takes at least 2 edges, {0} given")]
    ChainCount(usize),
    /// More than two edges of a chain at a vertex.
    #[error("the edges are no chain: {edges} of them meet at vertex {vertex}; leave all but 2 out there")]
    Branched {
        /// Where.
        vertex: VertexId,
        /// How many.
        edges: usize,
    },
    /// A chain in several parts.
    #[error("the edges are no chain: edge {0} does not hang together with the others")]
    BrokenChain(EdgeId),
    /// A chain without ends.
    #[error("the edges are a closed loop: leave one of them out, so that the chain has two ends, which stay")]
    ClosedChain,
    /// A step that does not divide an arc.
    #[error("an arc is divided by steps of more than 0° and at most 180°: {0:.3} is none")]
    ArcStep(Angle),
    /// The shortest edge leaves nothing of an arc.
    #[error(
        "an arc of radius {radius:.2} cannot be made of edges of at least {least_edge:.2}: give a shorter one, or a smaller tolerance"
    )]
    SmallArc {
        /// Of the arc.
        radius: Length,
        /// What was asked for.
        least_edge: Length,
    },
    /// The two vertices are joined already.
    #[error("vertices {0} and {1} are connected already")]
    Connected(VertexId, VertexId),
    /// A split outside the edge.
    #[error("an edge is split between its ends: {0} is not more than 0 and less than 1")]
    SplitAt(f64),
    /// Fewer than two vertices to merge.
    #[error("merging takes at least 2 vertices, {0} given")]
    MergeCount(usize),
    /// A transform that flattens or is not finite.
    #[error("the transform is not invertible: it would flatten the wireframe")]
    Singular,
    /// A strand that goes nowhere.
    #[error("a strand takes a vertex to begin at or a point to go through")]
    Nothing,
    /// More than can be drawn at once.
    #[error("{0} vertices or edges are too many: at most 1 000 000 can be added at once")]
    TooMuch(usize),
    /// A pasted edge names a vertex that is not in the piece.
    #[error("an edge of the piece ends at its vertex {place}, but it has {count}, counted from 0")]
    NoPlace {
        /// What it names.
        place: usize,
        /// How many there are.
        count: usize,
    },
    /// More copies than fit.
    #[error("an array of {0} copies is too large: at most 1 000 000 vertices can be added at once")]
    ArrayCount(u32),
}
