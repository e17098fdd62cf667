//! Weighted least squares with what was believed before: parameters start at a value that is right to within a
//! deviation, and readings pull them away from it.
//!
//! A parameter is counted in its own deviations from what was believed, so that the belief is one more residual for
//! each and the problem has a solution whatever is measured.
//!
//! Levenberg and Marquardt's method is that of MINPACK, by `rmpfit`: CMPFIT in Rust alone. It wants no derivatives, which a chain of tangencies, a
//! monotone curve and clamps do not have in closed form, depends on nothing, and gives up with an error rather than with a value that is
//! none. It is given residuals only. Covariances, weights, the scatter and what is left out are computed here, from slopes by
//! central differences, since they need the beliefs apart from the readings.

use nalgebra::{DMatrix, DVector};
use rmpfit::{MPConfig, MPError, MPFitter, MPMaxFev, MPResult};

use super::statistics::within;

/// What is believed of a parameter before anything is measured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Belief {
    pub value: f64,
    /// Standard deviation; more than zero.
    pub sd: f64,
}

/// A reading: which of the predicted values it is of, and what it says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Datum {
    pub sample: usize,
    pub value: f64,
    /// How much it counts, from 0 to 1.
    pub weight: f64,
}

/// Values predicted for all samples from parameters.
pub(super) type Predict<'a> = dyn Fn(&[f64]) -> Vec<f64> + 'a;

/// A problem: readings of one kind, in one unit.
pub(super) struct Problem<'a> {
    pub beliefs: Vec<Belief>,
    pub predict: &'a Predict<'a>,
    pub data: Vec<Datum>,
    /// Scatter of a reading as far as nothing tells it.
    pub first_scatter: f64,
    /// Scatter below which no reading is believed to be.
    pub least_scatter: f64,
}

/// Why there is no solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the fit of the readings finds no end")]
pub struct NoSolution;

/// Parameters that fit the readings and the beliefs best.
#[derive(Debug, Clone)]
pub(super) struct Solution {
    pub parameters: Vec<f64>,
    /// Standard deviation of a reading.
    pub scatter: f64,
    /// Degrees of freedom that the scatter is from; infinite where it is what was said of the instrument.
    pub freedom: f64,
    /// Predicted value of each sample.
    pub predicted: Vec<f64>,
    /// Change of each predicted value (row) with each parameter, in deviations of what was believed.
    slopes: DMatrix<f64>,
    /// Covariance of the parameters, in the same.
    covariance: DMatrix<f64>,
}

const CONFIG: MPConfig = MPConfig {
    ftol: 1e-8,
    xtol: 1e-8,
    gtol: 1e-8,
    epsfcn: 1e-10,
    step_factor: 100.0,
    covtol: 1e-14,
    max_iter: 60,
    max_fev: MPMaxFev::Default,
    do_user_scale: false,
    no_finite_check: false,
};

/// Deviations of what was believed within which 95 % lie.
pub(super) const BELIEVED: f64 = 1.96;

/// The step of a numerical derivative, in deviations of what was believed.
const STEP: f64 = 1e-4;

struct Residuals<'a> {
    problem: &'a Problem<'a>,
    scatter: f64,
}

impl MPFitter for Residuals<'_> {
    fn eval(&mut self, scaled: &[f64], out: &mut [f64]) -> MPResult<()> {
        let predicted = (self.problem.predict)(&self.problem.unscaled(scaled));
        let (of_data, of_beliefs) = out.split_at_mut(self.problem.data.len());
        for (out, datum) in of_data.iter_mut().zip(&self.problem.data) {
            let value = predicted.get(datum.sample).ok_or(MPError::Eval)?;
            *out = datum.weight.sqrt() * (datum.value - value) / self.scatter;
        }
        of_beliefs.copy_from_slice(scaled);
        Ok(())
    }

    fn number_of_points(&self) -> usize {
        self.problem.data.len() + self.problem.beliefs.len()
    }

    fn config(&self) -> &MPConfig {
        &CONFIG
    }
}

