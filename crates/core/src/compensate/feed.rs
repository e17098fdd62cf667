//! Feed compensation: an arc needs less wire than the corner that it replaces.

use crate::bend::Step;
use crate::units::{Angle, Length};

/// How much wire a bend takes (WireBend-kit Eq. 1, with its two losses added as they must be):
/// F = L - `r_c`·(tan(|θp|/2) + tan(|θq|/2)) + ρ·|θq|.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FeedModel {
    /// Centreline radius of a bend: pin radius and half the wire.
    pub bend_radius: Length,
    /// Radius of the neutral fibre: pin radius and K times the diameter.
    pub neutral_radius: Length,
}

impl FeedModel {
    /// The model for a pin, a wire and a K-factor measured from the inner face of the wire.
    #[must_use]
    pub fn new(pin_radius: Length, diameter: Length, k_factor: f64) -> Self {
        Self {
            bend_radius: Length::computed(pin_radius.mm() + diameter.mm() / 2.0),
            neutral_radius: Length::computed(pin_radius.mm() + k_factor * diameter.mm()),
        }
    }

    /// How far the corner of a bend is from the ends of its arc; it saturates towards a fold back.
    #[must_use]
    pub fn corner(&self, bend: Angle) -> Length {
        corner(self.bend_radius, bend)
    }

    /// Wire along the neutral fibre of a bend.
    #[must_use]
    pub fn arc(&self, bend: Angle) -> Length {
        Length::computed(self.neutral_radius.mm() * bend.abs().rad())
    }

    /// What stays straight of a segment between two bends; negative where their arcs overlap.
    #[must_use]
    pub fn straight(&self, segment: Length, before: Angle, after: Angle) -> Length {
        segment - self.corner(before) - self.corner(after)
    }

    /// What to feed for a segment from corner to corner, so that the arc of the bend after it is
    /// made of fed wire too. A missing bend is zero.
    #[must_use]
    pub fn feed_for(&self, segment: Length, before: Angle, after: Angle) -> Length {
        self.straight(segment, before, after) + self.arc(after)
    }

    /// The segment from corner to corner that a feed leaves between two bends: the inverse of
    /// [`FeedModel::feed_for`].
    #[must_use]
    pub fn segment_of(&self, feed: Length, before: Angle, after: Angle) -> Length {
        feed - self.arc(after) + self.corner(before) + self.corner(after)
    }
}

/// How far the corner of a bend is from the ends of its arc of a centreline radius. A fold back has no
/// corner: the length grows without bound towards 180° and saturates there.
#[must_use]
pub(crate) fn corner(radius: Length, bend: Angle) -> Length {
    let half = (bend.abs().rad() / 2.0).min(std::f64::consts::FRAC_PI_2 - 1e-9);
    Length::computed(radius.mm() * half.tan())
}

/// Each step with the bend before it: zero for the first.
pub(crate) fn with_bend_before(steps: &[Step]) -> impl Iterator<Item = (Angle, &Step)> {
    let before = std::iter::once(Angle::ZERO).chain(steps.iter().map(|step| step.bend));
    before.zip(steps)
}
