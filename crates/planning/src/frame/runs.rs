//! Many drawn wires, shared out to the processors of the computer. A wire depends on seed and number alone, so that it does not matter
//! which processor draws it.

use std::num::NonZero;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::sync::{Mutex, PoisonError};

use wirebend_accuracy::{Closing, ClosingError, Prepared};
use wirebend_core::simulate::{ErrorModel, ErrorTerm};
use wirebend_error::InputName;

use super::figures::ClosingFigures;
use super::wires::Wires;
use super::within;
use crate::{PlanningError, Progress};

/// The most wires of one run.
const MAX_RUNS: u32 = 1_000_000;
/// More processors do not help: each prepares the frame for itself.
const MAX_THREADS: usize = 8;
/// How many figures a wire has.
const FIGURES: usize = 7;

/// Figures of one wire, or of many: surface, vertices, force, stress, pull, energy, gap. Without a pull, and without
/// passes that could be apart, that is not a number.
#[derive(Debug, Clone, Copy)]
pub(super) struct Figures([f64; FIGURES]);

/// What is to be drawn.
pub(super) struct Runs<'a> {
    pub wires: &'a Wires,
    pub errors: &'a ErrorModel,
    pub closing: Closing,
    pub count: u32,
    pub seed: u64,
}

impl Runs<'_> {
    /// Refuses more runs than are ever needed.
    pub fn check(count: u32) -> Result<(), PlanningError> {
        within(
            InputName::Runs,
            u64::from(count),
            0,
            u64::from(MAX_RUNS),
            "1 to 1000000, or 0 for the expectation",
        )
    }

    /// The figures of each wire, in their order; `None` where a person has stopped it.
    pub fn all(&self, progress: &dyn Progress) -> Result<Option<Vec<Figures>>, ClosingError> {
        let (next, over) = (AtomicU32::new(0), AtomicBool::new(false));
        let found: Mutex<Vec<(u32, Result<Figures, ClosingError>)>> = Mutex::default();
        let take = |told: &mut dyn FnMut(u32)| {
            let straight = if self.is_straight() { self.wires.model.straight().ok() } else { None };
            loop {
                let run = next.fetch_add(1, Ordering::Relaxed);
                if run >= self.count || over.load(Ordering::Relaxed) {
                    return;
                }
                let figures = self.one(run, straight.as_ref());
                over.fetch_or(figures.is_err(), Ordering::Relaxed);
                found.lock().unwrap_or_else(PoisonError::into_inner).push((run, figures));
                told(run);
            }
        };
        let threads = std::thread::available_parallelism().map_or(1, NonZero::get).min(MAX_THREADS);
        std::thread::scope(|scope| {
            for _ in 1..threads {
                scope.spawn(|| take(&mut |_| ()));
            }
            take(&mut |run| {
                progress.advance(u64::from(run), u64::from(self.count));
                over.fetch_or(!progress.goes_on(), Ordering::Relaxed);
            });
        });
        if !progress.goes_on() {
            return Ok(None);
        }
        let mut found = found.into_inner().unwrap_or_else(PoisonError::into_inner);
        found.sort_by_key(|(run, _)| *run);
        found.into_iter().map(|(_, figures)| figures).collect::<Result<_, _>>().map(Some)
    }

    fn is_straight(&self) -> bool {
        self.errors.curvature == ErrorTerm::default()
    }

    fn one(&self, run: u32, straight: Option<&Prepared<'_>>) -> Result<Figures, ClosingError> {
        let model = &self.wires.model;
        let draw = model.draw(self.errors, self.seed, u64::from(run))?;
        let bowed;
        let prepared = if let Some(straight) = straight {
            straight
        } else {
            bowed = model.bowed(&draw)?;
            &bowed
        };
        let closed = prepared.close(self.closing, &draw);
        Ok(Figures([
            closed.surface_rms(&self.wires.surface),
            closed.surface_rms(&self.wires.whole),
            closed.axial_rms(),
            closed.von_mises_rms(),
            closed.largest_pull().unwrap_or(f64::NAN),
            closed.energy,
            prepared.gap(&draw).unwrap_or(f64::NAN),
        ]))
    }
}

impl Figures {
    pub fn mean(all: &[Self]) -> Self {
        Self::over(all, mean)
    }

    pub fn root_mean_square(all: &[Self]) -> Self {
        Self::over(all, |values| mean(&values.iter().map(|x| x * x).collect::<Vec<_>>()).sqrt())
    }

    /// The standard deviation of all wires as these tell it, from their own mean; `None` of a single one.
    #[allow(clippy::cast_precision_loss)] // runs are far fewer than 2^52
    pub fn deviation(all: &[Self]) -> Option<Self> {
        let free = all.len().checked_sub(1).filter(|&free| free > 0)? as f64;
        Some(Self::over(all, |values| {
            let middle = mean(values);
            (values.iter().map(|x| (x - middle).powi(2)).sum::<f64>() / free).sqrt()
        }))
    }

    fn over(all: &[Self], of: impl Fn(&[f64]) -> f64) -> Self {
        let column = |k: usize| of(&all.iter().map(|figures| figures.0[k]).collect::<Vec<_>>());
        Self(std::array::from_fn(column))
    }
}

#[allow(clippy::cast_precision_loss)] // runs are far fewer than 2^52
fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len().max(1) as f64
}

impl From<Figures> for ClosingFigures {
    fn from(Figures([surface, vertices, force, stress, pull, energy, gap]): Figures) -> Self {
        Self {
            surface_rms_mm: surface,
            vertices_rms_mm: vertices,
            axial_rms_n: force,
            von_mises_rms_mpa: stress,
            largest_pull_n: Some(pull).filter(|pull| !pull.is_nan()),
            energy_n_mm: energy,
            gap_mm: Some(gap).filter(|gap| !gap.is_nan()),
        }
    }
}
