//! What turns of the head are off by, and the backlash of the head.

use super::CalibrationError;
use super::assumed::Assumed;
use super::bends::Outcome;
use super::estimate::{Fit, Parameter};
use super::figure::Figure;
use super::fitting::{Search, hold};
use super::least_squares::Belief;
use super::measured::{Gap, Kind, TurnSample};
use super::screen::{screen, turn};
use crate::units::Angle;

/// How far off a turn, and how large a backlash may be, in degrees.
const DEVIATION_DEG: f64 = 5.0;

/// What turns tell.
#[derive(Debug, Clone, PartialEq)]
pub struct TurnFit {
    /// The parameters and how well they fit.
    pub fit: Fit,
    /// What every turn is off by, degrees.
    pub offset_deg: f64,
    /// What a turn loses that goes against the one before, degrees.
    pub backlash_deg: f64,
}

pub(super) fn fit(
    assumed: &Assumed,
    samples: &[TurnSample],
    held: &[Parameter],
) -> Result<Outcome<TurnFit>, CalibrationError> {
    let readings: Vec<_> = samples.iter().map(|sample| sample.readings.as_slice()).collect();
    let made = |sample: &TurnSample, offset: f64, backlash: f64| {
        let lost = if sample.reverses { sample.rotate.signum() * backlash } else { 0.0 };
        sample.rotate.deg() + offset - lost
    };
    let known = assumed.motion;
    let [offset, backlash] = [known.rotate_offset.deg(), known.rotate_backlash.deg()];
    let before = |sample: &TurnSample| Angle::computed(made(sample, offset, backlash).to_radians());
    let expected = |k: usize| Figure::Angle(before(&samples[k]));
    let mut screened = screen(Kind::Turns, &readings, Figure::Angle, expected, |k, reading| {
        turn(samples[k].rotate, before(&samples[k]), reading)
    });
    let given = screened.given;
    if screened.data.is_empty() {
        let gaps = vec![Gap::NoReadings { kind: Kind::Turns, given }];
        return Ok(Outcome { fit: None, left_out: screened.left_out, gaps });
    }
    let used: Vec<&TurnSample> = screened.samples.iter().map(|&k| &samples[k]).collect();
    let predict = |parameters: &[f64]| {
        let &[offset, backlash] = parameters else { return Vec::new() };
        used.iter().map(|sample| made(sample, offset, backlash)).collect()
    };
    let belief = |value| Belief { value, sd: DEVIATION_DEG };
    let believed =
        vec![(Parameter::RotationOffset, belief(offset)), (Parameter::RotationBacklash, belief(backlash))];
    let search = Search {
        parameters: hold(believed, held),
        unstated: Vec::new(),
        predict: &predict,
        reading: assumed.angle_reading.deg(),
    };
    let no_solution = |_| CalibrationError::NoSolution { kind: Kind::Turns };
    search.take_out_wild(Kind::Turns, &mut screened).map_err(no_solution)?;
    let commanded = |k: usize| Figure::Angle(used[k].rotate);
    let before: Vec<f64> = used.iter().map(|sample| before(sample).deg()).collect();
    let (fit, solution) = search.fit(Kind::Turns, &screened, &commanded, &before).map_err(no_solution)?;
    let reverses = screened.data.iter().any(|datum| used[datum.sample].reverses);
    let fit = solution.parameters.first_chunk::<2>().map(|&[offset_deg, backlash_deg]| TurnFit {
        fit,
        offset_deg,
        backlash_deg,
    });
    let gaps = if reverses { Vec::new() } else { vec![Gap::NoReversal] };
    Ok(Outcome { fit, left_out: screened.left_out, gaps })
}
