//! What can be wrong with the order in which the struts of a frame are built.

use crate::units::{Angle, Length};
use crate::wireframe::{EdgeId, VertexId};

/// What a step of a sequence adds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StepKind {
    /// Struts on the ground.
    Ground,
    /// A strut into the open, or a wire with an end there.
    Create,
    /// What joins nodes that are all built.
    Connect,
}

/// A step that cannot be made as it is given, counted from 1.
#[derive(Debug, Clone, PartialEq)]
pub enum Violation {
    /// The design has no such edge.
    UnknownEdge {
        /// The step.
        step: usize,
        /// The edge.
        edge: EdgeId,
    },
    /// An edge is built twice.
    Twice {
        /// The step.
        step: usize,
        /// The edge.
        edge: EdgeId,
        /// The step that builds it first.
        first: usize,
    },
    /// Edges are never built.
    Missing {
        /// The edges, in order of id.
        edges: Vec<EdgeId>,
    },
    /// A step has no edge.
    Empty {
        /// The step.
        step: usize,
    },
    /// The head starts or stands at a vertex that the step's edges do not touch.
    NotAnEnd {
        /// The step.
        step: usize,
        /// The vertex.
        vertex: VertexId,
    },
    /// The head starts or stands where nothing is built.
    Floating {
        /// The step.
        step: usize,
        /// An edge of the step.
        edge: EdgeId,
        /// The vertex from which it was to be built; none where nothing of it is built.
        vertex: Option<VertexId>,
    },
    /// A wire or rod touches what is built at a vertex where no direction is given.
    JointMissing {
        /// The step.
        step: usize,
        /// The vertex.
        vertex: VertexId,
    },
    /// A step is said to be what it is not.
    WrongKind {
        /// The step.
        step: usize,
        /// What is said.
        said: StepKind,
        /// What it is.
        is: StepKind,
    },
    /// Struts on the ground come after one that is not.
    GroundLate {
        /// The step.
        step: usize,
        /// An edge of it.
        edge: EdgeId,
    },
    /// The head's axis is no direction.
    NoDirection {
        /// The step.
        step: usize,
        /// The vertex.
        vertex: VertexId,
    },
    /// The head leans too far over its way.
    Approach {
        /// The step.
        step: usize,
        /// Between axis and way, the least of the given ones.
        angle: Angle,
        /// It has to be below.
        max: Angle,
    },
    /// The head meets a strut that stands, in all given directions.
    HeadMeets {
        /// The step.
        step: usize,
        /// The edge of the strut that it meets in the first direction.
        edge: EdgeId,
        /// How near it comes: below 0 inside the head.
        distance: Length,
        /// The least that is allowed.
        least: Length,
    },
    /// What stands after the step sags too far.
    Sags {
        /// The step.
        step: usize,
        /// The vertex that sags most.
        vertex: VertexId,
        /// How far; none where it does not stand at all.
        sag: Option<Length>,
        /// How far is allowed.
        max: Length,
    },
    /// The tip does not get to a vertex.
    OutOfReach {
        /// The step.
        step: usize,
        /// The vertex.
        vertex: VertexId,
    },
}

impl Violation {
    /// The step, from 1; none where it is the sequence as a whole.
    #[must_use]
    pub const fn step(&self) -> Option<usize> {
        match self {
            Self::Missing { .. } => None,
            Self::UnknownEdge { step, .. }
            | Self::Twice { step, .. }
            | Self::Empty { step }
            | Self::NotAnEnd { step, .. }
            | Self::Floating { step, .. }
            | Self::JointMissing { step, .. }
            | Self::WrongKind { step, .. }
            | Self::GroundLate { step, .. }
            | Self::NoDirection { step, .. }
            | Self::Approach { step, .. }
            | Self::HeadMeets { step, .. }
            | Self::Sags { step, .. }
            | Self::OutOfReach { step, .. } => Some(*step),
        }
    }

    /// The vertex that it is about.
    #[must_use]
    pub const fn vertex(&self) -> Option<VertexId> {
        match self {
            Self::NotAnEnd { vertex, .. }
            | Self::JointMissing { vertex, .. }
            | Self::NoDirection { vertex, .. }
            | Self::Sags { vertex, .. }
            | Self::OutOfReach { vertex, .. } => Some(*vertex),
            Self::Floating { vertex, .. } => *vertex,
            _ => None,
        }
    }

    /// The edges that it is about.
    #[must_use]
    pub fn edges(&self) -> Vec<EdgeId> {
        match self {
            Self::UnknownEdge { edge, .. }
            | Self::Twice { edge, .. }
            | Self::Floating { edge, .. }
            | Self::GroundLate { edge, .. }
            | Self::HeadMeets { edge, .. } => vec![*edge],
            Self::Missing { edges } => edges.clone(),
            _ => Vec::new(),
        }
    }
}
