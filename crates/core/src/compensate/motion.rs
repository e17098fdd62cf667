//! What feed and head make of what they are told: a feed that gives more or less, a head that is off or has backlash.

use std::borrow::Cow;

use crate::bend::Step;
use crate::units::{Angle, Length};

/// How feed and head are off, as a calibration finds it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotionModel {
    /// Wire that is fed for each commanded millimetre; above zero.
    pub feed_scale: f64,
    /// What every turn of the head is off by.
    pub rotate_offset: Angle,
    /// What a turn loses that goes against the one before; not negative.
    pub rotate_backlash: Angle,
}

impl Default for MotionModel {
    fn default() -> Self {
        Self { feed_scale: 1.0, rotate_offset: Angle::ZERO, rotate_backlash: Angle::ZERO }
    }
}

impl MotionModel {
    /// Whether feed and head do what they are told.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        *self == Self::default()
    }

    /// The feed to command for so much wire.
    #[must_use]
    pub fn commanded(&self, wire: Length) -> Length {
        Length::computed(wire.mm() / self.feed_scale)
    }

    /// Wire that a commanded feed gives.
    #[must_use]
    pub fn fed(&self, commanded: Length) -> Length {
        Length::computed(commanded.mm() * self.feed_scale)
    }

    /// Commands so that feeds and turns come out as these steps have them.
    pub(super) fn command(&self, steps: &mut [Step]) {
        let mut backlash = Backlash::new(self.rotate_backlash);
        for step in steps {
            step.feed = self.commanded(step.feed);
            if is_turn(step.rotate) {
                step.rotate -= self.rotate_offset;
            }
            // Where the offset alone turns the head, nothing is commanded, and the drive stays where it is.
            if is_turn(step.rotate) {
                step.rotate += backlash.take_up(step.rotate.signum(), self.rotate_backlash);
            }
        }
    }

    /// What commands make: the inverse.
    pub(crate) fn result<'a>(&self, told: &'a [Step]) -> Cow<'a, [Step]> {
        if self.is_exact() {
            return Cow::Borrowed(told);
        }
        let mut backlash = Backlash::new(self.rotate_backlash);
        let made = |step: &Step| {
            let mut rotate = step.rotate;
            if is_turn(rotate) {
                rotate = rotate - backlash.take_up(rotate.signum(), rotate.abs()) + self.rotate_offset;
            }
            Step { feed: self.fed(step.feed), rotate, ..*step }
        };
        Cow::Owned(told.iter().map(made).collect())
    }
}

/// Less is what numbers are rounded by, degrees: no head turns so little.
const LEAST_TURN_DEG: f64 = 1e-6;

/// Whether an axis turns, and so can be off.
#[must_use]
pub fn is_turn(turn: Angle) -> bool {
    turn.abs().deg() > LEAST_TURN_DEG
}

/// Where the drive stands within the backlash of the head.
struct Backlash {
    size: Angle,
    /// From where it turns the head to the negative side; before the first turn it is not known, and taken to be where that turn needs it.
    at: Option<Angle>,
}

impl Backlash {
    const fn new(size: Angle) -> Self {
        Self { size, at: None }
    }

    /// What a command to one side loses until the head turns, `max` of it at most; with its sign.
    fn take_up(&mut self, direction: f64, max: Angle) -> Angle {
        let end = if direction < 0.0 { Angle::ZERO } else { self.size };
        let at = self.at.unwrap_or(end);
        let lost = (end - at).abs().min(max);
        let lost = Angle::computed(direction * lost.rad());
        self.at = Some(at + lost);
        lost
    }
}
