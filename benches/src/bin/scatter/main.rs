//! How far the vertices of a wire scatter with errors: how long it takes, and whether `NumPy` with equations of its own finds the same.
//! Ends with an error where a figure does not hold.

#![allow(clippy::print_stdout, reason = "its output is the table")]

mod once;

use std::ops::ControlFlow;
use std::process::{Command, Stdio};
use std::time::Instant;

use anyhow::{Context, Result, ensure};
use nalgebra::{Matrix3, Vector3};
use serde_json::{Value, json};
use wirebend_benches::{design, machine};
use wirebend_core::bend::NominalProgram;
use wirebend_core::plan::{DoublingChoice, Machine, PlanOptions, WirePlan, plan_wires};
use wirebend_core::simulate::{
    ErrorModel, ErrorReport, ErrorTerm, FirstOrder, SimulationInput, first_order, formed_steps, fractions,
    perfect_wire, scheduled_start, simulate,
};

/// So many wires are bent.
const RUNS: u32 = 10_000;
/// The least of so many times is taken.
const TIMES: usize = 5;
/// Errors so many times smaller add up as the first order says.
const SMALL: f64 = 0.1;
/// So many wires tell a covariance to less than a hundredth.
const DRAWN: u32 = 200_000;
/// What may differ, as a part.
const APART: f64 = 0.02;
/// Wires without errors that differ by less are one, mm.
const SAME_MM: f64 = 1e-6;
/// What all wires may take, seconds.
const AIM_S: f64 = 1.0;

/// The typical errors of Bend-Forming.
fn errors() -> ErrorModel {
    let sigma = |sigma| ErrorTerm { bias: 0.0, sigma };
    ErrorModel { feed_mm: sigma(0.1), rotate_deg: sigma(0.75), bend_deg: sigma(0.75), curvature: sigma(0.03) }
}

fn main() -> Result<()> {
    let python = std::env::args().nth(1).context("name the peer's Python")?;
    let machine = machine()?;
    once::measure(&machine)?;
    with_wire("bunny", true, &machine, |plan, input| bunny(&python, plan, &machine, input))
}

/// Plans the wire of a design for a machine, for what is simulated of it.
fn with_wire(
    name: &str,
    faces: bool,
    machine: &Machine,
    then: impl FnOnce(&WirePlan, &SimulationInput) -> Result<()>,
) -> Result<()> {
    let wireframe = design(name, faces)?;
    let options = PlanOptions { doubling: DoublingChoice::Cheapest, ..PlanOptions::default() };
    let plans = plan_wires(&wireframe, &wireframe.components()[0], machine, &options, |_| ());
    let plan = plans.first().context("a wire")?;
    let spans = plan.nominal.iter().flat_map(|program| program.spans.iter().cloned());
    let parts = fractions(&plan.path, spans);
    let input = SimulationInput {
        start: scheduled_start(plan.start, &plan.scheduled.as_ref().context("a schedule")?.steps),
        design: &plan.path,
        fractions: &parts,
        passes: &[],
        program: plan.compensated.as_ref().context("a program")?,
        compensation: &machine.compensation,
    };
    then(plan, &input)
}

fn bunny(python: &str, plan: &WirePlan, machine: &Machine, input: &SimulationInput) -> Result<()> {
    let on = |_: &_| ControlFlow::Continue(());
    let mut ours = f64::INFINITY;
    let mut found = ErrorReport { deviations: Vec::new(), gaps: Vec::new() };
    for seed in 0..u64::try_from(TIMES)? {
        let begin = Instant::now();
        found = simulate(input, &errors(), RUNS, seed, on)?;
        ours = ours.min(begin.elapsed().as_secs_f64());
    }
    let theirs = peer(python, plan, machine, input)?;
    let of = |key: &str| -> Result<Vec<f64>> { Ok(serde_json::from_value(theirs[key].clone())?) };
    let mean: Vec<f64> = found.deviations.iter().map(|spread| spread.mean.mm()).collect();
    let radius: Vec<f64> = found.deviations.iter().map(|spread| spread.radius_95.mm()).collect();
    let seconds = theirs["seconds"].as_f64().context("seconds")?;
    let (means, radii) = (apart(&mean, &of("mean")?)?, apart(&radius, &of("radius_95")?)?);
    let bends = plan.nominal.as_ref().map_or(0, NominalProgram::bend_count);
    println!("{RUNS} wires of the bunny, {bends} bends, {} vertices", plan.path.len());
    println!("  ours {ours:.3} s, NumPy {seconds:.3} s: {:.2} times as fast", seconds / ours);
    println!("  mean distance differs by at most {:.2} %", 100.0 * means);
    println!("  distance of 95 % by at most {:.2} %", 100.0 * radii);
    ensure!(means < APART && radii < APART, "NumPy finds other distances: {means}, {radii}");
    linear(input, &theirs)?;
    ensure!(seconds > ours, "NumPy is faster: {seconds} s, ours {ours} s");
    ensure!(ours <= AIM_S, "{RUNS} wires take {ours} s, {AIM_S} wanted: is the computer busy?");
    Ok(())
}

/// By how much two columns differ, as a part of the largest.
fn apart(a: &[f64], b: &[f64]) -> Result<f64> {
    ensure!(a.len() == b.len(), "as many vertices");
    let largest = a.iter().copied().fold(0.0, f64::max);
    Ok(a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / largest)
}

