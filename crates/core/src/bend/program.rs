//! The types that a program is made of.

use std::ops::Range;

use crate::units::{Angle, Length};

/// Feed, then rotate, then bend.
///
/// The last step of a wire has only a feed. A feed of zero between two bends is allowed, because
/// programs of other tools hold such steps.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Step {
    /// How far the wire is fed along its tangent t.
    pub feed: Length,
    /// Right-handed turn of the frame about t, before the bend of this same step.
    pub rotate: Angle,
    /// Right-handed turn of the frame about b (t towards n).
    pub bend: Angle,
}

/// The program of the design itself: what an ideal machine with ideal wire would be told.
///
/// Bends are in [0°, 180°], rotations in (-180°, 180°], and the first bend is not preceded by a
/// rotation. It is never sent to a machine: see [`crate::compensate`].
#[derive(Debug, Clone, PartialEq, Default)]
pub struct NominalProgram {
    /// The steps.
    pub steps: Vec<Step>,
    /// For each step the segments of the path that its feed runs along; more than one where
    /// vertices lie on a straight line. The bend of the step is at the end of the last one.
    pub spans: Vec<Range<usize>>,
}

impl NominalProgram {
    /// A program as another tool wrote it: each feed is one segment.
    #[must_use]
    pub fn from_steps(steps: Vec<Step>) -> Self {
        let spans = (0..steps.len()).map(|k| k..k + 1).collect();
        Self { steps, spans }
    }

    /// How many steps bend the wire.
    #[must_use]
    pub fn bend_count(&self) -> usize {
        self.steps.iter().filter(|step| step.bend != Angle::ZERO).count()
    }

    /// All feeds together.
    #[must_use]
    pub fn length(&self) -> Length {
        self.steps.iter().map(|step| step.feed).sum()
    }
}

/// Whether a machine counts an axis as we do or the other way round.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Sign {
    /// Its positive is ours.
    #[default]
    Same,
    /// Its positive is our negative.
    Opposite,
}

impl Sign {
    /// An angle of ours as the machine counts it; and back, since the two are the same operation.
    #[must_use]
    pub fn apply(self, angle: Angle) -> Angle {
        match self {
            Self::Same => angle,
            Self::Opposite => -angle,
        }
    }
}

/// How a machine counts its axes, as its profile says.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Convention {
    /// The bend axis.
    pub bend: Sign,
    /// The rotation axis.
    pub rotate: Sign,
}

impl Convention {
    /// A step of ours as the machine counts it; and back.
    #[must_use]
    pub fn apply(self, step: Step) -> Step {
        Step { feed: step.feed, rotate: self.rotate.apply(step.rotate), bend: self.bend.apply(step.bend) }
    }
}
