//! Where the head stands, counted from where its cable is unwound: kept over connections by the holder of the record, since
//! most machines have no switch for it and forget it with their power.

use std::collections::VecDeque;
use std::fmt;

use wirebend_driver_api::{Axis, Event, HeadBy, Motion, NumberedStep, ReferenceBy, Step};

use super::{Session, SessionError};

/// Below this a turn is rounding, degrees.
pub(crate) const ROUNDING_DEG: f64 = 1e-6;

/// Closer than this the head is at its zero, degrees: finer than any of these machines turns it, and than a person reads.
const AT_ZERO_DEG: f64 = 0.05;

/// A cable allows a turn or less either way.
const CABLE_DEG: f64 = 360.0;

/// Where the head stands, degrees from its zero, in the machine's signs.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub enum HeadPlace {
    /// Nothing was ever kept of it: it is taken to stand at zero.
    #[default]
    Unsaid,
    At(f64),
    /// Somewhere from the first to the second: it was turning when it was last heard of.
    Between(f64, f64),
}

impl HeadPlace {
    fn hull(places: impl IntoIterator<Item = f64>) -> Self {
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        for place in places {
            (least, most) = (least.min(place), most.max(place));
        }
        if most - least < ROUNDING_DEG { Self::At(most) } else { Self::Between(least, most) }
    }

    /// The least and the most that it can be.
    #[must_use]
    pub const fn range(self) -> (f64, f64) {
        match self {
            Self::Unsaid => (0.0, 0.0),
            Self::At(deg) => (deg, deg),
            Self::Between(least, most) => (least, most),
        }
    }

    /// Turned by so much, from wherever it stands.
    #[must_use]
    pub fn turned(self, by: f64) -> Self {
        match self {
            Self::Unsaid => Self::Unsaid,
            Self::At(deg) => Self::At(deg + by),
            Self::Between(least, most) => Self::Between(least + by, most + by),
        }
    }

    fn turning(self, by: f64) -> Self {
        if self == Self::Unsaid {
            return self;
        }
        let ((least, most), (then_least, then_most)) = (self.range(), self.turned(by).range());
        Self::hull([least, most, then_least, then_most])
    }

    /// Whether it is known to be, or taken to be, where its cable is unwound.
    #[must_use]
    pub fn is_zero(self) -> bool {
        match self {
            Self::Unsaid => true,
            Self::At(deg) => deg.abs() < AT_ZERO_DEG,
            Self::Between(..) => false,
        }
    }
}

/// Keeps where the head stands, so that it is known when the machine is connected again.
pub trait HeadKeeper: Send {
    /// Before this returns, it is on the disk.
    ///
    /// # Errors
    /// Why it cannot be kept.
    fn keep(&mut self, place: HeadPlace) -> Result<(), String>;
}

/// The account of the head.
#[derive(Default)]
pub(super) struct Head {
    place: HeadPlace,
    keeper: Option<Box<dyn HeadKeeper>>,
    by: HeadBy,
    /// The machine counts it from its zero since it was homed through this connection.
    counted: bool,
    /// What has to be added to the machine's positions.
    base: Option<f64>,
    /// Where it stands when all that was sent is done.
    end: f64,
    /// Where it stands after each step that was sent and not done.
    ahead: VecDeque<f64>,
    /// Where it stands when the jog under way is over.
    jogged: Option<HeadPlace>,
    /// Where it stood before the line of the console that is being carried out.
    before_command: Option<HeadPlace>,
    /// The last position among the reports that are being taken.
    reported: Option<f64>,
}

impl fmt::Debug for Head {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Head").field("place", &self.place).field("by", &self.by).finish_non_exhaustive()
    }
}

impl Head {
    /// Before something moves: what cannot be kept is not moved.
    fn may_be(&mut self, place: HeadPlace) -> Result<(), SessionError> {
        if let Some(keeper) = self.keeper.as_mut().filter(|_| place != self.place) {
            keeper.keep(place).map_err(|cause| SessionError::HeadNotKept { cause })?;
        }
        self.place = place;
        Ok(())
    }

