//! What a controller should never do, and what the bench could not work out.

/// A mistake of the controller, and when.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("pulse {pulse}: {what}")]
pub struct Incident {
    /// How many pulses had come, this one included.
    pub pulse: u64,
    pub what: Violation,
}

/// What a controller should never do. A motion that stays wrong is reported once.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Violation {
    /// The feed moved with the peg not in.
    #[error("fed with the peg {}", standing(*.touching))]
    FedWithPeg {
        /// Whether it touched the wire.
        touching: bool,
    },
    /// The head turned with the peg not in.
    #[error("turned the head with the peg {}", standing(*.touching))]
    RotatedWithPeg {
        /// Whether it touched the wire.
        touching: bool,
    },
    /// The peg came out where the wire was.
    #[error("the peg came out into the wire with the bend axis at {axis_deg:.2} degrees")]
    PegIntoWire {
        /// Where the bend axis stood.
        axis_deg: f64,
    },
    /// The peg went in while it held the wire. The wire springs back anyway; a stop may have to.
    #[error("the peg went in under load with the bend axis at {axis_deg:.2} degrees")]
    PegInUnderLoad {
        /// Where the bend axis stood.
        axis_deg: f64,
    },
    /// The bend axis moved while the peg was on its way.
    #[error("the bend axis moved before the peg had arrived")]
    BentWithPegBetween,
    /// The bend axis went where it cannot go.
    #[error("the bend axis went to {axis_deg:.2} degrees, past its limit")]
    BendPastLimit {
        /// Where it was first seen beyond.
        axis_deg: f64,
    },
    /// The head turned further than its cables allow.
    #[error("the head went to {head_deg:.2} degrees, past its limit")]
    HeadPastLimit {
        /// Where it was first seen beyond.
        head_deg: f64,
    },
    /// The feed pulled a bend, or the wire's tip, into the nozzle. The wire slipped by the rest.
    #[error("the feed pulled back {by_mm:.2} mm more wire than there was straight before the nozzle")]
    PulledTooFar {
        /// How much of it slipped.
        by_mm: f64,
    },
}

fn standing(touching: bool) -> &'static str {
    if touching { "against the wire" } else { "out" }
}

/// Where the model is weaker than usual. The controller is not to blame: the program is, or the profile.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ModelWarning {
    /// The tip lies within the peg's orbit, so that the peg ran past the wire and bent nothing.
    #[error(
        "bend {}: the peg runs past the end of the wire, of which {out_mm:.1} mm are out and \
         {needed_mm:.1} needed; lengthen the first edge",
        .bend + 1
    )]
    PegPastTip {
        /// Which bend, from 0, in the order in which they were pressed.
        bend: usize,
        /// Wire that was out.
        out_mm: f64,
        /// Wire that the peg would have met.
        needed_mm: f64,
    },
    /// The wire is bent out of the peg's way, so that it ran past and bent nothing.
    #[error(
        "bend {}: the peg runs past the wire, which is bent {straight_mm:.1} mm behind the bend; \
         lengthen the edge",
        .bend + 1
    )]
    PegPastBend {
        /// Which bend, from 0, in the order in which they were pressed.
        bend: usize,
        /// Straight wire that was there.
        straight_mm: f64,
    },
    /// The peg touches the wire beyond its straight part. What is bent there was taken to stay as it is.
    #[error(
        "bend {}: the peg meets the wire {contact_mm:.1} mm behind the bend, where only \
         {straight_mm:.1} mm are straight",
        .bend + 1
    )]
    ShortLeg {
        /// Which bend, from 0, in the order in which they were pressed.
        bend: usize,
        /// Distance of the peg's contact from the end of the arc.
        contact_mm: f64,
        /// Straight wire that was there.
        straight_mm: f64,
    },
    /// The arc took wire that was bent before. What it took has the new bend only.
    #[error("bend {} is pressed over an earlier one", .bend + 1)]
    BendOverBend {
        /// Which bend, from 0, in the order in which they were pressed.
        bend: usize,
    },
    /// The peg pushed the wire further round than a fold back; 180 degrees were taken.
    #[error("bend {} is pushed further round than a fold back", .bend + 1)]
    PastFoldBack {
        /// Which bend, from 0, in the order in which they were pressed.
        bend: usize,
    },
}
