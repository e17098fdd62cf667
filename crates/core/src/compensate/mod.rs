//! Compensation: what a real machine has to be told so that the design comes out.
//!
//! Feeds shrink because bends are arcs, bends grow because the peg orbits off the wire's axis
//! (setback) and because the wire springs back; a feed may give more or less than it is told, and a
//! head be off and have backlash. Every model has its inverse, which tells what a command leaves;
//! the simulation uses it.

mod contact;
mod feed;
mod forming;
mod motion;
mod program;
mod setback;
mod shape;
mod springback;
mod told;

use crate::bend::Step;
use crate::schedule::ScheduledProgram;
use crate::units::{Angle, Length};

use contact::{Beyond, Touch};
pub use feed::FeedModel;
pub(crate) use feed::{corner, with_bend_before};
pub use forming::approaches;
use forming::{Commanded, Forming};
pub(crate) use forming::{made_of, results};
pub use motion::{MotionModel, is_turn};
pub use program::{CompensatedProgram, NearCorner};
pub use setback::{PegGeometry, PegGeometryError, PegRadius};
pub use springback::{Springback, SpringbackCurve, SpringbackError, SpringbackPoint};
pub use told::ToldStep;

/// From a bend that is to be left to the position of the bend axis, and back.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BendModel {
    /// What the wire takes back; none where the machine sees to it itself.
    pub springback: Option<Springback>,
    /// How the peg reaches the wire; none where the axis is the bend.
    pub setback: Option<PegGeometry>,
    /// How far the axis goes to either side of zero.
    pub axis_limit: Option<Angle>,
    /// Whether a bend may end with the axis at zero or before it: the machine can be told to which side it bends.
    pub before_zero: bool,
}

/// A bend that a machine cannot make.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum BendError {
    /// The axis or the peg cannot go that far.
    #[error("a bend of {bend} is out of reach: the largest to this side is {max}")]
    OutOfReach {
        /// The bend.
        bend: Angle,
        /// The largest one to the same side.
        max: Angle,
    },
    /// The axis would have to stop before the middle, and the machine takes the side of a bend from the sign of its axis.
    #[error("a bend of {bend:.2} is too small: the axis would stop before the middle")]
    TooSmall {
        /// The bend.
        bend: Angle,
    },
    /// A corner before it is so near that the peg meets the wire too late, too early or not at all.
    #[error("a bend of {bend:.2} cannot be pressed: a corner before it is within the peg's reach")]
    CornerTooNear {
        /// The bend.
        bend: Angle,
    },
    /// The wire before it, which is straight, ends before the peg touches it.
    #[error("a bend of {bend:.2} cannot be pressed: the wire before it ends within the peg's reach")]
    LeadTooShort {
        /// The bend.
        bend: Angle,
        /// How long the wire is where the bend begins.
        lead: Length,
        /// How long it has to be so that the peg touches it.
        needed: Length,
    },
    /// The wire folds back: its straight parts have no corner from which a feed could be reckoned.
    #[error("a bend of {bend:.2} folds the wire back: it has no corner to compensate feeds for")]
    FoldBack {
        /// The bend.
        bend: Angle,
    },
}

impl BendModel {
    /// The position of the axis that leaves a bend: θ* = springback(θ), then the setback of θ*. Its sign is that of the bend unless
    /// it stops before zero.
    ///
    /// # Errors
    /// [`BendError`] when the machine cannot make it.
    pub fn command(&self, bend: Angle) -> Result<Angle, BendError> {
        if bend == Angle::ZERO {
            return Ok(bend);
        }
        let out_of_reach = || BendError::OutOfReach { bend, max: self.max_bend(bend) };
        let axis = self.axis(bend).ok_or_else(out_of_reach)?;
        if axis <= Angle::ZERO && !self.before_zero {
            return Err(BendError::TooSmall { bend });
        }
        Ok(Angle::computed(bend.signum() * axis.rad()))
    }

