//! What is said of a contact.

use super::stroke::Phase;
use crate::units::{Angle, Length};

/// What the wire meets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Obstacle {
    /// A body of the machine, by its index.
    Body(usize),
    /// The wire that is still to be bent.
    Stock,
}

/// Where the wire already bent meets something.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Index of the step, from 0.
    pub step: usize,
    /// What moves.
    pub phase: Phase,
    /// The part of the phase that has passed, from 0 to 1.
    pub passed: f64,
    /// How much of the step is fed by then.
    pub fed: Length,
    /// Where the head is, right-handed about +x of the machine.
    pub head: Angle,
    /// How far the wire is bent, signed as the step's bend.
    pub bent: Angle,
    /// What it meets.
    pub obstacle: Obstacle,
    /// Index of the step that has made the part of the wire that meets it.
    pub leg: usize,
    /// Where on the wire it is, as the length from its start.
    pub along: Length,
}

/// How a wire meets something, least first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum MeetsAs {
    /// It only comes nearer than the margin.
    Near,
    /// It is hit.
    Hit,
    /// One wire is in the middle of the other: neither can give way.
    Through,
}

/// Where a wire first meets one thing as severely as it does anywhere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FirstContact {
    /// The first contact of its kind with it.
    pub contact: Contact,
    /// How deep they are in each other at the worst of that step; below zero where it is not hit: they only come so near.
    pub depth: Length,
    /// In how many later steps they meet again in this way.
    pub later: usize,
    /// How they meet.
    pub kind: MeetsAs,
}

impl FirstContact {
    /// Whether it is hit; otherwise they only come near each other.
    #[must_use]
    pub fn hits(&self) -> bool {
        self.kind > MeetsAs::Near
    }
}
