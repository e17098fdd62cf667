//! What moves the machine, leads to it, or holds it.

use wirebend_driver_api::{
    ArmedReply, Axis, Batch, Call, Capability, Motion, NumberedStep, Run, Sent, Step, deadline,
};

use super::phase::Act;
use super::{Armed, HeadPlace, Permit, PermitKind, Phase, Session, SessionError};
use crate::error::HostError;

impl Session {
    /// Lets the machine find its reference: it moves. Where a person has brought the axes there
    /// ([`Session::reference`]) nothing moves, and the place where they stand is taken as zero.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn home(&mut self, permit: &Permit) -> Result<(), SessionError> {
        self.require(Capability::Home)?;
        self.may(Act::Home)?;
        self.permits(permit, "homing", &[PermitKind::Wire, PermitKind::ByHand])?;
        // What was reported before is not about this homing; but a stop that comes only to light now came after the
        // person's yes.
        let (known, before) = (self.known, self.phase);
        self.poll()?;
        if self.known != known || (self.phase == Phase::Stopped && before != Phase::Stopped) {
            return Err(SessionError::Stale);
        }
        let next = self.may(Act::Home)?;
        self.guard.forget();
        let place = self.head_place();
        let head_at_deg = self.head.homes(self.reference)?;
        let called = self.motion("homing", &Call::Home { head_at_deg });
        self.faulting_before(called, place)?;
        (self.phase, self.steps) = (next, None);
        Ok(())
    }

    /// Makes ready for one wire of a job, or for the rest of one: from the step after [`Run::after`] on. The token that
    /// this gives is what every motion needs; it ends with the wire, with a stop, a fault, or another arming.
    ///
    /// Both axes have to be at their reference. The driver learns from [`Run::rotate_at_deg`] where the head has to stand
    /// first.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn arm(&mut self, run: Run, permit: Permit) -> Result<Armed, SessionError> {
        let next = self.may(Act::Arm)?;
        self.uses_up(permit, "bending a wire", PermitKind::Wire)?;
        self.guard.forget();
        let (steps, after, rotate_at_deg) = (run.steps, run.after, run.rotate_at_deg);
        self.off.require_zero()?;
        if !self.differences.is_empty() {
            return Err(SessionError::SettingsDiffer { settings: self.differences.clone() });
        }
        if after > steps || !rotate_at_deg.is_finite() {
            return Err(SessionError::Steps { sent: after, total: steps });
        }
        if (after > 0 || rotate_at_deg != 0.0) && self.driver.minor() == 0 {
            let driver = self.driver.description().id.clone();
            return Err(SessionError::TooOld { driver, after });
        }
        let place = self.head_place();
        self.head.begins(rotate_at_deg)?;
        let token = self.call_to_arm(run, place)?;
        self.off.head_stands_at(rotate_at_deg);
        let armed = self.armed(token)?;
        (self.phase, self.steps, self.sent, self.done) = (next, Some(steps), after, after);
        self.times = Some(Default::default());
        Ok(armed)
    }

    /// Whether the driver turns the head to its place before a new wire, too; all do before the rest of one.
    #[must_use]
    pub const fn turns_head_first(&self) -> bool {
        self.driver.minor() >= 7
    }

    /// Makes ready for moves by hand. The token ends as that of [`Session::arm`].
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn arm_by_hand(&mut self, permit: &Permit) -> Result<Armed, SessionError> {
        let next = self.may(Act::ArmByHand)?;
        self.permits(permit, "moving by hand", &[PermitKind::ByHand])?;
        self.guard.forget();
        let armed = self.armed(None)?;
        (self.phase, self.steps, self.sent, self.done) = (next, None, 0, 0);
        Ok(armed)
    }

    /// Resumes the wire that the machine still is in, after [`Session::connect_resuming`]: `run` is that of
    /// the wire, `steps` are all of its steps, of the next of which the head was turned by `begun_deg` before the machine
    /// was sent the rest. Nothing new moves for it; the token that this gives is what
    /// sending and, where the machine holds, resuming need.
    ///
    /// # Errors
    /// [`SessionError`], such as [`SessionError::Steps`] for a wire that has fewer steps than the machine has
    /// taken.
    pub fn reattach(
        &mut self,
        run: Run,
        steps: &[Step],
        begun_deg: f64,
        permit: Permit,
    ) -> Result<Armed, SessionError> {
        let next = self.may(Act::Reattach)?;
        self.uses_up(permit, "bending a wire", PermitKind::Wire)?;
        self.guard.forget();
        if !self.differences.is_empty() {
            return Err(SessionError::SettingsDiffer { settings: self.differences.clone() });
        }
        let total = run.steps;
        if usize::try_from(total) != Ok(steps.len()) || self.sent > total {
            return Err(SessionError::Steps { sent: self.sent, total });
        }
        let begun = |n: u32| if n == self.done { begun_deg } else { 0.0 };
        let stands = |n: u32| turned(steps, n) + begun(n);
        let (rotate_at_deg, head) = (stands(self.done), stands(self.sent));
        let run = Run { after: self.done, rotate_at_deg, rotate_taken_deg: Some(head), ..run };
        let token = self.call_to_arm(run, self.head_place())?;
        let armed = self.armed(token)?;
        self.off.head_stands_at(head);
        let ahead = (self.done + 1..=self.sent).map(|n| turned(steps, n));
        self.head.reattached(rotate_at_deg, ahead);
        (self.steps, self.times) = (Some(total), Some(Default::default()));
        self.phase = if self.holds { Phase::Holding } else { next };
        Ok(armed)
    }

    /// Sends steps of the wire, from the one after the last that was sent. The driver takes as many as it
    /// has room for. When all were sent, none are: that the wire ends with them is said again, as a wire that
    /// was reattached needs it.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn send(&mut self, armed: &Armed, steps: &[NumberedStep]) -> Result<Sent, SessionError> {
        self.valid(armed)?;
        let next = self.may(Act::Send)?;
        let Some(total) = self.steps else { return Err(SessionError::NotForAWire) };
        let follows = steps.iter().zip(self.sent + 1..).all(|(step, n)| step.n == n);
        let last = steps.last().map_or(self.sent, |last| last.n);
        if !follows || last > total || (steps.is_empty() && last < total) {
            return Err(SessionError::Steps { sent: self.sent, total });
        }
        steps.iter().try_for_each(|step| self.takes(&format!("step {}", step.n), &step.step))?;
        let call = Call::Send(Batch { steps: steps.to_vec(), last: last == total });
        let place = self.head.sends(steps.iter())?;
        let called = self.motion_for("sending steps", &call);
        if let Err(HostError::Refused { .. } | HostError::StoppedBefore { .. }) = &called {
            self.head.not_taken(steps.len(), place);
        }
        let taken: Sent = self.faulting(called)?;
        // To nothing some drivers answer with nothing.
        let accepted = if steps.is_empty() { self.sent } else { taken.accepted };
        if accepted < self.sent || accepted > last {
            self.driver_failed();
            return Err(SessionError::OutOfOrder { n: accepted, done: self.sent, sent: last });
        }
        let newly = steps.iter().filter(|step| step.n <= accepted);
        newly.for_each(|step| self.off.turned(Axis::Rotate, step.step.rotate_deg));
        self.head.not_taken(steps.iter().filter(|step| step.n > accepted).count(), place);
        self.sent = accepted;
        self.phase = next;
        Ok(Sent { accepted, ..taken })
    }

    /// Moves one axis. On a machine that bends with a peg, a jog of the bend axis is a whole bend.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn jog(&mut self, armed: &Armed, motion: Motion) -> Result<(), SessionError> {
        self.require(Capability::Jog)?;
        if motion.dry {
            self.require(Capability::DryRun)?;
        }
        self.valid(armed)?;
        let next = self.may(Act::Jog)?;
        if self.steps.is_some() {
            return Err(SessionError::ForAWire);
        }
        let place = self.head.jogs(motion)?;
        let called = self.motion("jogging", &Call::Jog(motion));
        self.faulting_before(called, place)?;
        if !(motion.dry && motion.axis == Axis::Bend) {
            self.off.turned(motion.axis, motion.by);
        }
        self.phase = next;
        Ok(())
    }

    /// The moves by hand are over: the token of [`Session::arm_by_hand`] is not used any more.
    pub fn end_moves(&mut self) {
        if self.phase == Phase::Moving {
            self.phase = Phase::Ready;
        }
    }

    /// Holds the machine; the phase changes when the machine says that it does.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn pause(&mut self) -> Result<(), SessionError> {
        self.require(Capability::Pause)?;
        self.may(Act::Pause)?;
        let called = self.driver.call("pausing", &Call::Pause);
        self.faulting(called)
    }

    /// The wire is bent at so many percent of the programmed speed from now on; [`Snapshot::speed_percent`](super::Snapshot::speed_percent)
    /// says what became of it.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn set_speed(&mut self, percent: u8) -> Result<(), SessionError> {
        self.require(Capability::Speed)?;
        self.may(Act::Speed)?;
        let called = self.driver.call("changing the speed", &Call::Speed { percent });
        self.faulting(called)
    }

    /// Resumes after a pause: the machine moves.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn resume(&mut self, armed: &Armed) -> Result<(), SessionError> {
        self.require(Capability::Resume)?;
        self.valid(armed)?;
        self.may(Act::Resume)?;
        let called = self.motion("resuming", &Call::Resume);
        self.faulting(called)
    }

    /// Writes the driver's settings to the machine, for good; `settings-written` reports what came of it. Nothing
    /// moves. The machine has to be homed afterwards, since its axes may count otherwise.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn write_settings(&mut self, permit: Permit) -> Result<(), SessionError> {
        self.require(Capability::Settings)?;
        let next = self.may(Act::WriteSettings)?;
        self.uses_up(permit, "writing settings", PermitKind::Settings)?;
        let call = Call::WriteSettings;
        let called = self
            .driver
            .motion_for::<serde_json::Value>("writing settings", &call, deadline::CALL, self.unstopped())
            .map(drop);
        self.faulting(called)?;
        self.phase = next;
        Ok(())
    }

    /// A refusal leaves the head where it was.
    pub(super) fn faulting_before<T>(
        &mut self,
        called: Result<T, HostError>,
        place: HeadPlace,
    ) -> Result<T, SessionError> {
        if let Err(HostError::Refused { .. } | HostError::StoppedBefore { .. }) = &called {
            self.head.stays(place);
        }
        self.faulting(called)
    }

    /// `place`: where the head stands, and stays if the driver refuses.
    fn call_to_arm(&mut self, run: Run, place: HeadPlace) -> Result<Option<String>, SessionError> {
        let called = self.driver.motion_for("arming", &Call::Arm(run), deadline::CALL, self.unstopped());
        Ok(self.faulting_before::<ArmedReply>(called, place)?.token)
    }

    /// The next token, unless a stop came first.
    fn armed(&mut self, token: Option<String>) -> Result<Armed, SessionError> {
        let Some(arming) = self.arming.follow(self.known) else {
            self.notice_stop();
            return Err(SessionError::Stale);
        };
        self.known = arming;
        Ok(Armed { arming, token })
    }
}

/// How far the first steps turn the head together, degrees, in the machine's signs.
pub(crate) fn turned(steps: &[Step], count: u32) -> f64 {
    let count = usize::try_from(count).unwrap_or(usize::MAX);
    // The sum of nothing is zero, without a sign.
    steps.iter().take(count).fold(0.0, |sum, step| sum + step.rotate_deg)
}
