//! Remedies for front ends, which offer an option or a button for those that they can do.

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_core::checks::Remedy;
use wirebend_core::units::Length;

/// What can be done about a finding, where the finding is.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(tag = "remedy", rename_all = "snake_case")]
pub enum RemedyReport {
    /// Leave the design as it is.
    Leave,
    /// Leave two vertices apart where two wires are meant to touch.
    LeaveTouching,
    /// Leave room for wires side by side.
    LeaveRoom,
    /// Tie wires that run side by side.
    HoldUp,
    TieWires,
    /// Weld or tie wires where they touch.
    FastenThere,
    /// Put a vertex where two edges come close, which joins them.
    JoinEdges,
    DrawEdges,
    /// Take the edges of a model's faces.
    TakeFaceEdges,
    DeleteEdge,
    /// Delete one of two edges between the same vertices.
    DeleteParallelEdge,
    MergeVertices,
    /// Connect the vertex to another one.
    ConnectVertex,
    DeleteVertex,
    /// Connect the parts of the design.
    ConnectParts,
    /// Bend a wire for each part of the design.
    BendEachPart,
    /// Double edges; no other choice adds less length.
    DoubleEdges {
        edges: Vec<u32>,
        /// The length that they add, in mm.
        added_mm: f64,
        /// The length of the wire's edges without them, in mm.
        design_mm: f64,
    },
    /// Double edges, besides those that are doubled or proposed, for a detour around the bend, the shortest walk within the limit
    /// at each turn.
    Detour {
        /// By id; one may be there more than once.
        edges: Vec<u32>,
        /// The length that they add, in mm.
        added_mm: f64,
    },
    /// Have the edges found whose doubling adds the least length.
    FindDoubling,
    /// Add or delete edges until at most two vertices are odd.
    ReduceOddVertices,
    /// Start the wire at the vertex.
    StartAtVertex {
        /// The change in doubled length, in mm, where no bend there is beyond the limit then; negative where it gets shorter.
        #[serde(skip_serializing_if = "Option::is_none")]
        added_mm: Option<f64>,
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
    LengthenEdge {
        /// By at least so much, in mm, where that is known.
        #[serde(skip_serializing_if = "Option::is_none")]
        by_mm: Option<f64>,
    },
    /// Shorten the straight part.
    ShortenStraight,
    /// Put a bend into the straight part.
    AddBend,
    /// Scale the design up.
    ScaleUp,
    /// Scale the design down.
    ScaleDown,
    /// Open the angle between the two edges.
    OpenAngle,
    /// Open the angle between two edges of the vertex.
    OpenAngleOfTwo,
    /// Keep the bend below a magnitude.
    KeepBendBelow {
        /// The largest bend that can be reached, in degrees.
        max_deg: f64,
    },
    /// Make the bend larger.
    EnlargeBend,
    /// Put the edges into one line.
    Straighten,
    /// Make the bends at the ends of the edge smaller.
    EaseBends,
    /// Turn the plane of the bend.
    TurnBendPlane,
    /// Move the edges apart.
    MoveApart,
    /// Search for an order of the bends with which the wire meets nothing.
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
    /// Build the strut at another step, or what is in its way.
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

impl From<&Remedy> for RemedyReport {
    fn from(remedy: &Remedy) -> Self {
        match remedy {
            Remedy::Leave => Self::Leave,
            Remedy::LeaveTouching => Self::LeaveTouching,
            Remedy::LeaveRoom => Self::LeaveRoom,
            Remedy::HoldUp => Self::HoldUp,
            Remedy::TieWires => Self::TieWires,
            Remedy::FastenThere => Self::FastenThere,
            Remedy::JoinEdges => Self::JoinEdges,
            Remedy::DrawEdges => Self::DrawEdges,
            Remedy::TakeFaceEdges => Self::TakeFaceEdges,
            Remedy::DeleteEdge => Self::DeleteEdge,
            Remedy::DeleteParallelEdge => Self::DeleteParallelEdge,
            Remedy::MergeVertices => Self::MergeVertices,
            Remedy::ConnectVertex => Self::ConnectVertex,
            Remedy::DeleteVertex => Self::DeleteVertex,
            Remedy::ConnectParts => Self::ConnectParts,
            Remedy::BendEachPart => Self::BendEachPart,
            Remedy::DoubleEdges { edges, added, design } => Self::DoubleEdges {
                edges: edges.iter().map(|id| id.0).collect(),
                added_mm: added.mm(),
                design_mm: design.mm(),
            },
            Remedy::Detour { edges, added } => {
                Self::Detour { edges: edges.iter().map(|id| id.0).collect(), added_mm: added.mm() }
            }
            Remedy::FindDoubling => Self::FindDoubling,
            Remedy::ReduceOddVertices => Self::ReduceOddVertices,
            Remedy::StartAtVertex { added } => Self::StartAtVertex { added_mm: added.map(Length::mm) },
            Remedy::EndAtVertex => Self::EndAtVertex,
            Remedy::ChooseStart => Self::ChooseStart,
            Remedy::LeaveStartOpen => Self::LeaveStartOpen,
            Remedy::SplitDesign => Self::SplitDesign,
            Remedy::SplitEdge => Self::SplitEdge,
            Remedy::LengthenEdge { by } => Self::LengthenEdge { by_mm: by.map(Length::mm) },
            Remedy::ShortenStraight => Self::ShortenStraight,
            Remedy::AddBend => Self::AddBend,
            Remedy::ScaleUp => Self::ScaleUp,
            Remedy::ScaleDown => Self::ScaleDown,
            Remedy::OpenAngle => Self::OpenAngle,
            Remedy::OpenAngleOfTwo => Self::OpenAngleOfTwo,
            Remedy::KeepBendBelow { max } => Self::KeepBendBelow { max_deg: max.deg() },
            Remedy::EnlargeBend => Self::EnlargeBend,
            Remedy::Straighten => Self::Straighten,
            Remedy::EaseBends => Self::EaseBends,
            Remedy::TurnBendPlane => Self::TurnBendPlane,
            Remedy::MoveApart => Self::MoveApart,
            Remedy::AvoidCollisions => Self::AvoidCollisions,
            Remedy::SearchLonger => Self::SearchLonger,
            Remedy::AllowWires => Self::AllowWires,
            Remedy::Calibrate => Self::Calibrate,
            Remedy::MeasureBody => Self::MeasureBody,
            Remedy::SupportVertices => Self::SupportVertices,
            Remedy::BraceFrame => Self::BraceFrame,
            Remedy::BuildLater => Self::BuildLater,
            Remedy::TurnHead => Self::TurnHead,
            Remedy::MoveFrame => Self::MoveFrame,
            Remedy::AllowMoreSag => Self::AllowMoreSag,
            Remedy::ChooseMaterial => Self::ChooseMaterial,
            Remedy::ChooseMachine => Self::ChooseMachine,
            Remedy::ChooseMachineWithRotation => Self::ChooseMachineWithRotation,
        }
    }
}
