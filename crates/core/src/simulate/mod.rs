//! The wire that a machine bends: what its commands leave, and how errors add up along it.
//!
//! Kinematic: the inverse models of [`crate::compensate`] turn commands into bends and lengths,
//! and homogeneous transforms into positions. Errors follow Bend-Forming (Bhundiya and Cordero
//! 2023, Eq. 1 and Appendix A): each feed, rotation, bend and strut curvature is off by a constant
//! and a normally distributed part.

mod first_order;
mod made;
mod resolution;
mod wire;

use std::ops::{ControlFlow, Range};

use nalgebra::Point3;
use rayon::prelude::*;

use crate::bend::{Frame, Step};
use crate::compensate::{CompensatedProgram, Compensation, ToldStep, made_of, results};
use crate::units::{Angle, Length};
pub use first_order::{FirstOrder, SourceEffect, StepEffect, first_order};
pub use made::steps_of_corners;
pub use resolution::Resolution;
pub use wire::ImperfectWire;
use wire::{Draw, corner_to_corner, imperfect};

/// What commands leave where nothing is off: the wire that is fed, and turns and bends as they come out.
fn formed(program: &CompensatedProgram, compensation: &Compensation) -> Vec<Step> {
    let told: Vec<ToldStep> = program.told().collect();
    let made = made_of(&told, compensation);
    let bends = results(&made, compensation);
    made.iter().zip(bends).map(|(made, bend)| Step { bend, ..made.step }).collect()
}

/// A constant error and the standard deviation of the random one, of a quantity in its own unit.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ErrorTerm {
    /// What is always off.
    pub bias: f64,
    /// Standard deviation; not negative.
    pub sigma: f64,
}

/// How wrong each motion is.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ErrorModel {
    /// Of each feed, in mm.
    pub feed_mm: ErrorTerm,
    /// Of each rotation that is made between two bends, in degrees.
    pub rotate_deg: ErrorTerm,
    /// Of each bend, in degrees; its constant part makes a bend larger, to whichever side that goes.
    pub bend_deg: ErrorTerm,
    /// Of each strut: its bow, the rise of its arc over the distance of its ends, to a side that is left to chance. The ends of a bowed
    /// strut stay in line, as in the authors' model, but come closer together; vertices between them go aside.
    pub curvature: ErrorTerm,
}

/// What an error is of: a motion of the machine, or the wire itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ErrorSource {
    /// The feed of a step.
    Feed,
    /// The rotation before a bend.
    Rotation,
    /// The angle of a bend.
    Bend,
    /// The bow of a strut.
    Curvature,
}

impl ErrorSource {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Feed, Self::Rotation, Self::Bend, Self::Curvature];
}

impl ErrorModel {
    /// The errors of one source.
    #[must_use]
    pub const fn term(&self, of: ErrorSource) -> ErrorTerm {
        match of {
            ErrorSource::Feed => self.feed_mm,
            ErrorSource::Rotation => self.rotate_deg,
            ErrorSource::Bend => self.bend_deg,
            ErrorSource::Curvature => self.curvature,
        }
    }

    /// The same errors, those of one source aside.
    #[must_use]
    pub fn with(mut self, of: ErrorSource, term: ErrorTerm) -> Self {
        match of {
            ErrorSource::Feed => self.feed_mm = term,
            ErrorSource::Rotation => self.rotate_deg = term,
            ErrorSource::Bend => self.bend_deg = term,
            ErrorSource::Curvature => self.curvature = term,
        }
        self
    }

    /// So many times these errors.
    #[must_use]
    pub fn times(self, factor: f64) -> Self {
        ErrorSource::ALL.into_iter().fold(self, |model, of| {
            let ErrorTerm { bias, sigma } = self.term(of);
            model.with(of, ErrorTerm { bias: factor * bias, sigma: factor * sigma })
        })
    }

    /// Whether such errors can be drawn.
    ///
    /// # Errors
    /// [`BadErrorTerm`] where a figure is not finite, or a deviation is below zero.
    pub fn check(&self) -> Result<(), BadErrorTerm> {
        ErrorSource::ALL.into_iter().try_for_each(|of| self.term(of).check(of))
    }
}