impl Problem<'_> {
    fn unscaled(&self, scaled: &[f64]) -> Vec<f64> {
        self.beliefs.iter().zip(scaled).map(|(belief, q)| belief.value + q * belief.sd).collect()
    }

    fn scaled(&self, parameters: &[f64]) -> Vec<f64> {
        self.beliefs.iter().zip(parameters).map(|(belief, p)| (p - belief.value) / belief.sd).collect()
    }

    /// Solves it from `start`, or from what was believed, with a scatter that follows from the residuals.
    pub fn solve(&self, start: Option<&Solution>) -> Result<Solution, NoSolution> {
        let mut scaled =
            start.map_or_else(|| vec![0.0; self.beliefs.len()], |from| self.scaled(&from.parameters));
        let mut scatter = start.map_or(self.first_scatter, |from| from.scatter);
        // The scatter weighs beliefs against readings, which moves the solution a little.
        let mut rounds = 3;
        loop {
            let status = Residuals { problem: self, scatter }.mpfit(&mut scaled).map_err(|_| NoSolution)?;
            if !status.best_norm.is_finite() {
                return Err(NoSolution);
            }
            let (predicted, slopes) = self.slopes(&scaled);
            let found = self.judged(&scaled, predicted, slopes, scatter)?;
            rounds -= 1;
            if rounds == 0 || (found.scatter / scatter).ln().abs() < 0.1 {
                return Ok(found);
            }
            scatter = found.scatter;
        }
    }

    /// The solution with the weights that the data have now, by the straight lines about one with others.
    pub fn solve_near(&self, about: &Solution) -> Result<Solution, NoSolution> {
        let from = DVector::from_vec(self.scaled(&about.parameters));
        let square = about.scatter * about.scatter;
        let mut told = DMatrix::identity(from.len(), from.len());
        let mut pull = -&from;
        for datum in self.data.iter().filter(|datum| datum.weight > 0.0) {
            let slope = about.slopes.row(datum.sample);
            let residual = datum.value - about.predicted[datum.sample];
            told += slope.transpose() * slope * (datum.weight / square);
            pull += slope.transpose() * (datum.weight * residual / square);
        }
        let step = told.cholesky().ok_or(NoSolution)?.solve(&pull);
        let predicted = DVector::from_column_slice(&about.predicted) + &about.slopes * &step;
        let scaled = from + step;
        self.judged(scaled.as_slice(), predicted.as_slice().to_vec(), about.slopes.clone(), about.scatter)
    }

    /// How each predicted value (row) changes with each parameter, in deviations of what was believed.
    pub fn slopes_at(&self, parameters: &[f64]) -> DMatrix<f64> {
        self.slopes(&self.scaled(parameters)).1
    }

    /// What is predicted, and how that changes with each parameter.
    fn slopes(&self, scaled: &[f64]) -> (Vec<f64>, DMatrix<f64>) {
        let predicted = (self.predict)(&self.unscaled(scaled));
        let mut slopes = DMatrix::zeros(predicted.len(), scaled.len());
        for k in 0..scaled.len() {
            let at = |step: f64| {
                let mut moved = scaled.to_vec();
                moved[k] += step;
                DVector::from_vec((self.predict)(&self.unscaled(&moved)))
            };
            slopes.set_column(k, &((at(STEP) - at(-STEP)) / (2.0 * STEP)));
        }
        (predicted, slopes)
    }

    /// What the readings say at a solution, with a scatter from its residuals.
    fn judged(
        &self,
        scaled: &[f64],
        predicted: Vec<f64>,
        slopes: DMatrix<f64>,
        scatter: f64,
    ) -> Result<Solution, NoSolution> {
        let mut told = DMatrix::zeros(scaled.len(), scaled.len());
        for datum in self.data.iter().filter(|datum| datum.weight > 0.0) {
            let slope = slopes.row(datum.sample);
            told += slope.transpose() * slope * datum.weight;
        }
        let of = |scatter: f64| {
            let told = &told / (scatter * scatter);
            let all = &told + DMatrix::identity(scaled.len(), scaled.len());
            let covariance = all.cholesky().ok_or(NoSolution)?.inverse();
            let used = (&covariance * told).trace();
            Ok::<_, NoSolution>((covariance, used))
        };
        let (_, used) = of(scatter)?;
        let weights: f64 = self.data.iter().map(|datum| datum.weight).sum();
        let squares: f64 = self
            .data
            .iter()
            .map(|datum| datum.weight * (datum.value - predicted[datum.sample]).powi(2))
            .sum();
        let freedom = weights - used;
        // With hardly a reading more than what it decides the scatter is what was said of the instrument.
        let (scatter, freedom) = match freedom {
            few if few < 1.0 => (self.first_scatter, f64::INFINITY),
            freedom => ((squares / freedom).sqrt(), freedom),
        };
        let scatter = scatter.max(self.least_scatter);
        let (covariance, _) = of(scatter)?;
        let parameters = self.unscaled(scaled);
        Ok(Solution { parameters, scatter, freedom, predicted, slopes, covariance })
    }
}

