//! What feed and head make of what they are told: a feed that gives more or less, a head that is off or has play.

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

    /// Commands so that feeds and turns come out as these steps have them.
    pub(super) fn command(&self, steps: &mut [Step]) {
        let mut play = Play::new(self.rotate_backlash);
        for step in steps {
            step.feed = Length::computed(step.feed.mm() / self.feed_scale);
            if step.rotate != Angle::ZERO {
                let turn = step.rotate - self.rotate_offset;
                step.rotate = turn + play.lost(turn.signum(), Angle::HALF_TURN);
            }
        }
    }

    /// What commands make: the inverse.
    pub(crate) fn result<'a>(&self, told: &'a [Step]) -> Cow<'a, [Step]> {
        if self.is_exact() {
            return Cow::Borrowed(told);
        }
        let mut play = Play::new(self.rotate_backlash);
        let made = |step: &Step| {
            let mut rotate = step.rotate;
            if rotate != Angle::ZERO {
                rotate = rotate - play.lost(rotate.signum(), rotate.abs()) + self.rotate_offset;
            }
            Step { feed: Length::computed(step.feed.mm() * self.feed_scale), rotate, ..*step }
        };
        Cow::Owned(told.iter().map(made).collect())
    }
}

/// Where the drive stands within the play of the head.
struct Play {
    size: Angle,
    /// From where it turns the head to the negative side; nothing is known before the first turn, in which it is taken up.
    at: Option<Angle>,
}

impl Play {
    const fn new(size: Angle) -> Self {
        Self { size, at: None }
    }

    /// What a turn to one side loses of its way, with its sign.
    fn lost(&mut self, way: f64, most: Angle) -> Angle {
        let end = if way < 0.0 { Angle::ZERO } else { self.size };
        let at = self.at.unwrap_or(end);
        let lost = (end - at).abs().min(most);
        let lost = Angle::computed(way * lost.rad());
        self.at = Some(at + lost);
        lost
    }
}
