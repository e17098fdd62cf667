//! How exact a machine must be so that the wire comes out as exactly as it is needed.

use std::ops::ControlFlow;

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_core::simulate::{
    BadErrorTerm, ErrorModel, ErrorSource, ErrorTerm, perfect_wire, simulate as simulate_wire,
};

use super::{ErrorSourceName, KeptWire};
use crate::machine::Setup;

/// So many wires are bent for every value that is tried, the same random numbers each time.
const RUNS: u32 = 2000;
/// A value is found when the wire comes out as exactly as it should, to so many parts of it.
const EXACT: f64 = 2e-3;
/// The most values that are tried.
const TRIES: usize = 24;

/// How large errors may be so that each vertex, taken by itself, is near enough to its place in 95 % of the wires.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct SimulatedTolerance {
    /// How near, mm.
    pub within_mm: f64,
    /// Whether a machine without errors comes as near. If not, everything else is null.
    pub possible: bool,
    /// How large each kind of error may be where nothing else is off.
    pub alone: Vec<SourceTolerance>,
    /// How many times as large as they are the errors of the noise profile may be, all together; null where it has none, or where they may
    /// be as large as they like.
    pub together: Option<f64>,
}

/// How large one kind of error may be where nothing else is off.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct SourceTolerance {
    pub source: ErrorSourceName,
    /// Standard deviation: mm of feeds, degrees of rotations and bends, of a strut's bow as a share of its length. Null where no error of this
    /// kind takes a vertex so far.
    pub sigma: Option<f64>,
}

/// What is asked.
pub(super) struct Accuracy<'a> {
    pub within_mm: f64,
    pub wires: &'a [KeptWire],
    pub setup: &'a Setup,
    pub errors: &'a ErrorModel,
    pub seed: u64,
}

/// Where a search for a value begins, and the largest that makes sense.
const fn range(source: ErrorSource) -> [f64; 2] {
    match source {
        ErrorSource::Feed => [0.1, 100.0],
        ErrorSource::Rotation | ErrorSource::Bend => [0.5, 45.0],
        ErrorSource::Curvature => [0.03, 0.5],
    }
}

/// What may be off by how much; nothing more is looked for as soon as `goes_on` does not.
pub(super) fn tolerance(
    asked: &Accuracy,
    goes_on: &dyn Fn() -> bool,
) -> Result<Option<SimulatedTolerance>, BadErrorTerm> {
    let systematic = asked.wires.iter().map(|wire| {
        let made = perfect_wire(&wire.input(asked.setup));
        wire.design.iter().zip(made).map(|(design, made)| (design - made).norm()).fold(0.0, f64::max)
    });
    let mut found = SimulatedTolerance {
        within_mm: asked.within_mm,
        possible: systematic.fold(0.0, f64::max) < asked.within_mm,
        alone: Vec::new(),
        together: None,
    };
    if !found.possible {
        return Ok(goes_on().then_some(found));
    }
    for source in ErrorSource::ALL {
        let [begin, most] = range(source);
        let alone = |sigma| ErrorModel::default().with(source, ErrorTerm { bias: 0.0, sigma });
        let sigma = largest(asked, begin, most, alone, goes_on)?;
        found.alone.push(SourceTolerance { source: source.into(), sigma });
    }
    if *asked.errors != ErrorModel::default() {
        found.together = largest(asked, 1.0, 1e3, |factor| asked.errors.times(factor), goes_on)?;
    }
    Ok(goes_on().then_some(found))
}

/// The largest value with which 95 % of the wires come near enough; none where the most does.
fn largest(
    asked: &Accuracy,
    begin: f64,
    most: f64,
    errors: impl Fn(f64) -> ErrorModel,
    goes_on: &dyn Fn() -> bool,
) -> Result<Option<f64>, BadErrorTerm> {
    // Between two values the radius is a power of the value, nearly: of feeds and angles it is in proportion, of bows their square.
    let (mut low, mut high): (Option<[f64; 2]>, Option<[f64; 2]>) = (None, None);
    let mut value = begin;
    for _ in 0..TRIES {
        if !goes_on() {
            return Ok(None);
        }
        let radius = worst_radius_95(asked, &errors(value), goes_on)?;
        if (radius / asked.within_mm - 1.0).abs() < EXACT {
            break;
        }
        let here = Some([value, radius]);
        if radius < asked.within_mm {
            if value >= most {
                return Ok(None);
            }
            low = here;
        } else {
            high = here;
        }
        value = match (low, high) {
            (Some([a, below]), Some([b, above])) if below > 0.0 => {
                let share = (asked.within_mm / below).ln() / (above / below).ln();
                // Never so near to an end that it does not come closer any more.
                a * (b / a).powf(share.clamp(0.05, 0.95))
            }
            (Some([a, _]), Some([b, _])) => f64::midpoint(a, b),
            (Some([a, below]), None) if below > 0.0 => {
                (a * (asked.within_mm / below).clamp(1.05, 20.0)).min(most)
            }
            (Some([a, _]), None) => (a * 20.0).min(most),
            (None, _) => value * (asked.within_mm / radius).clamp(0.02, 0.95),
        };
    }
    Ok(Some(value))
}

/// The distance that 95 % of the wires keep within, of the vertex where it is largest.
fn worst_radius_95(
    asked: &Accuracy,
    errors: &ErrorModel,
    goes_on: &dyn Fn() -> bool,
) -> Result<f64, BadErrorTerm> {
    let go = |_: &_| if goes_on() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) };
    let mut worst = 0.0f64;
    for wire in asked.wires {
        let found = simulate_wire(&wire.input(asked.setup), errors, RUNS, asked.seed, go)?;
        worst = found.deviations.iter().map(|spread| spread.radius_95.mm()).fold(worst, f64::max);
    }
    Ok(worst)
}
