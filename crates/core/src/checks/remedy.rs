//! What a person can do about a finding.

use super::WireStages;
use crate::route::{Doubling, StartThere};
use crate::units::{Angle, Length};
use crate::wireframe::{EdgeId, VertexId, Wireframe};

/// A way to remove the cause of a finding, with the figures that it needs. Where it applies is the location of the
/// finding. A front end has words for each, and offers what it can do of them.
#[derive(Debug, Clone, PartialEq)]
pub enum Remedy {
    /// Leave the design as it is: it can be bent.
    Leave,
    /// Leave two vertices apart where two wires are meant to touch.
    LeaveTouching,
    /// Leave room for the wires that run side by side along an edge.
    LeaveRoom,
    /// Hold the part up while it is bent.
    HoldUp,
    /// Tie the wires that run side by side along an edge.
    TieWires,
    /// Weld or tie the wires where they touch.
    FastenThere,
    /// Put a vertex where two edges come close, which joins them.
    JoinEdges,
    /// Draw edges.
    DrawEdges,
    /// Take the edges of a model's faces.
    TakeFaceEdges,
    /// Delete the edge.
    DeleteEdge,
    /// Delete one of two edges between the same vertices: an edge that the wire has to pass twice needs no second one.
    DeleteParallelEdge,
    /// Merge the vertices into one.
    MergeVertices,
    /// Connect the vertex to another one.
    ConnectVertex,
    /// Delete the vertex.
    DeleteVertex,
    /// Connect the parts of the design, so that one wire can run through all of them.
    ConnectParts,
    /// Bend a wire for each part of the design.
    BendEachPart,
    /// Double edges: let the wire run along them once more. No other choice adds less length.
    DoubleEdges {
        /// The edges, in order of id.
        edges: Vec<EdgeId>,
        /// The length that they add to the wire.
        added: Length,
        /// The length of all edges of the wire without them.
        design: Length,
    },
    /// Double edges, besides those that are doubled or proposed: a detour around the bend, the shortest walk within the limit
    /// at each turn.
    Detour {
        /// The edges, in order of id; one may be there more than once.
        edges: Vec<EdgeId>,
        /// The length that they add to the wire.
        added: Length,
    },
    /// Have the edges found whose doubling adds the least length.
    FindDoubling,
    /// Add or delete edges until at most two vertices are odd.
    ReduceOddVertices,
    /// Start the wire at the vertex.
    StartAtVertex {
        /// The change in doubled length, where no bend there is beyond the limit then; negative where it gets shorter. None where it
        /// was not tried.
        added: Option<Length>,
    },
    /// Start or end the wire at the vertex.
    EndAtVertex,
    /// Start the wire at another vertex.
    ChooseStart,
    /// Leave the start of the wire open.
    LeaveStartOpen,
    /// Divide the design into several wires.
    SplitDesign,
    /// Divide the edge among two wires.
    SplitEdge,
    /// Lengthen the edge; by at least so much where that is known.
    LengthenEdge {
        /// How much it lacks.
        by: Option<Length>,
    },
    /// Shorten the straight part.
    ShortenStraight,
    /// Put a bend into the straight part.
    AddBend,
    /// Scale the design up.
    ScaleUp,
    /// Scale the design down.
    ScaleDown,
    /// Open the angle between the two edges, so that the bend is smaller.
    OpenAngle,
    /// Open the angle between two edges of the vertex, so that a wire can pass from one to the other.
    OpenAngleOfTwo,
    /// Keep the bend below a magnitude.
    KeepBendBelow {
        /// The largest bend that can be reached.
        max: Angle,
    },
    /// Make the bend larger.
    EnlargeBend,
    /// Put the edges into one line, so that there is no bend.
    Straighten,
    /// Make the bends at the ends of the edge smaller.
    EaseBends,
    /// Turn the plane of the bend.
    TurnBendPlane,
    /// Move the edges apart.
    MoveApart,
    /// Search for a walk, signs and windings with which the wire meets nothing.
    AvoidCollisions,
    /// Search longer.
    SearchLonger,
    /// Allow more wires.
    AllowWires,
    /// Calibrate the machine with its wire.
    Calibrate,
    /// Measure the body of the machine and enter its dimensions.
    MeasureBody,
    /// Hold the frame at vertices.
    SupportVertices,
    /// Brace the frame with more struts.
    BraceFrame,
    /// Build it later, or what is in its way.
    BuildLater,
    /// Choose another direction of the head.
    TurnHead,
    /// Move the frame to where the machine reaches.
    MoveFrame,
    /// Allow joints to be farther from where they are drawn.
    AllowMoreSag,
    /// Choose another material.
    ChooseMaterial,
    /// Choose another machine.
    ChooseMachine,
    /// Choose a machine whose head turns farther.
    ChooseMachineWithRotation,
}

