//! How far a machine is in the step that it runs, from where it reports its axes.

use wirebend_core::compensate::CompensatedProgram;
use wirebend_core::estimate::StepSeconds;
use wirebend_driver_host::jobs::Part;
use wirebend_planning::machine::told_steps;
use wirebend_planning::{JobStep, PartOfStep};

use super::task::Task;

/// A step is over when that is reported, and not before.
const MAX: f64 = 0.999;
/// An axis that is so near the end of its way has gone it, and one so near the beginning is at rest: positions are rounded to
/// steps of motors.
const NEAR: f64 = 0.005;

/// A step as it is sent to the machine, in canonical signs, and how long its parts take.
#[derive(Debug, Clone, Copy)]
pub(super) struct CommandedStep {
    pub commanded: JobStep,
    pub seconds: StepSeconds,
}

/// Follows a machine from step to step. Where its zeros are is its own matter, and of some it changes between wires.
#[derive(Debug, Default)]
pub(super) struct StepWatch {
    steps: Vec<CommandedStep>,
    /// Where the axes were reported last.
    axes: Option<JobStep>,
    made: Option<usize>,
    /// Where feed and head were when the step began, as far as that is known.
    from: Option<JobStep>,
    /// What was reported before.
    last: Option<JobStep>,
    /// Where the bend axis rests, degrees.
    rest: f64,
    /// The farthest that the bend axis has come, in part of its way: below that it is on its way back.
    farthest: f64,
    part: f64,
    /// Whether the bend axis of a bend that ends before zero has come to where the peg comes out: its way begins there.
    is_out: bool,
}

/// What was gone of a way, from 0 to 1; of no way, all.
fn gone(distance: f64, whole: f64) -> f64 {
    if whole == 0.0 { 1.0 } else { (distance / whole).clamp(0.0, 1.0) }
}

impl StepWatch {
    pub fn new(steps: Vec<CommandedStep>) -> Self {
        Self { steps, ..Self::default() }
    }

    /// The axes are reported to be here, in canonical signs.
    pub const fn position(&mut self, axes: JobStep) {
        self.axes = Some(axes);
    }

    /// How far the machine is in the step after those that are done, in part of the step's time; it does not go back. 0 as
    /// long as no axes were reported.
    pub fn in_step(&mut self, made: u32) -> f64 {
        self.part(usize::try_from(made).unwrap_or(usize::MAX), self.axes)
    }

    fn part(&mut self, made: usize, axes: Option<JobStep>) -> f64 {
        if self.made != Some(made) {
            self.begin(made, axes);
        }
        let step = self.steps.get(made).copied();
        let Some(((step, axes), from)) = step.zip(axes).zip(self.from.or(axes)) else { return 0.0 };
        // Its zero was set anew: nothing draws the wire back so far.
        let back = step.commanded.feed_mm.max(1.0);
        let anew = self.last.is_some_and(|last| axes.feed_mm < last.feed_mm - back);
        let from = if anew { axes } else { from };
        (self.from, self.last) = (Some(from), Some(axes));
        self.part = self.part.max(self.over(&step, from, axes).min(MAX));
        self.part
    }

    fn begin(&mut self, made: usize, axes: Option<JobStep>) {
        // The end of a step is reported when the next one may be under way, and positions are reported more seldom still: it
        // begins where the one before ends.
        let before = self.made.filter(|before| before + 1 == made);
        let ended =
            before.and_then(|before| self.steps.get(before)).zip(self.from).map(|(step, from)| JobStep {
                feed_mm: from.feed_mm + step.commanded.feed_mm,
                rotate_deg: from.rotate_deg + step.commanded.rotate_deg,
                ..JobStep::default()
            });
        self.from = ended.or(axes);
        (self.made, self.farthest, self.part, self.is_out) = (Some(made), 0.0, 0.0, false);
    }

    /// Feed, rotate, the peg comes out, the bend axis goes there and comes back, the peg goes in.
    fn over(&mut self, step: &CommandedStep, from: JobStep, axes: JobStep) -> f64 {
        let CommandedStep { commanded, seconds } = step;
        let StepSeconds { feed, rotate, bend, wait } = *seconds;
        let total = seconds.total();
        if total <= 0.0 {
            return 0.0;
        }
        let fed = gone(axes.feed_mm - from.feed_mm, commanded.feed_mm);
        let turned = gone(axes.rotate_deg - from.rotate_deg, commanded.rotate_deg);
        let is_fed = fed >= 1.0 - NEAR;
        if !is_fed || turned < 1.0 - NEAR {
            // Nothing is fed or turned before the bend axis is back.
            if (if is_fed { turned } else { fed }) > NEAR {
                self.rest = axes.bend_deg;
            }
            return (feed * fed + if is_fed { rotate * turned } else { 0.0 }) / total;
        }
        let bent = self.bent(commanded, axes.bend_deg - self.rest);
        self.farthest = self.farthest.max(bent);
        let back = bent < self.farthest - NEAR;
        let peg = if self.farthest > NEAR { wait / 2.0 } else { 0.0 };
        (feed + rotate + peg + bend * if back { 1.0 - bent / 2.0 } else { bent / 2.0 }) / total
    }

    /// How much of its way out the bend axis has gone, from 0 to 1.
    fn bent(&mut self, commanded: &JobStep, axis: f64) -> f64 {
        let bend = commanded.bend_deg;
        let Some(out) = commanded.approach_deg.filter(|out| out * bend >= 0.0) else {
            return if bend == 0.0 { 0.0 } else { gone(axis, bend) };
        };
        self.is_out |= gone(axis, out) >= 1.0 - NEAR;
        if self.is_out { gone(axis - out, bend - out) } else { 0.0 }
    }
}

impl Task<'_> {
    /// Follows a machine through a wire.
    pub(super) fn step_watch(&self, wire: usize) -> StepWatch {
        let steps =
            self.wire(wire).ok().and_then(|wire| told_steps(&wire.compensated).ok()).unwrap_or_default();
        let model = &self.setup.model;
        let program = CompensatedProgram::from_job_steps(steps, &model.compensation);
        let each = program.told().zip(model.time.each_step(&program));
        let commanded = each.map(|(told, seconds)| CommandedStep { commanded: JobStep::from(told), seconds });
        StepWatch::new(commanded.collect())
    }

    /// The part of a step's time that a machine took for so much of the step, which is counted from 1.
    pub(super) fn time_part(&self, wire: usize, step: u32, counted: Part) -> f64 {
        let mut watch = self.step_watch(wire);
        let PartOfStep { feed_mm, rotate_deg } = self.setup.signs.part(counted);
        for (feed_mm, rotate_deg) in [(0.0, 0.0), (feed_mm, rotate_deg)] {
            watch.position(JobStep { feed_mm, rotate_deg, ..JobStep::default() });
            watch.in_step(step.saturating_sub(1));
        }
        watch.in_step(step.saturating_sub(1))
    }
}

#[cfg(test)]
mod tests;
