//! How far off a wire will be before it is bent, for a design that is open.

use std::ops::ControlFlow;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::simulate::{perfect_wire, simulate as simulate_wire};
use wirebend_files::document::Job;

use super::{
    Accuracy, Figures, KeptWire, SimulatedTolerance, SimulatedWire, bad_errors, check_runs, check_within,
    noise_model, shares, simulated_wire, tolerance,
};
use crate::machine::Setup;
use crate::{Installation, PlanningError};

/// Asks how far off the wires of a job will be.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct PredictionRequest {
    /// The noise profile: how far off single motions are.
    pub noise: String,
    /// How often each wire is bent.
    pub runs: u32,
    /// Where the random numbers start: the same seed, the same wires.
    pub seed: u64,
    /// How close each vertex, taken by itself, has to be to its place in 95 % of the wires, mm; then the answer says how exact a machine must be.
    #[serde(default)]
    #[schemars(range(min = 0.0))]
    pub within_mm: Option<f64>,
}

/// How far off wires will be, by the formulas of the compensation turned round. Distances are taken with the first vertex and the
/// first direction in place.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Prediction {
    pub noise: String,
    /// How often each wire was bent.
    pub runs: u32,
    pub wires: Vec<SimulatedWire>,
    /// How exact a machine must be; null where nobody asked.
    pub tolerance: Option<SimulatedTolerance>,
}

/// Bends the wires of a job many times by the formulas. `None` where `goes_on` does not; it is told how many wires are bent, and of
/// how many.
pub fn predict(
    app: &Installation,
    name: &str,
    setup: &Setup,
    job: &Job,
    request: &PredictionRequest,
    goes_on: &dyn Fn(u64, u64) -> bool,
) -> Result<Option<Prediction>, PlanningError> {
    let contents = job.contents();
    check_runs(request.runs, contents)?;
    let within = request.within_mm.map(check_within).transpose()?;
    let errors = noise_model(app, &request.noise)?;
    let wrong = |error| bad_errors(Some(&request.noise), error);
    let kept = KeptWire::all(name, contents, setup)?;
    let of = contents.wires.len() as u64 * u64::from(request.runs);
    let mut done = 0;
    let mut wires = Vec::with_capacity(kept.len());
    for (wire, kept) in contents.wires.iter().zip(&kept) {
        let input = kept.input(setup);
        let each = |_: &_| {
            done += 1;
            if goes_on(done, of) { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        };
        let report = simulate_wire(&input, &errors, request.runs, request.seed, each).map_err(wrong)?;
        let (sources, steps) = shares(wire, &input, &errors).map_err(wrong)?;
        let figures = Figures { perfect: &perfect_wire(&input), made: None, report: &report };
        wires.push(SimulatedWire { sources, steps, ..simulated_wire(wire, kept, &figures) });
    }
    let tolerance = match within {
        Some(within_mm) => {
            let asked = Accuracy { within_mm, wires: &kept, setup, errors: &errors, seed: request.seed };
            tolerance(&asked, &|| goes_on(done, of)).map_err(wrong)?
        }
        None => None,
    };
    let (noise, runs) = (request.noise.clone(), request.runs);
    Ok(goes_on(done, of).then_some(Prediction { noise, runs, wires, tolerance }))
}