    /// The same with wire beyond the leg that is not straight. `leg`: how long the leg is, mm, where so much of a bend is left.
    fn command_on(
        &self,
        bend: Angle,
        leg: impl Fn(Angle) -> f64,
        beyond: &Beyond,
    ) -> Result<(Angle, Touch, Option<Angle>), BendError> {
        let Some(peg) = &self.setback else {
            return self.command(bend).map(|axis| (axis, Touch::default(), None));
        };
        let side = bend.signum();
        let leg = |pressed: f64| leg(self.left(side, pressed));
        let touch = peg.pressing(self.pressed(bend).rad(), leg, beyond);
        let within = |axis: f64| self.axis_limit.is_none_or(|limit| axis.abs() <= limit.rad());
        let approach = peg.approach(leg(0.0), beyond).ok().filter(|at| at.is_none_or(within));
        // Past a corner to elsewhere only what is slight: a larger bend would be made by pushing at that corner, which gives as well.
        let is_small = || self.axis(bend).is_some_and(|axis| axis <= peg.slight());
        let forward =
            |touch: &Touch| touch.axis > 0.0 || (self.before_zero && (!touch.past_other || is_small()));
        let touch = touch.filter(|touch| forward(touch) && within(touch.axis));
        match touch.zip(approach) {
            Some((touch, approach)) => {
                let approach = approach.map(|at| Angle::computed(side * at));
                Ok((Angle::computed(side * touch.axis), touch, approach))
            }
            // Where straight wire could not be bent so either, that is the reason.
            None => Err(self.command(bend).err().unwrap_or(BendError::CornerTooNear { bend })),
        }
    }

    /// How much straight wire a bend takes, mm.
    fn arc_of(&self, bend: Angle, feed: Option<&FeedModel>) -> f64 {
        let pin = self.setback.as_ref().map_or(0.0, |peg| peg.pin * bend.abs().rad());
        feed.map_or(pin, |model| model.arc(bend).mm())
    }

    /// How far the wire has to be bent so that a bend is left, as a magnitude.
    fn pressed(&self, bend: Angle) -> Angle {
        self.springback.as_ref().map_or(bend, |model| model.bend_to(bend)).abs()
    }

    /// What is left of a wire that is pressed so far, radians, to one side.
    fn left(&self, side: f64, pressed: f64) -> Angle {
        let pressed = Angle::computed(side * pressed);
        self.springback.as_ref().map_or(pressed, |model| model.formed(pressed))
    }

    /// Magnitude of the axis position; `None` out of reach.
    fn axis(&self, bend: Angle) -> Option<Angle> {
        let pressed = self.pressed(bend);
        let axis = match &self.setback {
            Some(peg) => peg.axis_for(pressed)?,
            None => pressed,
        };
        self.axis_limit.is_none_or(|limit| axis <= limit).then_some(axis)
    }

    /// The bend that a command leaves: the inverse of [`BendModel::command`]. A command that only
    /// bends the wire within its springback leaves none. The side of the bend is the sign of the command.
    #[must_use]
    pub fn result(&self, command: Angle) -> Angle {
        self.result_to(command.signum(), command)
    }

    /// The same of a bend to a side, 1 or -1: its axis may stop before zero.
    #[must_use]
    pub fn result_to(&self, side: f64, command: Angle) -> Angle {
        let beyond_zero = Angle::computed(side * command.rad());
        let pressed = match &self.setback {
            Some(peg) => peg.bend_at(beyond_zero),
            None => beyond_zero,
        };
        self.left(side, pressed.rad())
    }

    /// The same with wire beyond the leg that is not straight. `leg`: how long the leg is, mm, where so much of a bend is left.
    fn result_on(&self, told: &ToldStep, leg: impl Fn(Angle) -> f64, beyond: &Beyond) -> Angle {
        let side = told.side();
        let Some(peg) = self.setback.as_ref().filter(|_| !beyond.is_empty()) else {
            return self.result_to(side, told.step.bend);
        };
        let left = |pressed: f64| self.left(side, pressed);
        let gap = |pressed: f64| {
            peg.touch(pressed, leg(left(pressed)), beyond)
                .map_or(1.0, |touch| touch.axis - told.beyond_zero())
        };
        let pressed = if gap(0.0) >= 0.0 { 0.0 } else { increasing_root(0.0, std::f64::consts::PI, gap) };
        left(pressed)
    }

