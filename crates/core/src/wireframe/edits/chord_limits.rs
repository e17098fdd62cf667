//! What of chords and of the edges of shapes a machine can make.

use crate::units::Length;

/// A value that is farther from a limit than this part of it is not near it. The checks warn of those that are.
pub const NEAR_LIMIT: f64 = 0.05;

/// What is shorter than a millionth of a millimetre is no edge.
pub(super) const NOTHING: f64 = 1e-6;

/// What of chords, and of the edges of shapes, a machine can make.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ChordLimits {
    /// The shortest edge as designed.
    pub min_edge: Length,
    /// The shortest feed, which has to be left of an edge once its arcs are taken off.
    pub min_feed: Length,
    /// Centreline radius of a bend; 0 where feeds are as designed.
    pub bend_radius: Length,
    /// Radius of the neutral fibre of a bend; 0 likewise.
    pub neutral_radius: Length,
    /// The least that is straight before the first bend of a wire, with what is bent of it; 0 where the wire may begin with a bend.
    pub lead: Length,
}

impl ChordLimits {
    /// The shortest edge between two bends of up to 90°.
    #[must_use]
    pub fn between_right_angles(&self) -> Length {
        Length::computed(self.side(std::f64::consts::FRAC_PI_2))
    }

    /// The limits of which a check does not even warn: everything that keeps them is clear of the machine's own.
    pub(super) fn with_margin(&self) -> Self {
        let clear = |limit: Length| {
            let mm = limit.mm();
            // What rounding takes away does not bring it back to the limit.
            Length::computed(if mm > 0.0 { mm * (1.0 + NEAR_LIMIT) + 10.0 * NOTHING } else { mm })
        };
        Self { min_edge: clear(self.min_edge), min_feed: clear(self.min_feed), ..*self }
    }

    /// The shortest chord, mm, where the wire is bent by `bend` between two chords and by half of it at the ends of the arc, in
    /// whichever direction it runs: a feed is shorter than its edge by the tangents at both ends, and longer by the arc of one.
    pub(super) fn chord(&self, bend: f64) -> f64 {
        let (radius, neutral) = (self.bend_radius.mm(), self.neutral_radius.mm());
        let at_end = radius * ((bend / 2.0).tan() + (bend / 4.0).tan()) - neutral * bend / 2.0;
        self.with_feed(self.lost_between(bend).max(at_end))
    }

    /// The shortest edge of a shape, mm, where the wire is bent by `bend` between two of them; one may be the last of the wire, which
    /// is shorter by the tangent at its beginning, and one the first, which has to reach the peg.
    pub(super) fn side(&self, bend: f64) -> f64 {
        let tangent = self.bend_radius.mm() * (bend / 2.0).tan();
        let lead = self.lead.mm() + tangent - self.neutral_radius.mm() * bend;
        let first = if self.lead > Length::ZERO && bend > 0.0 { lead } else { 0.0 };
        self.with_feed(self.lost_between(bend).max(tangent)).max(first)
    }

    /// How much shorter than its edge a feed is between two equal bends, mm.
    fn lost_between(&self, bend: f64) -> f64 {
        2.0 * self.bend_radius.mm() * (bend / 2.0).tan() - self.neutral_radius.mm() * bend
    }

    /// The shortest edge of which a feed is left that is so much shorter, mm.
    fn with_feed(&self, lost: f64) -> f64 {
        self.min_edge.mm().max(self.min_feed.mm() + lost.max(0.0))
    }

    /// The shortest that may be left of an edge, mm, which ends at an arc with a bend by `own` there, and at its other end with one by
    /// `far`, in whichever direction the wire runs.
    pub(super) fn left(&self, own: f64, far: f64) -> f64 {
        let (radius, neutral) = (self.bend_radius.mm(), self.neutral_radius.mm());
        let tangent = |bend: f64| radius * (bend / 2.0).tan();
        let between = tangent(own) + tangent(far) - neutral * own.min(far);
        // Where the wire begins at the arc, nothing of a bend before is fed.
        self.with_feed(between.max(tangent(own)))
    }
}
