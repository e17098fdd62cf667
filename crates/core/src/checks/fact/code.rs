//! Which kind of finding says what.

use super::Fact;
use crate::checks::Code;
use crate::checks::sequence::Violation;

impl Fact {
    /// The name of this kind of finding.
    #[must_use]
    pub const fn code(&self) -> Code {
        match self {
            Self::ZeroLengthEdge { .. } | Self::NoPath(_) => Code::ZeroLengthEdge,
            Self::ParallelEdges { .. } => Code::ParallelEdges,
            Self::CoincidentVertices { .. } => Code::CoincidentVertices,
            Self::EdgesMeet { .. } => Code::EdgesMeet,
            Self::IsolatedVertex { .. } => Code::IsolatedVertex,
            Self::SeveralWires { .. } => Code::SeveralWires,
            Self::NoEdges => Code::NoEdges,
            Self::NoEulerPath { .. } => Code::NoEulerPath,
            Self::RouteRefused(_) => Code::RouteRefused,
            Self::DoubledEdge { .. } => Code::DoubledEdge,
            Self::EdgeTooShort { .. } => Code::EdgeTooShort,
            Self::EdgeNearLimit { .. } => Code::EdgeNearLimit,
            Self::FeedTooShort { .. } => Code::FeedTooShort,
            Self::FeedNearLimit { .. } => Code::FeedNearLimit,
            Self::FeedTooLong { .. } | Self::FeedLongerThanStock { .. } => Code::FeedTooLong,
            Self::ArcsOverlap { .. } => Code::ArcsOverlap,
            Self::StockTooLong { .. } => Code::StockTooLong,
            Self::BendTooSharp { .. } => Code::BendTooSharp,
            Self::BendNearLimit { .. } => Code::BendNearLimit,
            Self::BendOutOfReach { .. } => Code::BendOutOfReach,
            Self::BendTooSmall { .. } => Code::BendTooSmall,
            Self::LeadTooShort { .. } => Code::LeadTooShort,
            Self::CornerTooNear { .. } => Code::CornerTooNear,
            Self::CornerWithinReach(_) => Code::CornerWithinReach,
            Self::HeadNotMeasured(_) => Code::HeadNotMeasured,
            Self::BendInScatter { .. } => Code::BendInScatter,
            Self::CornerNotMade { .. } => Code::CornerNotMade,
            Self::FoldBack { .. } | Self::FoldBackNotCompensated { .. } => Code::FoldBack,
            Self::RotationOutOfRange { .. } => Code::RotationOutOfRange,
            Self::WireDoesNotFit { .. } => Code::WireDoesNotFit,
            Self::BendTorqueLow { .. } => Code::BendTorqueLow,
            Self::BendRadiusSmall(_) => Code::BendRadiusSmall,
            Self::PartSags(_) => Code::PartSags,
            Self::MeetsMachine { .. } => Code::MeetsMachine,
            Self::MeetsStock { .. } => Code::MeetsStock,
            Self::NoClearProgram { .. } => Code::NoClearProgram,
            Self::FrameUnsupported { .. } => Code::FrameUnsupported,
            Self::FrameMechanism => Code::FrameMechanism,
            Self::StrutOverstressed { .. } => Code::StrutOverstressed,
            Self::StrutNearBuckling { .. } => Code::StrutNearBuckling,
            Self::FrameTooSoft { .. }
            | Self::FrameHardlyStands { .. }
            | Self::SequenceStep(Violation::Sags { .. }) => Code::FrameTooSoft,
            Self::StrutFloating { .. } | Self::SequenceStep(Violation::Floating { .. }) => {
                Code::StrutFloating
            }
            Self::NoHeadDirection { .. }
            | Self::SequenceStep(
                Violation::NoDirection { .. } | Violation::Approach { .. } | Violation::HeadMeets { .. },
            ) => Code::NoHeadDirection,
            Self::OutOfWorkspace | Self::SequenceStep(Violation::OutOfReach { .. }) => Code::OutOfWorkspace,
            Self::SequenceNotFound { .. } => Code::SequenceNotFound,
            Self::SequenceStep(
                Violation::UnknownEdge { .. }
                | Violation::Twice { .. }
                | Violation::Missing { .. }
                | Violation::Empty { .. }
                | Violation::NotAnEnd { .. }
                | Violation::JointMissing { .. }
                | Violation::WrongKind { .. }
                | Violation::GroundLate { .. },
            ) => Code::SequenceWrong,
        }
    }
}
