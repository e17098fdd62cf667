//! A complete machine's figures without their sources: what the stages of the pipeline take.

use serde::{Deserialize, Serialize};

use crate::figures::{Complete, v};
use crate::machine::{BendMethod, Compensation, MachineProfile};
use crate::sourced::Sourced;

/// Figures of a complete machine. Units as in the names; signs canonical.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MachineFigures {
    /// Thinnest wire, millimetres.
    pub min_diameter_mm: f64,
    /// Thickest wire, millimetres.
    pub max_diameter_mm: f64,
    /// What may be asked of the machine.
    pub limits: LimitFigures,
    /// Speed of the feed axis, millimetres a second.
    pub feed_rate_mm_per_s: f64,
    /// Smallest feed step, millimetres.
    pub feed_resolution_mm: f64,
    /// Wire for each commanded millimetre.
    #[serde(default = "one")]
    pub feed_scale: f64,
    /// Speed of the rotate axis, degrees a second.
    pub rotate_rate_deg_per_s: f64,
    /// Smallest rotate step, degrees.
    pub rotate_resolution_deg: f64,
    /// What every turn of the head is off by, degrees.
    #[serde(default)]
    pub rotate_offset_deg: f64,
    /// What a turn loses that goes against the one before, degrees.
    #[serde(default)]
    pub rotate_backlash_deg: f64,
    /// Speed of the bend axis, degrees a second.
    pub bend_rate_deg_per_s: f64,
    /// Smallest bend step, degrees.
    pub bend_resolution_deg: f64,
    /// Radius of the pin that the wire wraps, millimetres.
    pub pin_radius_mm: f64,
    /// How the bend axis makes an angle.
    pub bend: BendFigures,
    /// Whether feeds are shortened for the arcs of the bends.
    pub compensate_feed: bool,
    /// Whether the peg's setback is compensated.
    pub compensate_setback: bool,
    /// Whether springback is compensated.
    pub compensate_springback: bool,
    /// 1 or -1: bend of the machine over canonical bend.
    pub bend_sign: f64,
    /// 1 or -1: rotation of the machine over canonical rotation.
    pub rotate_sign: f64,
    /// Time of a bend beside its stroke, seconds.
    pub fixed_per_bend_s: f64,
    /// Time of a feed beside its motion, seconds.
    pub fixed_per_feed_s: f64,
    /// Time of a turn of the head beside its motion, seconds.
    pub fixed_per_turn_s: f64,
}

const fn one() -> f64 {
    1.0
}

/// What may be asked of a machine.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct LimitFigures {
    /// Most negative formed angle, degrees.
    pub min_bend_deg: f64,
    /// Most positive formed angle, degrees.
    pub max_bend_deg: f64,
    /// Shortest designed edge, millimetres.
    pub min_edge_mm: f64,
    /// Shortest feed, millimetres.
    pub min_feed_mm: f64,
    /// Longest single feed, millimetres; `None`: no limit.
    #[serde(default)]
    pub max_feed_mm: Option<f64>,
    /// Longest stock, millimetres; `None`: no limit.
    pub max_stock_mm: Option<f64>,
    /// End of the stock that cannot be fed, millimetres.
    pub tail_mm: f64,
    /// Lowest absolute head angle, degrees.
    pub min_rotation_deg: f64,
    /// Highest absolute head angle, degrees.
    pub max_rotation_deg: f64,
}

/// How a complete machine's bend axis makes an angle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "method", rename_all = "kebab-case")]
pub enum BendFigures {
    /// A peg orbits off the pin's centre.
    Peg {
        /// Radius of the rod that pushes the wire, millimetres.
        rod_radius_mm: f64,
        /// Radius R of the peg's orbit, millimetres.
        orbit_radius_mm: f64,
        /// Offset s of the orbit's centre along the wire, millimetres.
        orbit_offset_mm: f64,
        /// Largest axis angle either way, degrees.
        axis_limit_deg: f64,
        /// Whether it is told to which side it bends, so that its axis may stop at zero or before it.
        #[serde(default)]
        before_zero: bool,
    },
    /// The axis angle is the bend angle.
    Direct {
        /// Largest axis angle either way, degrees; `None`: only the formed angle is limited.
        axis_limit_deg: Option<f64>,
    },
}

