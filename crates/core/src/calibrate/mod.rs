//! Calibration: a machine and a wire as they are, from bends, sides and turns that were measured.
//!
//! [`Coupon`]s are bent, [`Measurements`] read of them, and [`calibrate`] finds the springback, the dimensions of the
//! bend head, the wire in a bend, the scale of the feed and what turns are off by, with the same models that
//! [`crate::compensate`] compensates with. What was known before counts as much as it is known: a parameter that no
//! reading tells stays near what it was, and the result says which those are; [`settled`] leaves them as they were, for
//! profiles. Readings that do not fit the others are named and left out.

mod assumed;
mod bends;
mod coupon;
mod estimate;
mod feeds;
mod figure;
mod fitting;
mod least_squares;
mod measured;
mod screen;
mod settled;
mod springback;
mod statistics;
mod turns;
mod wild;

use crate::compensate::PegGeometryError;
use crate::units::Angle;
use bends::KnownBends;

pub use assumed::{Assumed, KnownLength, KnownPeg};
pub use bends::{BendFit, FittedPeg};
pub use coupon::{Coupon, CouponPlan, Measured};
pub use estimate::{Estimate, Fit, Misfit, Parameter, Residual};
pub use feeds::FeedFit;
pub use figure::{Figure, ReadingPlace};
pub use measured::{
    AngleSample, Gap, Kind, LeftOut, LeftOutReason, LengthSample, Measurements, OtherUnit, TurnSample,
};
pub use settled::settled;
pub use springback::{ShapeChoice, SpringbackShape};
pub use turns::TurnFit;

/// Why there is no calibration.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum CalibrationError {
    /// Not one reading can be fitted.
    #[error("none of {given} readings can be fitted")]
    NoReadings {
        /// How many readings there are.
        given: usize,
        /// Why they are left out, where that is the same for all.
        reason: Option<LeftOutReason>,
    },
    /// The figures of before are not those of a machine.
    #[error(transparent)]
    Geometry(#[from] PegGeometryError),
    /// The search did not end.
    #[error("the readings of {kind:?} fit no machine")]
    NoSolution {
        /// Of which kind.
        kind: Kind,
    },
}

/// What measurements tell of a machine and a wire.
#[derive(Debug, Clone, PartialEq)]
pub struct Calibration {
    /// Springback and bend head.
    pub bends: Option<BendFit>,
    /// Feed and wire in a bend.
    pub feeds: Option<FeedFit>,
    /// Turns of the head.
    pub turns: Option<TurnFit>,
    /// Readings that were left out.
    pub left_out: Vec<LeftOut>,
    /// What is not determined.
    pub gaps: Vec<Gap>,
}

/// Fits all that was measured; what was not measured stays as it was.
///
/// # Errors
/// [`CalibrationError`] when nothing can be fitted.
pub fn calibrate(
    assumed: &Assumed,
    measured: &Measurements,
    choice: ShapeChoice,
) -> Result<Calibration, CalibrationError> {
    calibrate_holding(assumed, measured, choice, &[])
}

/// The same with some parameters held at what they were.
fn calibrate_holding(
    assumed: &Assumed,
    measured: &Measurements,
    choice: ShapeChoice,
    held: &[Parameter],
) -> Result<Calibration, CalibrationError> {
    let beside: Vec<Angle> =
        measured.lengths.iter().flat_map(|sample| [sample.axis_before, sample.axis_after]).collect();
    let bends = bends::fit(assumed, &measured.angles, choice, (&beside, held))?;
    let known = match &bends.fit {
        Some(fit) => KnownBends {
            model: fit.model(assumed.axis_limit),
            radius: fit.bend_radius,
            deviation_deg: fit.deviation_beside_deg,
        },
        None => bends::believed(assumed, &beside)?,
    };
    let feeds = feeds::fit(assumed, &measured.lengths, &known, held)?;
    let turns = turns::fit(assumed, &measured.turns, held)?;
    if bends.fit.is_none() && feeds.fit.is_none() && turns.fit.is_none() {
        let given = |gap: &Gap| if let Gap::NoReadings { given, .. } = gap { *given } else { 0 };
        let all = [&bends.gaps, &feeds.gaps, &turns.gaps];
        let left_out = || [&bends.left_out, &feeds.left_out, &turns.left_out].into_iter().flatten();
        let first = left_out().next().map(|left| left.reason);
        return Err(CalibrationError::NoReadings {
            given: all.into_iter().flatten().map(given).sum(),
            reason: first.filter(|first| left_out().all(|left| left.reason == *first)),
        });
    }
    Ok(Calibration {
        bends: bends.fit,
        feeds: feeds.fit,
        turns: turns.fit,
        left_out: [bends.left_out, feeds.left_out, turns.left_out].concat(),
        gaps: [bends.gaps, feeds.gaps, turns.gaps].concat(),
    })
}

#[cfg(test)]
mod tests;