impl ErrorTerm {
    /// # Errors
    /// A figure that is not finite, or a deviation below zero.
    pub(crate) fn check(self, of: ErrorSource) -> Result<(), BadErrorTerm> {
        if !self.bias.is_finite() || !self.sigma.is_finite() || self.sigma < 0.0 {
            return Err(BadErrorTerm { of, bias: self.bias, sigma: self.sigma });
        }
        Ok(())
    }
}

/// Why errors cannot be drawn.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("the error of {of:?} is {bias} ± {sigma}; both are finite and the deviation not negative")]
pub struct BadErrorTerm {
    /// What is off.
    pub of: ErrorSource,
    /// Its constant error.
    pub bias: f64,
    /// Its standard deviation.
    pub sigma: f64,
}

/// The steps that a compensated program leaves in the wire, corner to corner: the inverse of
/// compensation.
#[must_use]
pub fn formed_steps(program: &CompensatedProgram, compensation: &Compensation) -> Vec<Step> {
    corner_to_corner(&formed(program, compensation), compensation)
}

/// How far one vertex of the route lies from where it should, over all runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    /// Mean distance.
    pub mean: Length,
    /// 95 % of the runs are within this distance.
    pub radius_95: Length,
}

/// What an error model does to a wire.
#[derive(Debug, Clone, PartialEq)]
pub struct ErrorReport {
    /// For each vertex of the route, in its order: distance from the design, with the first vertex
    /// and the first direction held in place.
    pub deviations: Vec<Spread>,
    /// For each group of passes through one node, in the order given: the largest distance between
    /// any two of its passes.
    pub gaps: Vec<Spread>,
}

/// What is simulated.
#[derive(Debug, Clone, Copy)]
pub struct SimulationInput<'a> {
    /// Frame in which the design starts.
    pub start: Frame,
    /// Positions of the route's vertices as designed, in mm.
    pub design: &'a [Point3<f64>],
    /// For each step the parts of its feed at which vertices lie, ending with 1.
    pub fractions: &'a [Vec<f64>],
    /// Groups of indices into `design` that are passes through one node.
    pub passes: &'a [Vec<usize>],
    /// The program that is run.
    pub program: &'a CompensatedProgram,
    /// The machine and the wire.
    pub compensation: &'a Compensation,
}

/// For each step of a path the parts of its feed at which vertices lie, ending with 1: the spans are
/// the segments of each step's feed.
#[must_use]
pub fn fractions(path: &[Point3<f64>], spans: impl IntoIterator<Item = Range<usize>>) -> Vec<Vec<f64>> {
    let parts = |span: Range<usize>| {
        let points = path.get(span.start..=span.end).unwrap_or_default();
        let lengths: Vec<f64> = points.windows(2).map(|pair| (pair[1] - pair[0]).norm()).collect();
        let total: f64 = lengths.iter().sum();
        let along = lengths.iter().scan(0.0, |sum, length| {
            *sum += length;
            Some(*sum / total)
        });
        along.collect()
    };
    spans.into_iter().map(parts).collect()
}

/// The frame in which scheduled steps make what their nominal program makes from `start`: turned about the first feed against
/// what the head turns before the first bend, and by half a turn where that goes to the negative side.
#[must_use]
pub fn scheduled_start(start: Frame, scheduled: &[Step]) -> Frame {
    let mut frame = start;
    let Some(first_bend) = scheduled.iter().position(|step| step.bend != Angle::ZERO) else { return frame };
    if scheduled[first_bend].bend < Angle::ZERO {
        frame.rotate(Angle::HALF_TURN);
    }
    // What is turned before it is made up for: its plane is where it is.
    let turned: Angle = scheduled[..=first_bend].iter().map(|step| step.rotate).sum();
    frame.rotate(-turned);
    frame
}

/// The wire that a machine without errors bends: its vertices in mm, in the order of the route.
#[must_use]
pub fn perfect_wire(input: &SimulationInput) -> Vec<Point3<f64>> {
    let formed = formed(input.program, input.compensation);
    imperfect(input, &formed, &mut Draw::new(&ErrorModel::default(), 0, 0)).points
}