impl Remedy {
    /// Whether it has the wires run another way, which takes a design that is planned anew.
    #[must_use]
    pub const fn plans_anew(&self) -> bool {
        match self {
            Self::BendEachPart
            | Self::DoubleEdges { .. }
            | Self::Detour { .. }
            | Self::FindDoubling
            | Self::StartAtVertex { .. }
            | Self::EndAtVertex
            | Self::ChooseStart
            | Self::LeaveStartOpen
            | Self::SplitDesign
            | Self::SplitEdge
            | Self::AvoidCollisions
            | Self::SearchLonger
            | Self::AllowWires => true,
            Self::Leave
            | Self::LeaveTouching
            | Self::LeaveRoom
            | Self::HoldUp
            | Self::TieWires
            | Self::FastenThere
            | Self::JoinEdges
            | Self::DrawEdges
            | Self::TakeFaceEdges
            | Self::DeleteEdge
            | Self::DeleteParallelEdge
            | Self::MergeVertices
            | Self::ConnectVertex
            | Self::DeleteVertex
            | Self::ConnectParts
            | Self::ReduceOddVertices
            | Self::LengthenEdge { .. }
            | Self::ShortenStraight
            | Self::AddBend
            | Self::ScaleUp
            | Self::ScaleDown
            | Self::OpenAngle
            | Self::OpenAngleOfTwo
            | Self::KeepBendBelow { .. }
            | Self::EnlargeBend
            | Self::Straighten
            | Self::EaseBends
            | Self::TurnBendPlane
            | Self::MoveApart
            | Self::Calibrate
            | Self::MeasureBody
            | Self::SupportVertices
            | Self::BraceFrame
            | Self::BuildLater
            | Self::TurnHead
            | Self::MoveFrame
            | Self::AllowMoreSag
            | Self::ChooseMaterial
            | Self::ChooseMachine
            | Self::ChooseMachineWithRotation => false,
        }
    }

    /// The remedy of a doubling that has been found for a wire.
    pub(crate) fn double(doubling: &Doubling, wireframe: &Wireframe) -> Self {
        let (edges, added) = (doubling.edges.clone(), doubling.added);
        Self::DoubleEdges { edges, added, design: wireframe.total_length() }
    }

    /// A start at the vertex of a bend, where the wire begins and ends at one vertex: from elsewhere it would run along other edges.
    pub(crate) fn start_of_closed(wire: &WireStages) -> Option<Self> {
        let walk = &wire.route?.traversals;
        let is_closed = walk.first()?.from == walk.last()?.to;
        is_closed.then_some(Self::StartAtVertex { added: None })
    }

    /// The remedies of a bend at a vertex that every route from elsewhere makes: a start there, and a detour, where they avoid it.
    pub(crate) fn around(wire: &WireStages, vertex: VertexId) -> Vec<Self> {
        let Some(forced) = wire.forced.iter().find(|forced| forced.vertex == vertex) else {
            return Self::start_of_closed(wire).into_iter().collect();
        };
        let start = match forced.start {
            StartThere::NotTried | StartThere::HelpsNot => None,
            StartThere::Adds(added) => Some(Self::StartAtVertex { added: Some(added) }),
        };
        let detour = forced.detour.clone().map(|Doubling { edges, added }| Self::Detour { edges, added });
        start.into_iter().chain(detour).collect()
    }
}
