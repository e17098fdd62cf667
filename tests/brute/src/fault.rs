//! What can be wrong with a sequence.

use crate::Kind;

/// What is wrong with a step, counted from 1.
#[derive(Debug, Clone, PartialEq)]
pub enum Fault {
    /// The design has no such edge.
    UnknownEdge { step: usize, edge: u32 },
    /// An earlier step has built it.
    BuiltTwice { step: usize, edge: u32, first: usize },
    /// No step builds these.
    NeverBuilt { edges: Vec<u32> },
    /// A step has no edge.
    Empty { step: usize },
    /// The head is to be at a vertex where no edge of the step ends.
    NotAnEnd { step: usize, vertex: u32 },
    /// No vertex of what is placed is built.
    Floating { step: usize },
    /// The head is to begin or to stand where nothing is built.
    NothingBuilt { step: usize, vertex: u32 },
    /// The head is at none of the vertices by which a strut hangs on what is built, or not at one of those of a wire.
    JointMissing { step: usize, vertex: u32 },
    /// It is not what it is said to be.
    OtherKind { step: usize, said: Kind, is: Kind },
    /// It is on the ground, and something that is not stands already.
    GroundLate { step: usize },
    /// The axis of the head is no direction, or there is none.
    NoDirection { step: usize, vertex: u32 },
    /// In no direction does the axis lean little enough over the way; the least angle.
    Leans { step: usize, deg: f64 },
    /// In no direction is the head free; the edge that it hits in the first, and how near it comes to that, below 0 inside.
    Hits { step: usize, edge: u32, mm: f64 },
    /// A vertex sags too far.
    Sags { step: usize, vertex: u32, mm: f64 },
    /// What is built does not stand, and did before.
    Falls { step: usize },
    /// The tip does not get to a vertex.
    OutOfReach { step: usize, vertex: u32 },
}
