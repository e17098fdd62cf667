//! What a person measured of the coupons, with readings that are missing and repeats.

use super::figure::{Figure, ReadingPlace};
use crate::units::{Angle, Length};

/// Bends that the axis was sent to one position for.
#[derive(Debug, Clone, PartialEq)]
pub struct AngleSample {
    /// Position of the bend axis. Beyond zero it has the sign of the bend.
    pub axis: Angle,
    /// To which side it bends, 1 or -1: small bends stay while the axis is still before zero.
    pub side: f64,
    /// The angle that stayed, from the direction of the wire before the bend to that behind it: 0 is straight. Its sign
    /// may be left out.
    pub readings: Vec<Option<Angle>>,
}

impl AngleSample {
    /// Bends of an axis that went beyond zero, so that its sign is the side.
    #[must_use]
    pub fn beyond_zero(axis: Angle, readings: Vec<Option<Angle>>) -> Self {
        Self { axis, side: axis.signum(), readings }
    }
}

/// The same side of a U, between two bends.
#[derive(Debug, Clone, PartialEq)]
pub struct LengthSample {
    /// What was fed for the side.
    pub feed: Length,
    /// Position of the bend axis for the bend before the side.
    pub axis_before: Angle,
    /// And for the bend behind it.
    pub axis_after: Angle,
    /// From corner to corner of the centreline.
    pub readings: Vec<Option<Length>>,
}

/// The same turn of the head between two bends.
#[derive(Debug, Clone, PartialEq)]
pub struct TurnSample {
    /// How far the head was commanded to turn.
    pub rotate: Angle,
    /// Whether it had turned the other way before, so that play has to be taken up first.
    pub reverses: bool,
    /// The angle from the plane of the bend before to that of the bend behind, signed as the turn; its sign may be left
    /// out.
    pub readings: Vec<Option<Angle>>,
}

/// All that was measured.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Measurements {
    /// Bends.
    pub angles: Vec<AngleSample>,
    /// Sides of U-shapes.
    pub lengths: Vec<LengthSample>,
    /// Turns of the head.
    pub turns: Vec<TurnSample>,
}

/// What is calibrated apart from the others.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// Springback, and where the peg goes.
    Bends,
    /// The feed and the wire in a bend.
    Feeds,
    /// The turns of the head.
    Turns,
}

/// A unit that a reading seems to be in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OtherUnit {
    /// Radians for degrees.
    Radians,
    /// Inches for millimetres.
    Inches,
    /// Centimetres for millimetres.
    Centimetres,
    /// The angle between the two legs, which is 180° less the bend.
    InnerAngle,
}

/// Why a reading is left out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LeftOutReason {
    /// It does not fit the others: a typing error, or something happened to the bend.
    DoesNotFit,
    /// It cannot be: no bend is as large, no side as short.
    Impossible,
    /// The bend axis does not go there.
    AxisOutOfRange {
        /// How far it goes to either side.
        limit: Angle,
    },
    /// The wire is bent to the other side than was commanded.
    OtherSide,
    /// It seems to be in another unit.
    Unit(OtherUnit),
    /// Nothing stayed of the bend: that tells no angle, only that more is lost than was pressed.
    NoBend,
}

/// A reading that is left out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LeftOut {
    /// What it is of.
    pub kind: Kind,
    /// Where it stands.
    pub place: ReadingPlace,
    /// What it says.
    pub reading: Figure,
    /// What the others say that it should be.
    pub expected: Figure,
    /// Why.
    pub reason: LeftOutReason,
}

/// What the measurements do not tell, and what is done for want of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Gap {
    /// No reading of a kind is left: its figures stay as they were.
    NoReadings {
        /// The kind.
        kind: Kind,
        /// How many readings there were before some were left out.
        given: usize,
    },
    /// Bends to one side only: the other side is taken to be the same.
    OneSide {
        /// The side that is missing: 1 positive, -1 negative.
        missing: f64,
    },
    /// All bends were commanded alike: a constant springback fits them, whatever the machine's dimensions.
    OneAngle {
        /// The position of the axis.
        axis: Angle,
    },
    /// A curve of the springback was asked for, and a side has too few angles for one: none is made.
    FewAngles {
        /// How many a side needs.
        needed: usize,
    },
    /// All sides were fed the same: the feed's scale and the wire in a bend cannot be told apart.
    OneLength {
        /// The feed.
        feed: Length,
    },
    /// The machine compensates springback itself: what was found of it is in no profile.
    SpringbackLeft,
    /// The machine deducts bends from feeds itself: a side is what is fed, and tells nothing of the wire in a bend.
    DeductionLeft,
    /// No turn goes against the one before: the play of the head is not determined.
    NoReversal,
}
