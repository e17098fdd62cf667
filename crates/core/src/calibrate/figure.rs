//! Figures in the unit of their type, and where a reading stands.

use crate::units::{Angle, Length};

/// A figure of a machine or a wire, in the unit of its type.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Figure {
    /// A length.
    Length(Length),
    /// An angle.
    Angle(Angle),
    /// A ratio.
    Ratio(f64),
}

impl Figure {
    /// Millimetres, degrees or the ratio.
    #[must_use]
    pub fn plain(self) -> f64 {
        match self {
            Self::Length(length) => length.mm(),
            Self::Angle(angle) => angle.deg(),
            Self::Ratio(ratio) => ratio,
        }
    }
}

/// Where a reading stands: which sample of its kind, and which of its repeats, both from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct ReadingPlace {
    /// The sample.
    pub sample: usize,
    /// The repeat.
    pub repeat: usize,
}