/// Where vertices lie on average, from where they should, and how they scatter about that.
struct Scatter {
    mean: Vec<Vector3<f64>>,
    covariance: Vec<Matrix3<f64>>,
}

impl Scatter {
    /// How far the first order is from it: of the mean as a part of the standard deviation, of the covariance as a part of its size. The
    /// first vertex is held.
    fn from(&self, linear: &FirstOrder) -> [f64; 2] {
        let means = self.mean.iter().zip(&linear.mean).zip(&linear.covariance).skip(1);
        let means =
            means.map(|((drawn, linear), covariance)| (drawn - linear).norm() / covariance.trace().sqrt());
        let scatter = self.covariance.iter().zip(&linear.covariance).skip(1);
        let scatter = scatter.map(|(drawn, linear)| (drawn - linear).norm() / linear.norm());
        [means.fold(0.0, f64::max), scatter.fold(0.0, f64::max)]
    }
}

/// Small errors, drawn by us and by the peer, and to first order.
fn linear(input: &SimulationInput, theirs: &Value) -> Result<()> {
    let errors = errors().times(SMALL);
    let begin = Instant::now();
    let linear = first_order(input, &errors)?;
    let seconds = begin.elapsed().as_secs_f64();
    println!(
        "  first order {:.2} ms; beside it {DRAWN} wires with errors {SMALL} times as large:",
        1000.0 * seconds
    );
    let places: Vec<[f64; 3]> = serde_json::from_value(theirs["perfect"].clone())?;
    let perfect = perfect_wire(input);
    let apart = perfect.iter().zip(places).map(|(ours, theirs)| (ours.coords - Vector3::from(theirs)).norm());
    let apart = apart.fold(0.0, f64::max);
    ensure!(apart < SAME_MM, "NumPy bends another wire, without errors: {apart} mm");
    let rows: Vec<Vec<f64>> = serde_json::from_value(theirs["covariance"].clone())?;
    let off: Vec<[f64; 3]> = serde_json::from_value(theirs["off"].clone())?;
    let peer = Scatter {
        mean: off.into_iter().map(Vector3::from).collect(),
        covariance: rows.iter().map(|row| Matrix3::from_row_slice(row)).collect(),
    };
    for (name, scatter) in [("ours", drawn(input, &errors)?), ("NumPy", peer)] {
        ensure!(scatter.mean.len() == linear.mean.len(), "as many vertices");
        let [mean, covariance] = scatter.from(&linear);
        println!(
            "  {name:<5}: the covariance differs by at most {:.2} % of its size, the mean by {:.2} % of the deviation",
            100.0 * covariance,
            100.0 * mean
        );
        ensure!(covariance < APART && mean < APART, "{name}: not of the first order");
    }
    Ok(())
}

fn drawn(input: &SimulationInput, errors: &ErrorModel) -> Result<Scatter> {
    let perfect = perfect_wire(input);
    let mut sums = vec![(Vector3::zeros(), Matrix3::zeros()); perfect.len()];
    simulate(input, errors, DRAWN, 1, |wire| {
        for ((sum, squares), (made, perfect)) in sums.iter_mut().zip(wire.points.iter().zip(&perfect)) {
            let way: Vector3<f64> = made - perfect;
            *sum += way;
            *squares += way * way.transpose();
        }
        ControlFlow::Continue(())
    })?;
    let runs = f64::from(DRAWN);
    let mean: Vec<Vector3<f64>> = sums.iter().map(|(sum, _)| sum / runs).collect();
    let covariance =
        sums.iter().zip(&mean).map(|((_, squares), mean)| squares / runs - mean * mean.transpose());
    Ok(Scatter { covariance: covariance.collect(), mean })
}

/// The same with `NumPy`, from the commands and the equations of the page.
fn peer(python: &str, plan: &WirePlan, machine: &Machine, input: &SimulationInput) -> Result<Value> {
    let formed = formed_steps(input.program, input.compensation);
    let feed = machine.compensation.feed.as_ref().context("a model of feeds")?;
    let axis = |axis: Vector3<f64>| -> [f64; 3] { axis.into() };
    let steps = input.program.steps().iter().zip(&formed).zip(input.fractions);
    let steps = steps.map(|((told, formed), fractions)| {
        json!({
            "feed_mm": told.feed.mm(), "rotate_deg": told.rotate.deg(), "bend_deg": formed.bend.deg(), "fractions": fractions,
        })
    });
    let errors = errors();
    let wire = json!({
        "runs": RUNS,
        "times": TIMES,
        "small": SMALL,
        "drawn": DRAWN,
        "start": [input.start.position.coords.as_slice(), &axis(input.start.t()), &axis(input.start.n()), &axis(input.start.b())],
        "design": plan.path.iter().map(|point| point.coords.as_slice().to_vec()).collect::<Vec<_>>(),
        "bend_radius_mm": feed.bend_radius.mm(),
        "neutral_radius_mm": feed.neutral_radius.mm(),
        "sigma": [errors.feed_mm.sigma, errors.rotate_deg.sigma, errors.bend_deg.sigma, errors.curvature.sigma],
        "steps": steps.collect::<Vec<_>>(),
    });
    let file = tempfile::NamedTempFile::new()?;
    serde_json::to_writer(&file, &wire)?;
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/peers/scatter.py");
    let run = Command::new(python).arg(script).arg(file.path()).stderr(Stdio::inherit()).output()?;
    ensure!(run.status.success(), "the peer failed");
    Ok(serde_json::from_slice(&run.stdout)?)
}
