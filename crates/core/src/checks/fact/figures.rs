//! What a finding measured, and what that is held against.

use super::Fact;
use crate::checks::limit::{Limit, LimitSource, Quantity};
use crate::checks::sequence::Violation;
use crate::units::Angle;

impl Fact {
    /// What was measured or counted; `None` where the finding has no figure.
    #[must_use]
    pub fn measured(&self) -> Option<Quantity> {
        Some(match self {
            Self::ZeroLengthEdge { length, .. }
            | Self::EdgeTooShort { length, .. }
            | Self::EdgeNearLimit { length, .. }
            | Self::CoincidentVertices { distance: length, .. }
            | Self::EdgesMeet { distance: length, .. }
            | Self::FeedTooShort { feed: length, .. }
            | Self::FeedNearLimit { feed: length, .. }
            | Self::FeedTooLong { feed: length, .. }
            | Self::FeedLongerThanStock { feed: length, .. }
            | Self::ArcsOverlap { designed: length, .. }
            | Self::LeadTooShort { lead: length, .. }
            | Self::StockTooLong { needed: length, .. }
            | Self::WireDoesNotFit { diameter: length, .. } => Quantity::Length(*length),
            Self::MeetsMachine { meeting, .. } | Self::MeetsStock(meeting) => Quantity::Length(meeting.depth),
            Self::BendTooSharp { bend, .. }
            | Self::BendNearLimit { bend, .. }
            | Self::BendOutOfReach { bend, .. }
            | Self::BendTooSmall { bend }
            | Self::CornerTooNear { bend }
            | Self::BendInScatter { bend, .. }
            | Self::CornerNotMade { corner: bend, .. }
            | Self::FoldBackNotCompensated { bend }
            | Self::RotationOutOfRange { wanted: bend, .. } => Quantity::Angle(*bend),
            Self::FoldBack { .. } => Quantity::Angle(Angle::HALF_TURN),
            Self::SeveralWires { wires: count }
            | Self::NoEulerPath { odd: count, .. }
            | Self::HeadNotMeasured(count)
            | Self::DoubledEdge { passes: count, .. } => Quantity::Count(*count),
            Self::CornerWithinReach(near) => return near.further.map(Quantity::Angle),
            Self::NoEdges => Quantity::Count(0),
            Self::FrameUnsupported { edges, .. } => Quantity::Count(*edges),
            Self::FrameHardlyStands { displacement, .. } => Quantity::Length(*displacement),
            Self::StrutOverstressed { stress_mpa, .. } => Quantity::Stress(*stress_mpa),
            Self::StrutNearBuckling { ratio, .. } => Quantity::Ratio(*ratio),
            Self::BendTorqueLow { needed_n_m, available_n_m, .. } => {
                Quantity::Ratio(available_n_m.value / needed_n_m)
            }
            Self::BendRadiusSmall(bend) => Quantity::Length(bend.inner),
            Self::PartSags(sag) => Quantity::Length(sag.deflection),
            Self::FrameTooSoft { sag, .. } | Self::SequenceStep(Violation::Sags { sag: Some(sag), .. }) => {
                Quantity::Length(*sag)
            }
            Self::SequenceStep(Violation::HeadMeets { distance, .. }) => Quantity::Length(*distance),
            Self::SequenceStep(Violation::Approach { angle, .. }) => Quantity::Angle(*angle),
            Self::StrutFloating { .. }
            | Self::NoHeadDirection { .. }
            | Self::OutOfWorkspace
            | Self::SequenceNotFound { .. }
            | Self::SequenceStep(_)
            | Self::NoPath(_)
            | Self::ParallelEdges { .. }
            | Self::IsolatedVertex { .. }
            | Self::RouteRefused(_)
            | Self::NoClearProgram { .. }
            | Self::FrameMechanism => return None,
        })
    }