    /// After something has moved. Where that cannot be kept, the wider range of before stands in the record.
    fn is(&mut self, place: HeadPlace) {
        let _ = self.may_be(place);
        self.place = place;
    }

    /// New reports are about to be taken.
    pub fn listens(&mut self) {
        self.reported = None;
    }

    /// Before homing: the position of the head that has to be sent to the machine.
    pub fn homes(&mut self, reference: ReferenceBy) -> Result<Option<f64>, SessionError> {
        self.ahead.clear();
        if reference == ReferenceBy::Person || self.place == HeadPlace::Unsaid {
            return Ok(None);
        }
        let forgets = self.by != HeadBy::Reference && !self.counted;
        let (least, most) = self.place.range();
        if forgets && matches!(self.place, HeadPlace::Between(..)) {
            return Err(SessionError::HeadUnknown { least, most });
        }
        self.may_be(HeadPlace::hull([0.0, least, most]))?;
        Ok(forgets.then_some(least))
    }

    fn homed(&mut self, reference: ReferenceBy) {
        if reference == ReferenceBy::Person {
            // The place where it stands counts as zero on the machine, until a person says that it is.
            self.base = if let HeadPlace::At(deg) = self.place { Some(deg) } else { None };
            return;
        }
        (self.counted, self.base) = (true, Some(0.0));
        self.is(HeadPlace::At(0.0));
    }

    /// A wire, or the rest of one, is about to begin with the head to be turned to here.
    pub fn begins(&mut self, at_deg: f64) -> Result<(), SessionError> {
        if let HeadPlace::Between(least, most) = self.place {
            return Err(SessionError::HeadUnknown { least, most });
        }
        if !self.place.is_zero() {
            return Err(SessionError::OffZero { rotate_deg: self.place.range().0, bend_deg: 0.0 });
        }
        self.may_be(HeadPlace::hull([0.0, at_deg]))?;
        self.end = at_deg;
        Ok(())
    }

    /// The machine still is in a wire of before: where the head stands after each of its steps, from the last that is done.
    pub fn reattached(&mut self, made_deg: f64, steps: impl IntoIterator<Item = f64>) {
        self.ahead = steps.into_iter().collect();
        self.end = self.ahead.back().copied().unwrap_or(made_deg);
        if self.by != HeadBy::Reference {
            (self.counted, self.base) = (true, Some(0.0));
        }
        self.is(HeadPlace::hull(self.ahead.iter().copied().chain([made_deg])));
    }