impl Complete for MachineProfile {
    type Figures = MachineFigures;

    fn complete(&self) -> Option<MachineFigures> {
        let Compensation { feed, setback, springback } = &self.compensation;
        Some(MachineFigures {
            min_diameter_mm: v(&self.wire.min_diameter_mm)?,
            max_diameter_mm: v(&self.wire.max_diameter_mm)?,
            limits: self.limit_figures()?,
            feed_rate_mm_per_s: v(&self.feed.rate_mm_per_s)?,
            feed_resolution_mm: v(&self.feed.resolution_mm)?,
            feed_scale: v(&self.feed.scale).unwrap_or_else(one),
            rotate_rate_deg_per_s: v(&self.rotate.rate_deg_per_s)?,
            rotate_resolution_deg: v(&self.rotate.resolution_deg)?,
            rotate_offset_deg: v(&self.rotate.offset_deg).unwrap_or_default(),
            rotate_backlash_deg: v(&self.rotate.backlash_deg).unwrap_or_default(),
            bend_rate_deg_per_s: v(&self.bend.rate_deg_per_s)?,
            bend_resolution_deg: v(&self.bend.resolution_deg)?,
            pin_radius_mm: v(&self.bend.pin_radius_mm)?,
            bend: self.bend_figures()?,
            compensate_feed: **feed.as_ref()?,
            compensate_setback: **setback.as_ref()?,
            compensate_springback: **springback.as_ref()?,
            bend_sign: self.signs.bend.as_ref()?.factor(),
            rotate_sign: self.signs.rotate.as_ref()?.factor(),
            fixed_per_bend_s: v(&self.time.fixed_per_bend_s)?,
            fixed_per_feed_s: v(&self.time.fixed_per_feed_s).unwrap_or_default(),
            fixed_per_turn_s: v(&self.time.fixed_per_turn_s).unwrap_or_default(),
        })
    }
}

impl MachineProfile {
    /// Whether the orbit of the peg was measured or calibrated on this machine; nothing of one without a peg.
    #[must_use]
    pub fn head_measured(&self) -> Option<bool> {
        let bend = &self.bend;
        let orbit = [&bend.orbit_radius_mm, &bend.orbit_offset_mm];
        let measured = |figure: &Sourced<f64>| figure.measured || figure.within_95.is_some();
        matches!(bend.method.as_ref()?.value, BendMethod::Peg)
            .then(|| orbit.into_iter().flatten().all(measured))
    }

    fn limit_figures(&self) -> Option<LimitFigures> {
        let limits = &self.limits;
        Some(LimitFigures {
            min_bend_deg: v(&limits.min_bend_deg)?,
            max_bend_deg: v(&limits.max_bend_deg)?,
            min_edge_mm: v(&limits.min_edge_mm)?,
            min_feed_mm: v(&limits.min_feed_mm)?,
            max_feed_mm: v(&limits.max_feed_mm),
            max_stock_mm: v(&limits.max_stock_mm),
            tail_mm: v(&limits.tail_mm)?,
            min_rotation_deg: v(&limits.min_rotation_deg)?,
            max_rotation_deg: v(&limits.max_rotation_deg)?,
        })
    }

    fn bend_figures(&self) -> Option<BendFigures> {
        let bend = &self.bend;
        Some(match bend.method.as_ref()?.value {
            BendMethod::Peg => BendFigures::Peg {
                rod_radius_mm: v(&bend.rod_radius_mm)?,
                orbit_radius_mm: v(&bend.orbit_radius_mm)?,
                orbit_offset_mm: v(&bend.orbit_offset_mm)?,
                axis_limit_deg: v(&bend.axis_limit_deg)?,
                before_zero: bend.before_zero.as_ref().is_some_and(|told| told.value),
            },
            BendMethod::Direct => BendFigures::Direct { axis_limit_deg: v(&bend.axis_limit_deg) },
        })
    }
}
