//! Why an edit cannot be made.

use super::super::graph::{EdgeId, VertexId, WireframeError};
use crate::units::{Angle, Length};

/// Why an edit cannot be made. The wireframe is untouched.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum EditError {
    /// A vertex does not exist, a position is out of range, or no ids are left.
    #[error(transparent)]
    Wireframe(#[from] WireframeError),
    /// An edge does not exist.
    #[error("there is no edge {0}")]
    NoEdge(EdgeId),
    /// A vertex is listed more than once.
    #[error("vertex {0} is listed twice")]
    Repeated(VertexId),
    /// An edge would join a vertex with itself.
    #[error("vertex {0} cannot be connected to itself")]
    Loop(VertexId),
    /// An edge is listed more than once.
    #[error("edge {0} is listed twice")]
    RepeatedEdge(EdgeId),
    /// A chain of fewer than two edges.
    #[error("a chain of {0} edges; it has at least 2")]
    ChainCount(usize),
    /// More than two edges of a chain meet at a vertex.
    #[error("{edges} edges of the chain meet at vertex {vertex}; at most 2 do")]
    Branched {
        /// The vertex where they meet.
        vertex: VertexId,
        /// How many edges of the chain meet there.
        edges: usize,
    },
    /// A chain in several parts: this edge is not connected to those before it.
    #[error("edge {0} is not connected to the rest of the chain")]
    BrokenChain(EdgeId),
    /// A chain that is a closed loop, so that it has no ends to hold fixed.
    #[error("the chain is a closed loop")]
    ClosedChain,
    /// The step along an arc is not more than 0° and at most 180°.
    #[error("a step of {0:.3} along an arc; it is more than 0° and at most 180°")]
    ArcStep(Angle),
    /// An arc is too small for two edges of the shortest length that was asked for.
    #[error("an arc of radius {radius:.2} is too small for edges of {min_edge:.2}")]
    SmallArc {
        /// Radius of the arc.
        radius: Length,
        /// The shortest edge that was asked for.
        min_edge: Length,
    },
    /// A length in mm that no edge has: 0, less, or no number.
    #[error("a length of {0} mm; it is more than 0")]
    EdgeLength(f64),
    /// An angle in degrees that no two edges have: 0, less, more than 180, or no number.
    #[error("an angle of {0}° between edges; it is more than 0° and at most 180°")]
    CornerAngle(f64),
    /// A vertex is not an end of an edge.
    #[error("vertex {vertex} is not an end of edge {edge}")]
    NotAnEnd {
        /// The edge.
        edge: EdgeId,
        /// The vertex.
        vertex: VertexId,
    },
    /// The ends of an edge are at the same place.
    #[error("edge {0} has no length, so no direction")]
    NoDirection(EdgeId),
    /// An angle at a vertex that has not two edges, without saying between which.
    #[error("{edges} edges at vertex {vertex}; an angle is between 2")]
    NoCorner {
        /// The vertex.
        vertex: VertexId,
        /// How many edges it has.
        edges: usize,
    },
    /// Two edges join the same two vertices.
    #[error("edges {0} and {1} have the same ends")]
    SameEnds(EdgeId, EdgeId),
    /// The edges at a vertex are in line, and no plane is given to turn one of them in.
    #[error("the edges at vertex {0} are in line, so they have no plane")]
    InLine(VertexId),
    /// What is beyond an edge is to follow, but is connected to what stays.
    #[error("edge {0} is part of a closed loop")]
    InLoop(EdgeId),
    /// A radius in mm that no fillet has: 0, less, or no number.
    #[error("a fillet with a radius of {0} mm; it is more than 0")]
    FilletRadius(f64),
    /// A corner whose edges are in line or on each other.
    #[error("the edges at vertex {0} are in line or on each other, so there is no corner")]
    StraightCorner(VertexId),
    /// A corner that is a support or has a joint, which a fillet would move.
    #[error("vertex {0} is a support or has a joint")]
    HeldCorner(VertexId),
    /// A fillet with chords, or with what is left of its edges, shorter than the shortest edge.
    #[error("no fillet of radius {radius:.2} at vertex {vertex} with edges of at least {min_edge:.2}")]
    Fillet {
        /// The corner.
        vertex: VertexId,
        /// The radius that was asked for.
        radius: Length,
        /// How long what is too short would be; 0 where nothing would be left.
        length: Length,
        /// The shortest edge that can be made there.
        min_edge: Length,
        /// What is too short.
        fault: FilletFault,
        /// The nearest radius that can be made at all corners, to a tenth of a millimetre, and where there is one such, of which no check
        /// warns; none where there is none.
        nearest: Option<Length>,
    },
    /// A number of sides that no polygon has.
    #[error("{sides} sides; a polygon has from 3 to {max}")]
    Sides {
        /// How many were asked for.
        sides: u32,
        /// How many there may be.
        max: u32,
    },
    /// A size in mm that no shape has: 0, less, or no number.
    #[error("a size of {0} mm; it is more than 0")]
    ShapeSize(f64),
    /// A number of turns that no helix has.
    #[error("{0} turns; a helix has more than 0 and at most 10,000")]
    Turns(f64),
    /// Two vertices are already joined by an edge.
    #[error("vertices {0} and {1} are connected already")]
    Connected(VertexId, VertexId),
    /// A split that is not between the ends of its edge: more than 0 and less than 1.
    #[error("a split at {0} of the edge; it is more than 0 and less than 1")]
    SplitAt(f64),
    /// Fewer than two vertices to merge.
    #[error("{0} vertices to merge; it takes at least 2")]
    MergeCount(usize),
    /// A transform that is not finite, or that would flatten the wireframe.
    #[error("the transform is not invertible")]
    Singular,
    /// A strand with neither a vertex to begin at nor a point to go through.
    #[error("the strand is empty")]
    EmptyStrand,
    /// More vertices or edges than can be added at once.
    #[error("{count} vertices or edges at once; at most {max}")]
    TooMuch {
        /// How many would be added.
        count: usize,
        /// How many may be.
        max: usize,
    },
    /// An edge of a piece ends at a vertex that the piece does not have.
    #[error("an edge of the piece ends at its vertex {index}; it has {count}, counted from 0")]
    NotInPiece {
        /// The index that the edge names, from 0.
        index: usize,
        /// How many vertices the piece has.
        count: usize,
    },
    /// An array whose copies have more vertices than can be added at once.
    #[error("an array of {copies} copies; at most {max} vertices can be added at once")]
    ArrayCount {
        /// How many copies were asked for.
        copies: u32,
        /// How many vertices all copies together may have.
        max: usize,
    },
}

/// What of a fillet is too short.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FilletFault {
    /// Two chords of the arc are: the radius is too small.
    Chords,
    /// What is left of an edge is: the radius is too large.
    Edges,
}