impl Solution {
    /// Standard deviation of a parameter that was believed with `sd`.
    pub fn deviation(&self, parameter: usize, sd: f64) -> f64 {
        self.covariance[(parameter, parameter)].max(0.0).sqrt() * sd
    }

    /// Within how much of its value a sum of parameters lies with 95 %. `weights` has a weight for each, in deviations of what was
    /// believed.
    ///
    /// What comes from the beliefs has a deviation that was said, what comes from the readings one that they tell themselves, and the
    /// fewer they are the worse: the factor is Student's for the effective degrees of freedom of Welch and Satterthwaite (GUM, JCGM
    /// 100:2008, G.4).
    pub fn within_95(&self, weights: &DVector<f64>) -> f64 {
        let pull = &self.covariance * weights;
        let (all, believed) = (weights.dot(&pull).max(0.0), pull.norm_squared());
        let read = (all - believed).max(0.0);
        let freedom = if read > 0.0 { self.freedom * (all / read).powi(2) } else { f64::INFINITY };
        // What was believed is an interval by itself, which readings do not widen, however few they are.
        (within(0.95, freedom) * all.sqrt()).min(BELIEVED * weights.norm())
    }

    /// The same of a parameter that was believed with `sd`.
    pub fn parameter_within_95(&self, parameter: usize, sd: f64) -> f64 {
        let mut weights = DVector::zeros(self.parameters.len());
        weights[parameter] = sd;
        self.within_95(&weights)
    }

    /// How much of what is known of a parameter the readings tell, from 0 (nothing) to 1.
    pub fn determined(&self, parameter: usize) -> f64 {
        (1.0 - self.covariance[(parameter, parameter)]).clamp(0.0, 1.0)
    }

    /// Of how many independent combinations of the first `stated` parameters the readings tell more than was believed.
    pub fn rank(&self, stated: usize) -> usize {
        // Below 1/2 a variance has more from the readings than from the belief.
        let of_stated = self.covariance.view((0, 0), (stated, stated)).into_owned();
        of_stated.symmetric_eigenvalues().iter().filter(|variance| **variance < 0.5).count()
    }

    /// Standard deviation of the predicted value of a sample.
    pub fn deviation_of_prediction(&self, sample: usize) -> f64 {
        self.deviation_along(&self.slopes.row(sample).transpose())
    }

    /// Standard deviation of what changes so much with each parameter, in deviations of what was believed.
    pub fn deviation_along(&self, slope: &DVector<f64>) -> f64 {
        slope.dot(&(&self.covariance * slope)).max(0.0).sqrt()
    }

    /// By how much each reading would be off if the fit had not seen its sample: the residuals of leave-one-out, by
    /// the linear fit about the solution. Repeats are left out together, since one would tell of the other.
    pub fn left_out(&self, data: &[Datum]) -> Vec<f64> {
        let residual = |datum: &Datum| datum.value - self.predicted[datum.sample];
        data.iter()
            .map(|datum| {
                let same = data.iter().filter(|other| other.sample == datum.sample && other.weight > 0.0);
                let (count, sum) =
                    same.fold((0.0, 0.0), |(count, sum), other| (count + 1.0, sum + residual(other)));
                let variance = self.deviation_of_prediction(datum.sample).powi(2);
                let lever = (variance / self.scatter.powi(2)).min(0.999 / f64::max(count, 1.0));
                residual(datum) + lever * sum / (1.0 - count * lever)
            })
            .collect()
    }
}
