//! From readings and a model to estimates: what the fits of all kinds share.

use super::estimate::{Estimate, Fit, Misfit, Parameter, Residual};
use super::figure::Figure;
use super::least_squares::{BELIEVED, Belief, NoSolution, Predict, Problem, Solution};
use super::measured::{Kind, LeftOut, LeftOutReason};
use super::screen::Screened;
use super::wild::find_wild;
use crate::units::{Angle, Length};

/// How parameters of a kind of readings are searched.
pub(super) struct Search<'a> {
    /// What each parameter is, and what was believed of it.
    pub parameters: Vec<(Parameter, Belief)>,
    /// What else is not known and not stated either; after the parameters.
    pub unstated: Vec<Belief>,
    pub predict: &'a Predict<'a>,
    /// Scatter of a reading as long as nothing tells it, in mm or degrees.
    pub reading: f64,
}

/// The least scatter as a part of what a reading resolves: an even spread over one division has 0.29 of it.
const LEAST_SCATTER: f64 = 0.29;

/// What is held is believed so many times as closely as it is known.
const HELD: f64 = 1e-4;

/// Beliefs of which some are held at what they were.
pub(super) fn hold(mut parameters: Vec<(Parameter, Belief)>, held: &[Parameter]) -> Vec<(Parameter, Belief)> {
    for (parameter, belief) in &mut parameters {
        if held.contains(parameter) {
            belief.sd *= HELD;
        }
    }
    parameters
}

impl Search<'_> {
    pub fn problem(&self, screened: &Screened) -> Problem<'_> {
        Problem {
            beliefs: self.parameters.iter().map(|(_, belief)| *belief).chain(self.unstated.clone()).collect(),
            predict: self.predict,
            data: screened.data.clone(),
            first_scatter: self.reading,
            least_scatter: LEAST_SCATTER * self.reading,
        }
    }

    /// Takes the wild readings out of `screened`.
    pub fn take_out_wild(&self, kind: Kind, screened: &mut Screened) -> Result<(), NoSolution> {
        let mut problem = self.problem(screened);
        let wild = find_wild(&mut problem)?;
        for wild in wild.iter().rev() {
            let datum = screened.data.remove(wild.datum);
            screened.left_out.push(LeftOut {
                kind,
                place: screened.places.remove(wild.datum),
                reading: figure(kind, datum.value),
                expected: figure(kind, wild.expected),
                reason: LeftOutReason::DoesNotFit,
            });
        }
        screened.left_out.sort_by_key(|left| left.place);
        Ok(())
    }

    /// Fits all readings that are left. `commanded` is what was commanded for a sample of `screened`, `before` what the figures
    /// of before make of it.
    pub fn fit(
        &self,
        kind: Kind,
        screened: &Screened,
        commanded: &dyn Fn(usize) -> Figure,
        before: &[f64],
    ) -> Result<(Fit, Solution), NoSolution> {
        let problem = self.problem(screened);
        let solution = problem.solve(None)?;
        let estimate = |(k, (parameter, belief)): (usize, &(Parameter, Belief))| Estimate {
            parameter: *parameter,
            before: parameter.figure(belief.value),
            value: parameter.figure(solution.parameters[k]),
            within_95: parameter.figure(solution.parameter_within_95(k, belief.sd)),
            within_95_before: parameter.figure(BELIEVED * belief.sd),
            determined: solution.determined(k),
        };
        let off = |from: &[f64]| -> Vec<f64> {
            screened.data.iter().map(|datum| datum.value - from[datum.sample]).collect()
        };
        let residuals = screened.data.iter().zip(&screened.places).map(|(datum, place)| Residual {
            place: *place,
            commanded: commanded(datum.sample),
            reading: figure(kind, datum.value),
            fitted: figure(kind, solution.predicted[datum.sample]),
        });
        let fit = Fit {
            estimates: self.parameters.iter().enumerate().map(estimate).collect(),
            rank: solution.rank(self.parameters.len()),
            readings: screened.data.len(),
            scatter: figure(kind, solution.scatter),
            before: Misfit::of(&off(before)),
            after: Misfit::of(&off(&solution.predicted)),
            leave_one_out: Misfit::of(&solution.left_out(&screened.data)),
            residuals: residuals.collect(),
        };
        Ok((fit, solution))
    }
}

/// A reading of a kind from millimetres or degrees.
pub(super) fn figure(kind: Kind, value: f64) -> Figure {
    match kind {
        Kind::Bends | Kind::Turns => Figure::Angle(Angle::computed(value.to_radians())),
        Kind::Feeds => Figure::Length(Length::computed(value)),
    }
}

impl Parameter {
    /// Its value from millimetres, degrees or a ratio.
    pub(super) fn figure(self, value: f64) -> Figure {
        match self {
            Self::Springback
            | Self::SpringbackAt(_)
            | Self::SpringbackShift
            | Self::RotationOffset
            | Self::RotationBacklash => Figure::Angle(Angle::computed(value.to_radians())),
            Self::OrbitRadius | Self::OrbitOffset | Self::BendRadius | Self::PegRadius => {
                Figure::Length(Length::computed(value))
            }
            Self::KFactor | Self::FeedScale => Figure::Ratio(value),
        }
    }
}
