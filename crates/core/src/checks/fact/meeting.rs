//! How the wire already bent meets something.

use super::Fact;
use crate::clearance::Phase;
use crate::units::{Angle, Length};
use crate::wireframe::EdgeId;

/// How the wire already bent meets something in a step.
#[derive(Debug, Clone, PartialEq)]
pub struct Meeting {
    /// The edges of the straight part that meets it.
    pub struck: Vec<EdgeId>,
    /// What moves.
    pub phase: Phase,
    /// How much of the step is fed.
    pub fed: Length,
    /// How far the wire is bent, with the sign of the bend.
    pub bent: Angle,
    /// Where the head is, right-handed about +x of the machine.
    pub head: Angle,
    /// How deep they are in each other at the worst of the step; below zero: they only come so near.
    pub depth: Length,
    /// In how many later steps they meet again in this way.
    pub later: usize,
}

impl Fact {
    /// How the wire meets something, where that is what it says.
    #[must_use]
    pub fn meeting(&self) -> Option<&Meeting> {
        match self {
            Self::MeetsMachine { meeting, .. } | Self::MeetsStock(meeting) => Some(meeting),
            _ => None,
        }
    }
}

impl Meeting {
    /// Whether it is hit, rather than only nearer than the wire has to stay.
    #[must_use]
    pub fn hits(&self) -> bool {
        self.depth >= Length::ZERO
    }
}