    /// The limit that [`Fact::measured`] is held against; `None` where there is none.
    #[must_use]
    pub fn limit(&self) -> Option<Limit<'_>> {
        Some(match self {
            Self::CoincidentVertices { tolerance, .. } => {
                Limit { value: Quantity::Length(*tolerance), source: LimitSource::WeldTolerance }
            }
            Self::EdgesMeet { diameter, .. } => {
                Limit { value: Quantity::Length(*diameter), source: LimitSource::Diameter }
            }
            Self::NoEulerPath { allowed, .. } => {
                Limit { value: Quantity::Count(*allowed), source: LimitSource::EulerPath }
            }
            Self::EdgeTooShort { limit, .. }
            | Self::EdgeNearLimit { limit, .. }
            | Self::FeedTooShort { limit, .. }
            | Self::FeedNearLimit { limit, .. }
            | Self::FeedTooLong { limit, .. }
            | Self::FeedLongerThanStock { limit, .. }
            | Self::StockTooLong { limit, .. }
            | Self::MeetsMachine { limit, .. } => {
                Limit { value: Quantity::Length(limit.value), source: LimitSource::Stated(&limit.source) }
            }
            Self::ArcsOverlap { needed, bend_radius, .. } => {
                Limit { value: Quantity::Length(*needed), source: LimitSource::BendRadius(*bend_radius) }
            }
            Self::LeadTooShort { needed, .. } => Limit {
                value: Quantity::Length(*needed),
                source: LimitSource::Reach(&super::ReachLimit::Peg),
            },
            Self::BendTooSharp { limit, .. }
            | Self::BendNearLimit { limit, .. }
            | Self::BendInScatter { scatter: limit, .. }
            | Self::FoldBack { limit } => {
                Limit { value: Quantity::Angle(limit.value), source: LimitSource::Stated(&limit.source) }
            }
            Self::BendOutOfReach { max, reach, .. } => {
                Limit { value: Quantity::Angle(*max), source: LimitSource::Reach(reach) }
            }
            Self::CornerNotMade { straight, .. } => {
                Limit { value: Quantity::Angle(*straight), source: LimitSource::AxisResolution }
            }
            Self::RotationOutOfRange { wanted, range: [min, max], source, .. } => {
                let limit = if *wanted < Angle::ZERO { min } else { max };
                Limit { value: Quantity::Angle(*limit), source: LimitSource::Stated(source) }
            }
            Self::WireDoesNotFit { diameter, range: [min, max], source } => {
                let limit = if diameter < min { min } else { max };
                Limit { value: Quantity::Length(*limit), source: LimitSource::Stated(source) }
            }
            Self::BendTorqueLow { margin, available_n_m, .. } => {
                Limit { value: Quantity::Ratio(*margin), source: LimitSource::Stated(&available_n_m.source) }
            }
            Self::BendRadiusSmall(bend) => Limit {
                value: Quantity::Length(bend.least()),
                source: LimitSource::Stated(&bend.least_diameters.source),
            },
            Self::PartSags(sag) => {
                Limit { value: Quantity::Length(sag.small()), source: LimitSource::SmallDeflection }
            }
            Self::StrutOverstressed { yield_mpa, source, .. } => {
                Limit { value: Quantity::Stress(*yield_mpa), source: LimitSource::Stated(source) }
            }
            Self::StrutNearBuckling { limit, .. } => {
                Limit { value: Quantity::Ratio(*limit), source: LimitSource::EulerLoad }
            }
            Self::FrameTooSoft { max, .. } | Self::SequenceStep(Violation::Sags { max, .. }) => {
                Limit { value: Quantity::Length(*max), source: LimitSource::JointReach }
            }
            Self::SequenceStep(Violation::HeadMeets { least, .. }) => {
                Limit { value: Quantity::Length(*least), source: LimitSource::HeadClearance }
            }
            Self::SequenceStep(Violation::Approach { max, .. }) => {
                Limit { value: Quantity::Angle(*max), source: LimitSource::HeadApproach }
            }
            Self::StrutFloating { .. }
            | Self::NoHeadDirection { .. }
            | Self::OutOfWorkspace
            | Self::SequenceNotFound { .. }
            | Self::SequenceStep(_)
            | Self::ZeroLengthEdge { .. }
            | Self::FrameUnsupported { .. }
            | Self::FrameMechanism
            | Self::FrameHardlyStands { .. }
            | Self::NoPath(_)
            | Self::ParallelEdges { .. }
            | Self::IsolatedVertex { .. }
            | Self::SeveralWires { .. }
            | Self::NoEdges
            | Self::RouteRefused(_)
            | Self::NoClearProgram { .. }
            | Self::MeetsStock(_)
            | Self::DoubledEdge { .. }
            | Self::BendTooSmall { .. }
            | Self::CornerTooNear { .. }
            | Self::CornerWithinReach(_)
            | Self::HeadNotMeasured(_)
            | Self::FoldBackNotCompensated { .. } => return None,
        })
    }
}
