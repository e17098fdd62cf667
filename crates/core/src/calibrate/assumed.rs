//! What is known of a machine and a wire before anything is measured.

use crate::compensate::{BendModel, MotionModel, PegGeometry, PegGeometryError, Springback};
use crate::units::{Angle, Length};

/// A length that is known to within a deviation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KnownLength {
    /// The value.
    pub value: Length,
    /// Standard deviation: how far off it may be. Taken as at least a micrometre.
    pub deviation: Length,
}

/// The dimensions of a bend head with a peg.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KnownPeg {
    /// Radius R of the orbit.
    pub orbit_radius: KnownLength,
    /// Offset s of its centre.
    pub orbit_offset: KnownLength,
    /// Effective radius of the peg: rod and half the wire.
    pub peg_radius: KnownLength,
}

/// A machine and a wire as their profiles have them, and how far off these may be.
#[derive(Debug, Clone, PartialEq)]
pub struct Assumed {
    /// The peg; none where the axis is the bend.
    pub peg: Option<KnownPeg>,
    /// Centreline radius of a bend.
    pub bend_radius: KnownLength,
    /// What the wire loses; none where the machine sees to it itself.
    pub springback: Option<Springback>,
    /// How far the bend axis goes.
    pub axis_limit: Option<Angle>,
    /// Diameter of the wire.
    pub diameter: Length,
    /// Depth of the neutral fibre, in diameters.
    pub k_factor: f64,
    /// How far off that may be.
    pub k_deviation: f64,
    /// Whether feeds are commanded with the wire of bends deducted; where the machine sees to it itself, a side is what is fed.
    pub deducts_bends: bool,
    /// What feed and head make of what they are told.
    pub motion: MotionModel,
    /// How finely bends and turns are read: their scatter as long as nothing tells it.
    pub angle_reading: Angle,
    /// How finely lengths are read.
    pub length_reading: Length,
}

/// The dimensions of a peg as plain figures in mm: orbit radius, offset, bend radius, peg radius.
pub(super) type PegDimensions = [f64; 4];

impl Assumed {
    /// The model that compensates with these figures.
    ///
    /// # Errors
    /// [`PegGeometryError`] where the dimensions are not those of a peg bender.
    pub fn bend_model(&self) -> Result<BendModel, PegGeometryError> {
        let setback = self.peg.as_ref().map(|peg| {
            let [orbit, offset, pin, reach] =
                [peg.orbit_radius, peg.orbit_offset, self.bend_radius, peg.peg_radius]
                    .map(|known| known.value);
            PegGeometry::new(orbit, offset, pin, reach)
        });
        Ok(BendModel {
            springback: self.springback.clone(),
            setback: setback.transpose()?,
            axis_limit: self.axis_limit,
            before_zero: false,
        })
    }
}

/// The model that leaves bends by these figures. A search may try dimensions that cannot be: the nearest that can are
/// taken, and the belief in the figures brings it back.
pub(super) fn bend_model(peg: Option<PegDimensions>, springback: Springback) -> BendModel {
    let setback = peg.and_then(|[orbit, offset, pin, reach]| {
        let orbit = orbit.max(0.1);
        let reach = reach.clamp(0.01, 0.95 * orbit);
        let [orbit, offset, pin, reach] =
            [orbit, offset.max(-0.3 * orbit), pin.max(0.01), reach].map(Length::computed);
        PegGeometry::new(orbit, offset, pin, reach).ok()
    });
    BendModel { springback: Some(springback), setback, axis_limit: None, before_zero: false }
}
