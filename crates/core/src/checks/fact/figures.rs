//! What a finding measured, and what that is held against.

use super::Fact;
use crate::checks::limit::{Limit, LimitSource, Quantity};
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
            | Self::StockTooLong { needed: length, .. }
            | Self::WireDoesNotFit { diameter: length, .. } => Quantity::Length(*length),
            // Less than zero where they only come near each other.
            Self::MeetsMachine { depth, margin, .. } | Self::MeetsStock { depth, margin, .. } => {
                Quantity::Length(*depth - *margin)
            }
            Self::BendTooSharp { bend, .. }
            | Self::BendNearLimit { bend, .. }
            | Self::BendOutOfReach { bend, .. }
            | Self::BendTooSmall { bend }
            | Self::BendInScatter { bend, .. }
            | Self::CornerNotMade { corner: bend, .. }
            | Self::FoldBackNotCompensated { bend }
            | Self::RotationOutOfRange { wanted: bend, .. } => Quantity::Angle(*bend),
            Self::FoldBack { .. } => Quantity::Angle(Angle::HALF_TURN),
            Self::SeveralWires { wires: count }
            | Self::NoEulerPath { odd: count, .. }
            | Self::DoubledEdge { passes: count, .. } => Quantity::Count(*count),
            Self::NoEdges => Quantity::Count(0),
            Self::NoPath(_)
            | Self::ParallelEdges { .. }
            | Self::IsolatedVertex { .. }
            | Self::RouteRefused(_)
            | Self::NoClearProgram { .. } => return None,
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
            Self::RotationOutOfRange { wanted, range: [min, max], source } => {
                let limit = if *wanted < Angle::ZERO { min } else { max };
                Limit { value: Quantity::Angle(*limit), source: LimitSource::Stated(source) }
            }
            Self::WireDoesNotFit { diameter, range: [min, max], source } => {
                let limit = if diameter < min { min } else { max };
                Limit { value: Quantity::Length(*limit), source: LimitSource::Stated(source) }
            }
            Self::ZeroLengthEdge { .. }
            | Self::NoPath(_)
            | Self::ParallelEdges { .. }
            | Self::IsolatedVertex { .. }
            | Self::SeveralWires { .. }
            | Self::NoEdges
            | Self::RouteRefused(_)
            | Self::NoClearProgram { .. }
            | Self::MeetsStock { .. }
            | Self::DoubledEdge { .. }
            | Self::BendTooSmall { .. }
            | Self::FoldBackNotCompensated { .. } => return None,
        })
    }
}