    /// The largest bend that can be made to the side of `side`, as a magnitude up to 180°.
    #[must_use]
    pub fn max_bend(&self, side: Angle) -> Angle {
        let sign = if side < Angle::ZERO { -1.0 } else { 1.0 };
        let reachable = |size: f64| self.axis(Angle::computed(sign * size)).is_some();
        if reachable(std::f64::consts::PI) {
            return Angle::HALF_TURN;
        }
        let beyond = |size: f64| if reachable(size) { -1.0 } else { 1.0 };
        Angle::computed((increasing_root(0.0, std::f64::consts::PI, beyond) - 1e-9).max(0.0))
    }
}

/// How a machine and a material are compensated for.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Compensation {
    /// For the wire that arcs take; none leaves feeds as designed.
    pub feed: Option<FeedModel>,
    /// For the bends.
    pub bend: BendModel,
    /// For feed and head that do not do quite what they are told.
    pub motion: MotionModel,
}

/// A step that cannot be compensated.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("step {}: {error}", .step + 1)]
pub struct StepError {
    /// Index of the step, from 0.
    pub step: usize,
    /// Why.
    pub error: BendError,
}

/// A bend beyond this is a fold back: its corner is more than a thousand bend radii away.
const FOLD_DEG: f64 = 179.9;

/// Compensates a scheduled program. Whether the feeds are long enough is a check of its own.
///
/// # Errors
/// Every step whose bend the machine cannot make, whatever the wire before it.
pub fn compensate(
    program: &ScheduledProgram,
    compensation: &Compensation,
) -> Result<CompensatedProgram, Vec<StepError>> {
    let mut errors = Vec::new();
    let (mut near, mut unpressed) = (Vec::new(), Vec::new());
    let mut steps = Vec::with_capacity(program.steps.len());
    let mut approaches = Vec::with_capacity(program.steps.len());
    let mut forming = Forming::new(compensation);
    for (index, (before, step)) in with_bend_before(&program.steps).enumerate() {
        let feed = match &compensation.feed {
            Some(model) => model.feed_for(step.feed, before, step.bend),
            None => step.feed,
        };
        match forming.command(before, step) {
            Ok(Commanded { axis: bend, elsewhere, approach }) => {
                steps.push(Step { feed, rotate: step.rotate, bend });
                approaches.push(telling_side(&compensation.bend, step.bend, bend, approach));
                near.extend(elsewhere.map(|(further, past_other)| NearCorner {
                    step: index,
                    further,
                    past_other,
                }));
            }
            Err(error) => {
                let on_straight = match error {
                    BendError::CornerTooNear { bend } | BendError::LeadTooShort { bend, .. } => {
                        compensation.bend.command(bend).ok()
                    }
                    _ => None,
                };
                let error = StepError { step: index, error };
                if let Some(bend) = on_straight {
                    approaches.push(telling_side(&compensation.bend, step.bend, bend, None));
                    steps.push(Step { feed, rotate: step.rotate, bend });
                    unpressed.push(error);
                } else {
                    errors.push(error);
                }
            }
        }
    }
    if errors.is_empty() {
        compensation.motion.command(&mut steps);
        let program = CompensatedProgram::new(steps, approaches, compensation);
        return Ok(program.with_findings(near, unpressed));
    }
    errors.extend(unpressed);
    errors.sort_by_key(|error| error.step);
    Err(errors)
}

/// Where the peg comes out, which has to be said where the sign of the axis is not the side of the bend.
fn telling_side(model: &BendModel, bend: Angle, axis: Angle, approach: Option<Angle>) -> Option<Angle> {
    let peg = model.setback.as_ref().filter(|_| model.before_zero && bend != Angle::ZERO);
    let Some(near_side) = peg.map(PegGeometry::near_side) else { return approach };
    let at = approach.map_or(near_side, |at| at.abs().max(near_side));
    let told = ToldStep {
        step: Step { bend: axis, ..Step::default() },
        approach: Some(Angle::computed(-bend.signum() * at.rad())),
    };
    if told.needs_side() { told.approach } else { approach }
}

/// Where an increasing function crosses zero between two arguments; the nearer end where it does
/// not. Bisection down to the spacing of the numbers.
fn increasing_root(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    loop {
        let middle = f64::midpoint(low, high);
        if middle <= low || middle >= high {
            return middle;
        }
        if f(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
}

#[cfg(test)]
mod tests;