    /// Before steps are sent; gives what was known before, and where all that was sent then ends.
    pub fn sends<'s>(
        &mut self,
        steps: impl Iterator<Item = &'s NumberedStep>,
    ) -> Result<(HeadPlace, f64), SessionError> {
        let before = (self.place, self.end);
        let mut end = self.end;
        let after: Vec<f64> = steps
            .map(|step| {
                end += step.step.rotate_deg;
                end
            })
            .collect();
        let (least, most) = before.0.range();
        self.may_be(HeadPlace::hull(after.iter().copied().chain([least, most])))?;
        self.ahead.extend(after);
        self.end = end;
        Ok(before)
    }

    /// So many of the last of them were not taken.
    pub fn not_taken(&mut self, count: usize, (before, end): (HeadPlace, f64)) {
        self.ahead.truncate(self.ahead.len().saturating_sub(count));
        let (least, most) = before.range();
        self.end = self.ahead.back().copied().unwrap_or(end);
        self.is(HeadPlace::hull(self.ahead.iter().copied().chain([least, most])));
    }

    /// Before a jog.
    pub fn jogs(&mut self, motion: Motion) -> Result<HeadPlace, SessionError> {
        let before = self.place;
        let by = if motion.axis == Axis::Rotate { motion.by } else { 0.0 };
        if by != 0.0 {
            self.may_be(before.turning(by))?;
            self.jogged = Some(before.turned(by));
        }
        Ok(before)
    }

    /// Before a line of the console, which may turn the head by as much as its cable allows.
    pub fn may_be_anywhere(&mut self) -> Result<HeadPlace, SessionError> {
        let before = self.place;
        // Where nobody keeps the account, nobody is asked either.
        if self.keeper.is_some() {
            let (least, most) = before.range();
            self.may_be(HeadPlace::hull([least, most, -CABLE_DEG, CABLE_DEG]))?;
            self.before_command = Some(before);
        }
        Ok(before)
    }

    /// What was to move was refused.
    pub fn stays(&mut self, place: HeadPlace) {
        (self.jogged, self.before_command) = (None, None);
        self.is(place);
    }

    pub fn hears(&mut self, event: &Event, reference: ReferenceBy) {
        match event {
            Event::Connected { head, .. } => {
                let kept = *head == HeadBy::Kept;
                (self.by, self.counted, self.base) = (*head, kept, kept.then_some(0.0));
            }
            Event::Position(Step { rotate_deg, .. }) => self.reported = Some(*rotate_deg),
            Event::Homed => self.homed(reference),
            Event::Done { .. } => {
                if let Some(made) = self.ahead.pop_front() {
                    self.is(HeadPlace::hull(self.ahead.iter().copied().chain([made])));
                }
            }
            Event::Jogged => {
                if let Some(place) = self.jogged.take() {
                    self.is(place);
                }
            }
            Event::ConsoleDone { moved, .. } => match self.before_command.take() {
                Some(before) if !moved => self.is(before),
                // It may count from elsewhere now.
                Some(_) => (self.counted, self.base) = (false, None),
                None => {}
            },
            Event::Stopped { .. } => self.stands(),
            Event::Fault { disconnected, .. } => {
                if self.by != HeadBy::Reference && !disconnected {
                    self.stands();
                }
                // It may have started anew.
                self.counted = false;
            }
            Event::SettingsWritten { .. } => (self.counted, self.base) = (false, None),
            _ => {}
        }
    }

    /// The machine stands, and has said where.
    fn stands(&mut self) {
        self.ahead.clear();
        self.jogged = None;
        if self.before_command.take().is_some() {
            // It may count from elsewhere now.
            (self.counted, self.base) = (false, None);
        }
        if let (HeadPlace::Between(..), Some(reported), Some(base)) = (self.place, self.reported, self.base) {
            self.is(HeadPlace::At(reported + base));
        }
    }
}

impl Session {
    /// Gives the session what was kept of the head, and who keeps it from now on. To be called once the machine has answered.
    pub fn keep_head(&mut self, place: HeadPlace, keeper: Box<dyn HeadKeeper>) {
        (self.head.place, self.head.keeper) = (place, Some(keeper));
    }

    #[must_use]
    pub const fn head_place(&self) -> HeadPlace {
        self.head.place
    }

    /// What knows where the head stands once the machine was switched off or reset.
    #[must_use]
    pub const fn head_by(&self) -> HeadBy {
        self.head.by
    }

    /// Whether the machine counts its head from zero by itself, or finds that: it need not be told where that stands.
    #[must_use]
    pub fn counts_its_head(&self) -> bool {
        self.head.by == HeadBy::Reference || self.head.counted
    }

    /// A person has looked where the head stands, degrees from where its cable is unwound, in the machine's signs.
    ///
    /// # Errors
    /// [`SessionError::HeadNotKept`].
    pub fn head_stands_at(&mut self, deg: f64) -> Result<(), SessionError> {
        self.head.counted = false;
        if self.reference == ReferenceBy::Person {
            // Its positions count from where it was zeroed, which may be elsewhere.
            self.head.base = None;
        }
        self.head.may_be(HeadPlace::At(deg))
    }

    /// A person has said that the head stands at its zero, which the machine has just been told to be its own.
    ///
    /// # Errors
    /// [`SessionError::HeadNotKept`].
    pub fn head_is_zeroed(&mut self) -> Result<(), SessionError> {
        self.head.base = Some(0.0);
        self.head.may_be(HeadPlace::At(0.0))
    }
}

#[cfg(test)]
mod tests;
