//! Readings that do not belong to the others: typing errors, a wire read twice, a bend that slipped.
//!
//! First a fit that large residuals cannot pull (Huber's weights, then Tukey's). What lies far from it is set aside, and
//! comes back one reading after the other, nearest first, as long as it lies where the fit of those that are in expects
//! it (Hadi and Simonoff, "Procedures for the identification of multiple outliers in linear models", JASA 88, 1993).

use super::least_squares::{Datum, NoSolution, Problem, Solution};
use super::statistics::{count, median, robust_deviation, within};

/// The chance that a table without any wild reading has one accused.
const FALSE_ALARM: f64 = 0.01;
/// What lies further than so many deviations from the robust fit has to prove that it belongs.
const SET_ASIDE: f64 = 3.0;
/// Tuning of the weights for 95 % efficiency with normal errors.
const HUBER: f64 = 1.345;
const TUKEY: f64 = 4.685;

/// A reading that does not belong to the others.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Wild {
    /// Which of the data.
    pub datum: usize,
    /// What the others say that it should be.
    pub expected: f64,
}

/// Finds the wild readings of a problem: in its data their weights are then zero, all others one.
pub(super) fn find_wild(problem: &mut Problem) -> Result<Vec<Wild>, NoSolution> {
    let mut solution = robust(problem)?;
    let off = |problem: &Problem, solution: &Solution, k: usize| {
        (problem.data[k].value - solution.predicted[problem.data[k].sample]).abs()
    };
    let all = 0..problem.data.len();
    let scatter = robust_deviation(all.clone().map(|k| off(problem, &solution, k)));
    let limit = SET_ASIDE * scatter.max(problem.least_scatter);
    for k in all.clone() {
        let weight = if off(problem, &solution, k) > limit { 0.0 } else { 1.0 };
        problem.data[k].weight = weight;
    }
    loop {
        solution = problem.solve_near(&solution)?;
        let t = |k: usize| {
            let spread = solution.deviation_of_prediction(problem.data[k].sample).hypot(solution.scatter);
            off(problem, &solution, k) / spread
        };
        let outside = all.clone().filter(|&k| problem.data[k].weight == 0.0);
        let Some(next) = outside.min_by(|&a, &b| t(a).total_cmp(&t(b))) else { break };
        let allowed = within(1.0 - FALSE_ALARM / count(problem.data.len()), solution.freedom);
        if t(next) > allowed {
            break;
        }
        problem.data[next].weight = 1.0;
    }
    for k in all.clone() {
        if is_repeated(problem, k) {
            problem.data[k].weight = 1.0;
        }
    }
    let wild = all.filter(|&k| problem.data[k].weight == 0.0);
    Ok(wild.map(|k| Wild { datum: k, expected: solution.predicted[problem.data[k].sample] }).collect())
}

/// Whether another reading of the same sample says the same: then it is no slip, and the machine does something that no parameter
/// tells.
fn is_repeated(problem: &Problem, k: usize) -> bool {
    let datum = &problem.data[k];
    let near = SET_ASIDE * std::f64::consts::SQRT_2 * problem.first_scatter;
    let others = problem.data.iter().enumerate().filter(|(other, _)| *other != k);
    let mut of_sample = others.filter(|(_, other)| other.sample == datum.sample);
    of_sample.any(|(_, other)| (other.value - datum.value).abs() <= near)
}

/// A fit in which a large residual counts little and a very large one nothing.
fn robust(problem: &mut Problem) -> Result<Solution, NoSolution> {
    let beliefs: Vec<f64> = problem.beliefs.iter().map(|belief| belief.value).collect();
    let believed = (problem.predict)(&beliefs);
    let off = |datum: &Datum| datum.value.signum() * (datum.value - believed[datum.sample]);
    // A machine that is off is off in all readings.
    let common = median(problem.data.iter().map(off).collect());
    let residuals: Vec<f64> = problem.data.iter().map(|datum| off(datum) - common).collect();
    weigh(problem, &residuals, |t| (HUBER / t).min(1.0));
    let mut solution = problem.solve(None)?;
    for round in 0..4 {
        let residual = |datum: &Datum| datum.value - solution.predicted[datum.sample];
        let residuals: Vec<f64> = problem.data.iter().map(residual).collect();
        weigh(problem, &residuals, |t| match round {
            0 => (HUBER / t).min(1.0),
            _ if t < TUKEY => (1.0 - (t / TUKEY).powi(2)).powi(2),
            _ => 0.0,
        });
        solution = problem.solve_near(&solution)?;
    }
    Ok(solution)
}

/// Weighs data by their residuals in robust deviations.
fn weigh(problem: &mut Problem, residuals: &[f64], weight: impl Fn(f64) -> f64) {
    let scatter = robust_deviation(residuals.iter().copied()).max(problem.least_scatter);
    for (datum, residual) in problem.data.iter_mut().zip(residuals) {
        datum.weight = weight(residual.abs() / scatter);
    }
}
