//! The machine: counts pulses, follows the peg, and lets the wire go.

use wirebend_driver_api::Axis;

use super::chain::Chain;
use super::formed::Met;
use super::incident::{Incident, ModelWarning, Violation};
use super::made::Made;
use super::noise::{Draws, Noise};
use super::press::{Compliance, Press};
use super::settings::{BenchError, Bender, Drives, Scale, Wire, demand, positive};

/// Peg and wire that overlap by less than this only touch. Radians, 0.06 degrees: some steps of the
/// bend axis.
const TOUCH: f64 = 1e-3;

/// Where the bending peg is, up or down its guide.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Peg {
    /// Below the wire: it meets nothing.
    #[default]
    In,
    /// On its way. It meets the wire.
    Between,
    /// All the way up. It meets the wire.
    Out,
}

/// Pulses one way on one axis.
#[derive(Debug, Clone, Copy)]
struct Motion {
    axis: Axis,
    forward: bool,
    steps: f64,
}

/// The peg while it is not in.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stroke {
    /// 1 where the peg is on the wire's right side and bends it to the left, -1 the other way round.
    pub side: i32,
    /// Where the bend axis stood when it came out, in steps, positive where the peg pushes.
    pub from: i64,
    /// Furthest place of the bend axis towards that side, in steps, positive where the peg pushes.
    pub furthest: i64,
}

impl Stroke {
    pub fn sign(self) -> f64 {
        f64::from(self.side)
    }
}

/// A bender with wire in it. Its pulses have no time: only their order counts.
///
/// A pulse costs a few nanoseconds. The wire is worked out when it is let go.
#[derive(Debug, Clone)]
pub struct Bench {
    pub(super) press: Press,
    scale: Scale,
    bend_limit_deg: f64,
    head_limit_deg: f64,
    pub(super) draws: Option<Draws>,
    pub(super) chain: Chain,
    pub(super) doubts: Vec<ModelWarning>,
    /// How many times the wire was pressed.
    pub(super) presses: usize,
    incidents: Vec<Incident>,
    pulses: u64,
    fed_steps: i64,
    head_steps: i64,
    bend_steps: i64,
    /// What errors have turned the head by, degrees.
    head_error_deg: f64,
    drives: Drives,
    /// Where the drive stands within the backlash of the head, from where it turns the head to the negative side. Before the first turn
    /// it stands where that turn needs it.
    slack_deg: Option<f64>,
    motion: Option<Motion>,
    peg: Peg,
    pub(super) stroke: Option<Stroke>,
}

impl Bench {
    /// A bender whose axes stand at zero, whose peg is in, and whose wire ends at the nozzle's exit.
    ///
    /// # Errors
    /// [`BenchError`] where a figure cannot be, or the peg would not push the wire on steadily.
    pub fn new(bender: Bender, wire: Wire, scale: Scale, compliance: Compliance) -> Result<Self, BenchError> {
        scale.check()?;
        Ok(Self {
            press: Press::new(&bender, &wire, compliance)?,
            scale,
            bend_limit_deg: bender.axis_limit_deg,
            head_limit_deg: f64::INFINITY,
            draws: None,
            chain: Chain::default(),
            doubts: Vec::new(),
            presses: 0,
            incidents: Vec::new(),
            pulses: 0,
            fed_steps: 0,
            head_steps: 0,
            bend_steps: 0,
            head_error_deg: 0.0,
            drives: Drives::EXACT,
            slack_deg: None,
            motion: None,
            peg: Peg::In,
            stroke: None,
        })
    }

    /// The same with motions that are off.
    ///
    /// # Errors
    /// [`BenchError::Figure`] where an error is not a finite number or its deviation negative.
    pub fn with_noise(mut self, noise: &Noise) -> Result<Self, BenchError> {
        self.draws = Some(Draws::new(noise)?);
        Ok(self)
    }

    /// The same with a feed and a head that do not make what their pulses say.
    ///
    /// # Errors
    /// [`BenchError::Figure`] where the scale is not positive, the offset not finite or the backlash negative.
    pub fn with_drives(mut self, drives: Drives) -> Result<Self, BenchError> {
        drives.check()?;
        self.drives = drives;
        Ok(self)
    }

