//! Where the axes stand that every wire counts from.

use wirebend_driver_api::Axis;

use super::{ROUNDING_DEG, SessionError};

/// How far the head and the bend axis are from where a wire has to start, degrees, in the machine's signs.
///
/// A program counts from there: the head has its turns up to the limits of its cables, and the bend axis
/// its reach to both sides. The wire itself may be fed by hand.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct AxisOffsets {
    rotate_deg: f64,
    bend_deg: f64,
}

impl AxisOffsets {
    pub fn turned(&mut self, axis: Axis, by: f64) {
        match axis {
            Axis::Feed => {}
            Axis::Rotate => self.rotate_deg += by,
            Axis::Bend => self.bend_deg += by,
        }
    }

    /// The head of a wire that is resumed, which need not be where a wire starts.
    pub fn head_stands_at(&mut self, rotate_deg: f64) {
        self.rotate_deg = rotate_deg;
    }

    pub const fn rotate_deg(&self) -> f64 {
        self.rotate_deg
    }

    pub fn require_zero(&self) -> Result<(), SessionError> {
        let Self { rotate_deg, bend_deg } = *self;
        if rotate_deg.abs() < ROUNDING_DEG && bend_deg.abs() < ROUNDING_DEG {
            return Ok(());
        }
        Err(SessionError::OffZero { rotate_deg, bend_deg })
    }
}
