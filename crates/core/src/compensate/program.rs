//! A program as a machine is told it, with what compensating it has found.

use super::{Compensation, MotionModel, PegGeometry, StepError, ToldStep, approaches};
use crate::bend::Step;
use crate::units::{Angle, Length};

/// What a machine is told. It can only be had by compensating.
#[derive(Debug, Clone, PartialEq)]
pub struct CompensatedProgram {
    steps: Vec<Step>,
    /// Where the peg comes out for each step, unless the place for straight wire will do and the axis goes beyond zero.
    approaches: Vec<Option<Angle>>,
    /// That place, before zero; none for a machine without a peg.
    near_side: Option<Angle>,
    near: Vec<NearCorner>,
    unpressed: Vec<StepError>,
    /// How feed and head are off.
    motion: MotionModel,
}

/// A bend whose peg meets wire that was bent before.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NearCorner {
    /// Index of the step, from 0.
    pub step: usize,
    /// How much further the axis goes than for wire that is straight as far as the peg reaches; nothing where it could not
    /// make the bend on such wire.
    pub further: Option<Angle>,
    /// Whether the peg touches beyond a corner of another plane or to the other side: that corner may give as well.
    pub past_other: bool,
}

impl CompensatedProgram {
    /// A program that was compensated before, for a machine and a wire, and has been kept in a job whose hash still fits.
    #[must_use]
    pub fn from_job_steps<T: Into<ToldStep>>(
        steps: impl IntoIterator<Item = T>,
        compensation: &Compensation,
    ) -> Self {
        let told: Vec<ToldStep> = steps.into_iter().map(Into::into).collect();
        let approaches = approaches(&told, compensation);
        Self::new(told.iter().map(|told| told.step).collect(), approaches, compensation)
    }

    pub(super) fn new(steps: Vec<Step>, approaches: Vec<Option<Angle>>, compensation: &Compensation) -> Self {
        let near_side = compensation.bend.setback.as_ref().map(PegGeometry::near_side);
        let (near, unpressed) = Default::default();
        Self { steps, approaches, near_side, near, unpressed, motion: compensation.motion }
    }

    /// The same with what compensating it has found.
    pub(super) fn with_findings(self, near: Vec<NearCorner>, unpressed: Vec<StepError>) -> Self {
        Self { near, unpressed, ..self }
    }

    /// A step with where its peg comes out, as far as it cannot be told without.
    fn whole(&self, step: usize) -> Option<ToldStep> {
        let approach = self.approaches.get(step).copied().flatten();
        self.steps.get(step).map(|step| ToldStep { step: *step, approach })
    }

    /// The steps as the machine is told them, with their sides where the signs of their bends are not these.
    pub fn told(&self) -> impl Iterator<Item = ToldStep> {
        (0..self.steps.len()).filter_map(|step| self.whole(step)).map(ToldStep::short)
    }

    /// Where the bend axis stands when the peg comes out in a step: on the side from which it bends, whatever the sign of
    /// the command. `None` where the step does not bend, and for a machine without a peg.
    #[must_use]
    pub fn peg_comes_out(&self, step: usize) -> Option<Angle> {
        let told = self.whole(step).filter(ToldStep::bends)?;
        let near_side = self.near_side?;
        let approach = told.approach.map_or(near_side, Angle::abs);
        // No nearer to zero than a machine has it come out by itself.
        Some(Angle::computed(-told.side() * approach.rad().max(near_side.rad())))
    }

    /// How much farther from zero that is than beside straight wire.
    #[must_use]
    pub fn peg_detour(&self, step: usize) -> Angle {
        let comes_out = self.peg_comes_out(step).zip(self.near_side);
        comes_out.map_or(Angle::ZERO, |(at, near_side)| at.abs() - near_side)
    }

    /// The bends whose peg meets wire that was bent before, where it was compensated just now.
    #[must_use]
    pub fn near_corners(&self) -> &[NearCorner] {
        &self.near
    }

    /// The bends that the peg cannot press on wire as it is formed so far, where it was compensated just now: they are commanded
    /// as on a straight leg, and come out otherwise.
    #[must_use]
    pub fn unpressed(&self) -> &[StepError] {
        &self.unpressed
    }

    /// The steps, in the frame and signs of the canonical program.
    #[must_use]
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// Wire that all feeds take together.
    #[must_use]
    pub fn feed_total(&self) -> Length {
        self.motion.fed(self.steps.iter().map(|step| step.feed).sum())
    }
}