    /// The same with a head that must stay within so many degrees either way of zero.
    ///
    /// # Errors
    /// [`BenchError::Figure`] where that is not a positive number.
    pub fn with_head_limit(mut self, limit_deg: f64) -> Result<Self, BenchError> {
        positive("the head's limit", limit_deg)?;
        self.head_limit_deg = limit_deg;
        Ok(self)
    }

    /// The same with the bend axis somewhere else, as after a machine was pushed by hand. The nearest step
    /// is taken.
    ///
    /// # Errors
    /// [`BenchError::Figure`] where that is beyond half a turn.
    pub fn with_bend_axis_at(mut self, axis_deg: f64) -> Result<Self, BenchError> {
        demand(axis_deg.abs() <= 180.0, "the bend axis", axis_deg, "an angle from -180 to 180")?;
        #[expect(
            clippy::cast_possible_truncation,
            reason = "saturates; a step is far larger than 1e-16 degrees"
        )]
        let steps = (axis_deg / self.scale.bend_deg_per_step).round() as i64;
        self.bend_steps = steps;
        Ok(self)
    }

    /// One pulse on the step pin of an axis.
    pub fn step(&mut self, axis: Axis, forward: bool) {
        match &mut self.motion {
            Some(motion) if motion.axis == axis && motion.forward == forward => {
                motion.steps += 1.0;
                self.pulses += 1;
            }
            _ => {
                self.end_motion();
                self.pulses += 1;
                self.begin(axis, forward);
            }
        }
        let by = if forward { 1 } else { -1 };
        match axis {
            Axis::Feed => self.fed_steps += by,
            Axis::Rotate => {
                let before = self.head_deg();
                self.head_steps += by;
                let head_deg = self.head_deg();
                let slack = self.head_limit_deg + self.scale.rotate_deg_per_step / 2.0;
                if head_deg.abs() > slack && before.abs() <= slack {
                    self.record(Violation::HeadPastLimit { head_deg });
                }
            }
            Axis::Bend => {
                let before = self.bend_axis_deg();
                self.bend_steps += by;
                if let Some(stroke) = &mut self.stroke {
                    stroke.furthest = stroke.furthest.max(i64::from(stroke.side) * self.bend_steps);
                }
                let axis_deg = self.bend_axis_deg();
                let slack = self.bend_limit_deg + self.scale.bend_deg_per_step / 2.0;
                if axis_deg.abs() > slack && before.abs() <= slack {
                    self.record(Violation::BendPastLimit { axis_deg });
                }
            }
        }
    }

    /// The peg has come to another place. The same place again changes nothing.
    pub fn peg(&mut self, peg: Peg) {
        let before = std::mem::replace(&mut self.peg, peg);
        self.end_motion();
        match (before, peg) {
            (Peg::In, Peg::Between | Peg::Out) => self.take_side(),
            (Peg::Between | Peg::Out, Peg::In) => {
                self.let_go();
                if self.touches() {
                    self.record(Violation::PegInUnderLoad { axis_deg: self.bend_axis_deg() });
                }
                self.stroke = None;
            }
            _ => {}
        }
    }

    /// The wire as it would be if it were let go and cut off at the nozzle now. The bench continues.
    #[must_use]
    pub fn made(&self) -> Made {
        let mut bench = self.clone();
        bench.end_motion();
        bench.let_go();
        Made { chain: bench.chain, off_centre: self.press.off_centre(), doubts: bench.doubts }
    }

    /// What the controller should not have done, in order.
    #[must_use]
    pub fn incidents(&self) -> &[Incident] {
        &self.incidents
    }

    /// How many pulses have come, of all axes.
    #[must_use]
    pub fn pulses(&self) -> u64 {
        self.pulses
    }

    /// What the pulses have fed, without errors.
    #[must_use]
    pub fn fed_mm(&self) -> f64 {
        steps(self.fed_steps) * self.scale.feed_mm_per_step
    }

    /// Where the pulses have turned the head, without errors.
    #[must_use]
    pub fn head_deg(&self) -> f64 {
        steps(self.head_steps) * self.scale.rotate_deg_per_step
    }

    #[must_use]
    pub fn bend_axis_deg(&self) -> f64 {
        steps(self.bend_steps) * self.scale.bend_deg_per_step
    }

    #[must_use]
    pub fn peg_at(&self) -> Peg {
        self.peg
    }

    /// How the head stands about the wire, with its errors. Radians.
    pub(super) fn head(&self) -> f64 {
        (self.head_deg() + self.head_error_deg).to_radians()
    }

    /// A place of the bend axis, radians.
    pub(super) fn axis(&self, place: i64) -> f64 {
        (steps(place) * self.scale.bend_deg_per_step).to_radians()
    }

    pub(super) fn bend_steps(&self) -> i64 {
        self.bend_steps
    }

    fn begin(&mut self, axis: Axis, forward: bool) {
        self.motion = Some(Motion { axis, forward, steps: 1.0 });
        match (self.peg, axis) {
            (Peg::In, _) | (Peg::Out, Axis::Bend) => {}
            (Peg::Between, Axis::Bend) => self.record(Violation::BentWithPegBetween),
            (_, Axis::Feed) => {
                self.let_go();
                self.record(Violation::FedWithPeg { touching: self.touches() });
            }
            (_, Axis::Rotate) => {
                self.let_go();
                self.record(Violation::RotatedWithPeg { touching: self.touches() });
            }
        }
    }

    /// Brings what an axis has done one way into the wire.
    fn end_motion(&mut self) {
        let Some(motion) = self.motion.take() else { return };
        let sign = if motion.forward { 1.0 } else { -1.0 };
        match (motion.axis, &mut self.draws) {
            (Axis::Feed, draws) => {
                let told = sign * motion.steps * self.scale.feed_mm_per_step * self.drives.feed_scale;
                let error = draws.as_mut().map_or(0.0, |draws| draws.feed_mm.next());
                let by_mm = self.chain.feed(told + error) + error.min(0.0);
                // A feed that only its error makes too short is no mistake of the controller.
                if told < 0.0 && by_mm > 1e-6 {
                    self.record(Violation::PulledTooFar { by_mm });
                }
            }
            (Axis::Rotate, draws) => {
                let error = draws.as_mut().map_or(0.0, |draws| draws.rotate_deg.next());
                let turn_deg = motion.steps * self.scale.rotate_deg_per_step;
                let lost_deg = self.take_up_backlash(motion.forward, turn_deg);
                self.head_error_deg += self.drives.rotate_offset_deg - sign * lost_deg + error;
            }
            (Axis::Bend, _) => {}
        }
    }

    /// What of a turn the drive makes before the head turns with it.
    fn take_up_backlash(&mut self, forward: bool, turn_deg: f64) -> f64 {
        let end = if forward { self.drives.rotate_backlash_deg } else { 0.0 };
        let at = self.slack_deg.unwrap_or(end);
        let lost = (end - at).abs().min(turn_deg);
        self.slack_deg = Some(if forward { at + lost } else { at - lost });
        lost
    }

    /// The peg comes up on one side of the wire, or into it.
    fn take_side(&mut self) {
        let at = self.axis(self.bend_steps);
        // Legs between these two overlap the peg; those of more are on its left, of less on its right.
        let (right, left) = (-self.press.contact.leg_angle(-at), self.press.contact.leg_angle(at));
        let side = match self.leg() {
            None if at <= 0.0 => 1,
            None => -1,
            Some(leg) if leg >= left - TOUCH => 1,
            Some(leg) if leg <= right + TOUCH => -1,
            Some(leg) => {
                self.record(Violation::PegIntoWire { axis_deg: self.bend_axis_deg() });
                if left - leg <= leg - right { 1 } else { -1 }
            }
        };
        let from = i64::from(side) * self.bend_steps;
        let stroke = Stroke { side, from, furthest: from };
        if self.comes_into_formed(&stroke) {
            self.record(Violation::PegIntoWire { axis_deg: self.bend_axis_deg() });
        }
        self.stroke = Some(stroke);
    }

    /// Whether the peg pushes the wire, which must have been let go before it is asked.
    fn touches(&self) -> bool {
        let (Some(stroke), Some(leg)) = (self.stroke, self.leg()) else { return false };
        let at = self.axis(i64::from(stroke.side) * self.bend_steps);
        matches!(self.met(&stroke, at), Met::Held(held) if held.leg > stroke.sign() * leg + TOUCH)
    }

    fn record(&mut self, what: Violation) {
        self.incidents.push(Incident { pulse: self.pulses, what });
    }
}

/// A count of steps as a number: exact up to 2^53.
#[expect(clippy::cast_precision_loss, reason = "a machine is worn out before it makes 2^53 steps")]
fn steps(count: i64) -> f64 {
    count as f64
}
