//! A step as a machine is told it: to which side it bends, where the sign of its bend axis does not say so.

use crate::bend::Step;
use crate::units::Angle;

/// An axis that stops less than this beyond zero may be told as zero, degrees: no axis is so fine.
const AT_ZERO_DEG: f64 = 0.1;

/// A step as a machine is told it: its bend is where the bend axis goes. A small bend of soft wire, or one on wire that is bent
/// already, ends before zero, on the side from which the peg comes: there the sign of the axis is not the side of the bend.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ToldStep {
    /// Feed, rotate, and where the bend axis goes.
    pub step: Step,
    /// Where the bend axis stands when the peg comes out: on the side from which it bends. Given at least where the axis stops at
    /// zero or before it; without it the side of the bend is its sign.
    pub approach: Option<Angle>,
}

impl ToldStep {
    /// To which side it bends: 1 or -1; 0 where it does not bend.
    #[must_use]
    pub fn side(&self) -> f64 {
        self.approach.map_or(self.step.bend.signum(), |at| -at.signum())
    }

    /// Whether it bends. Its axis may stop at zero then.
    #[must_use]
    pub fn bends(&self) -> bool {
        self.side() != 0.0
    }

    /// How far beyond zero the axis goes to the side of the bend, radians; below zero where it stops before.
    #[must_use]
    pub fn beyond_zero(&self) -> f64 {
        self.side() * self.step.bend.rad()
    }

    /// Whether the sign of the axis does not say to which side it bends, or is lost where angles are rounded.
    #[must_use]
    pub fn needs_side(&self) -> bool {
        self.bends() && self.beyond_zero() < AT_ZERO_DEG.to_radians()
    }

    /// The same, with the place of the peg only where it tells the side.
    pub(super) fn short(self) -> Self {
        Self { approach: self.approach.filter(|_| self.needs_side()), ..self }
    }
}

impl From<Step> for ToldStep {
    fn from(step: Step) -> Self {
        Self { step, approach: None }
    }
}