/// Wires are bent in batches of about so many steps: that bounds what is kept of them, and what is bent in vain when a run is ended.
const STEPS_AT_ONCE: u32 = 1 << 17;

/// Bends the wire `runs` times with errors drawn from `seed`, on all processors; a wire's errors depend on the seed and on its number
/// alone. `each_run` gets the wires in their order. Where it says that there need be no more, the report is of the wires until then.
///
/// # Errors
/// [`BadErrorTerm`] when an error is not finite or a deviation is negative.
pub fn simulate(
    input: &SimulationInput,
    errors: &ErrorModel,
    runs: u32,
    seed: u64,
    mut each_run: impl FnMut(&ImperfectWire) -> ControlFlow<()>,
) -> Result<ErrorReport, BadErrorTerm> {
    errors.check()?;
    let mut deviations = vec![Vec::with_capacity(runs as usize); input.design.len()];
    let mut gaps = vec![Vec::with_capacity(runs as usize); input.passes.len()];
    let formed = formed(input.program, input.compensation);
    let steps = u32::try_from(formed.len()).unwrap_or(u32::MAX);
    let at_once = STEPS_AT_ONCE / steps.clamp(1, STEPS_AT_ONCE);
    let bent = |run| {
        let wire = imperfect(input, &formed, &mut Draw::new(errors, seed, run));
        let distances = Distances::of(input, &wire.points);
        (wire, distances)
    };
    for first in (0..runs).step_by(at_once as usize) {
        let numbers = first..first.saturating_add(at_once).min(runs);
        let wires: Vec<_> = numbers.into_par_iter().map(bent).collect();
        for (wire, found) in &wires {
            keep(&mut deviations, &found.deviations);
            keep(&mut gaps, &found.gaps);
            if each_run(wire).is_break() {
                return Ok(ErrorReport::of(deviations, gaps));
            }
        }
    }
    Ok(ErrorReport::of(deviations, gaps))
}

/// The wire that [`simulate`] bends as the one of this number, from 0, alone: the commands are turned back for it only.
///
/// # Errors
/// [`BadErrorTerm`] as there.
pub fn wire_of_run(
    input: &SimulationInput,
    errors: &ErrorModel,
    seed: u64,
    run: u32,
) -> Result<ImperfectWire, BadErrorTerm> {
    errors.check()?;
    let formed = formed(input.program, input.compensation);
    Ok(imperfect(input, &formed, &mut Draw::new(errors, seed, run)))
}

fn keep(all: &mut [Vec<f64>], found: &[f64]) {
    for (all, &distance) in all.iter_mut().zip(found) {
        all.push(distance);
    }
}

/// How far off one wire is, in mm.
struct Distances {
    deviations: Vec<f64>,
    gaps: Vec<f64>,
}

impl Distances {
    fn of(input: &SimulationInput, made: &[Point3<f64>]) -> Self {
        let widest = |passes: &Vec<usize>| {
            let between = passes.iter().flat_map(|&a| passes.iter().map(move |&b| (a, b)));
            between.map(|(a, b)| (made[a] - made[b]).norm()).fold(0.0, f64::max)
        };
        Self {
            deviations: input.design.iter().zip(made).map(|(design, made)| (design - made).norm()).collect(),
            gaps: input.passes.iter().map(widest).collect(),
        }
    }
}

impl ErrorReport {
    fn of(deviations: Vec<Vec<f64>>, gaps: Vec<Vec<f64>>) -> Self {
        let spreads = |all: Vec<Vec<f64>>| all.into_par_iter().map(Spread::of).collect();
        Self { deviations: spreads(deviations), gaps: spreads(gaps) }
    }
}

impl Spread {
    fn of(mut distances: Vec<f64>) -> Self {
        distances.sort_unstable_by(f64::total_cmp);
        #[allow(clippy::cast_precision_loss)] // runs are far fewer than 2^52
        let mean = distances.iter().sum::<f64>() / distances.len().max(1) as f64;
        let within = (distances.len() * 95).div_ceil(100).saturating_sub(1);
        let radius_95 = distances.get(within).copied().unwrap_or_default();
        Self { mean: Length::computed(mean), radius_95: Length::computed(radius_95) }
    }
}

#[cfg(test)]
mod tests;
