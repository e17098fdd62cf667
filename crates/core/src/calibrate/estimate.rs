//! What was found, with how well it is known.

use super::figure::{Figure, ReadingPlace};
use crate::units::Angle;

/// What a calibration tells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Parameter {
    /// What every bend loses.
    Springback,
    /// What a bend loses that stays at an angle, signed as the bend.
    SpringbackAt(Angle),
    /// What every bend loses more than by the curve of before.
    SpringbackShift,
    /// Radius R of the peg's orbit.
    OrbitRadius,
    /// Offset s of the orbit's centre.
    OrbitOffset,
    /// Centreline radius of a bend: effective radius of the pin.
    BendRadius,
    /// Effective radius of the peg, from its centre to the wire's.
    PegRadius,
    /// Depth of the neutral fibre in a bend, in diameters.
    KFactor,
    /// Wire that comes out for a commanded millimetre.
    FeedScale,
    /// What every turn of the head is off by.
    RotationOffset,
    /// What a turn loses that goes against the one before.
    RotationBacklash,
}

/// A parameter as it was found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// What it is.
    pub parameter: Parameter,
    /// What it was taken to be before.
    pub before: Figure,
    /// What it is found to be.
    pub value: Figure,
    /// With 95 % it is within this of the value.
    pub within_95: Figure,
    /// The same as it was known before. A calibration that comes after this one begins with that again: what is found of several
    /// parameters is off together, so that none of them is known by itself as well as all of them are.
    pub within_95_before: Figure,
    /// How much of what is known of it these readings tell, from 0 (all of it was known before) to 1. Below one half they do not determine it.
    pub determined: f64,
}

impl Estimate {
    /// Whether the readings tell more of it than was known before.
    #[must_use]
    pub fn is_identified(&self) -> bool {
        self.determined >= 0.5
    }

    /// Whether it was left exactly as it was, since the readings do not determine it.
    #[must_use]
    pub fn is_left(&self) -> bool {
        !self.is_identified() && self.value == self.before
    }
}

/// How far the readings of a kind are from what a model predicts, in mm or degrees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Misfit {
    /// Mean distance.
    pub mean_abs: f64,
    /// Root of the mean square.
    pub rms: f64,
}

impl Misfit {
    pub(super) fn of(errors: &[f64]) -> Self {
        let n = super::statistics::count(errors.len().max(1));
        Self {
            mean_abs: errors.iter().map(|error| error.abs()).sum::<f64>() / n,
            rms: (errors.iter().map(|error| error * error).sum::<f64>() / n).sqrt(),
        }
    }
}

/// A reading beside what the fitted model makes of its command.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Residual {
    /// Where it stands.
    pub place: ReadingPlace,
    /// What was commanded: position of the axis, feed or turn.
    pub commanded: Figure,
    /// What was read.
    pub reading: Figure,
    /// What the fitted model says.
    pub fitted: Figure,
}

/// How readings of a kind were fitted.
#[derive(Debug, Clone, PartialEq)]
pub struct Fit {
    /// The parameters.
    pub estimates: Vec<Estimate>,
    /// How many independent combinations of them the readings tell; the others are what was known before.
    pub rank: usize,
    /// How many readings it is from.
    pub readings: usize,
    /// Standard deviation of a reading about the model.
    pub scatter: Figure,
    /// With the figures of before.
    pub before: Misfit,
    /// With those that were found.
    pub after: Misfit,
    /// With those that would be found without the sample that is predicted.
    pub leave_one_out: Misfit,
    /// Each reading.
    pub residuals: Vec<Residual>,
}
