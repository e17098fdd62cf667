//! The session with a machine: what may be done when, and a stop that always works.

mod armed;
mod axes;
mod console;
mod cut;
mod error;
mod head;
mod listening;
mod motions;
mod orders;
mod permit;
mod permit_kind;
mod phase;
mod snapshot;
mod standstill;
mod stop;
mod stop_line;
mod stopping;

use std::cell::OnceCell;
use std::time::Duration;

use serde::de::DeserializeOwned;
use wirebend_driver_api::{
    Call, Capability, DoneBy, DriverError, Limits, ReferenceBy, ResumeState, SettingCheck, Step, deadline,
};

use crate::driver::OpenDriver;
use crate::error::HostError;
pub use armed::Armed;
use axes::AxisOffsets;
pub use error::SessionError;
use head::Head;
pub(crate) use head::ROUNDING_DEG;
pub use head::{HeadKeeper, HeadPlace};
pub(crate) use motions::turned;
pub use orders::{Because, OrderName, Orders, RefusedOrder};
use permit::Questions;
pub use permit::{Confirmation, Permit, PermitRequest, Simulation};
pub use permit_kind::PermitKind;
pub use phase::Phase;
use phase::{Act, Transition};
pub use snapshot::{Snapshot, WireProgress};
use standstill::SessionGuard;
pub use standstill::Standstill;
use stop::Arming;
pub use stop::{StopHandle, StopOutcome, StoppedBy};
pub use stop_line::{StopLine, StopLineError};

/// Whether the driver is asked for anything.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Contact {
    There,
    /// It failed, or says that the port is closed.
    Gone,
    /// It was ended because the machine may move and it is not to be trusted with that.
    Ended,
}

/// A connection to a machine through a driver. Dropping it closes the port and ends the driver.
#[derive(Debug)]
pub struct Session {
    driver: OpenDriver,
    port: String,
    /// Asked of the driver once, when it is first needed.
    is_simulated: OnceCell<bool>,
    questions: Questions,
    phase: Phase,
    position: Option<Step>,
    speed_percent: u8,
    arming: Arming,
    /// The arming, or the stop, that this session knows of.
    known: u64,
    /// How many stops it knows of.
    known_stops: u64,
    /// Steps of the wire in hand, when armed for one.
    steps: Option<u32>,
    sent: u32,
    done: u32,
    /// Since the wire in hand was begun, and what is estimated to be left of it. Nothing once another is permitted.
    times: Option<(Duration, Duration)>,
    /// How far rotate and bend axis are from their reference, degrees, in the machine's signs.
    off: AxisOffsets,
    /// Settings of the machine with which wires come out wrong, as long as no person has accepted them.
    differences: Vec<SettingCheck>,
    /// What the machine itself says of its axes.
    limits: Limits,
    /// The driver was given the token of an earlier arming.
    resuming: bool,
    /// What the machine said of it.
    resume: Option<ResumeState>,
    /// The last that the machine said of holding.
    holds: bool,
    guard: SessionGuard,
    /// What the machine says that it is.
    identity: String,
    contact: Contact,
    /// Whether the machine or a person brings its axes to their reference.
    reference: ReferenceBy,
    /// What reports that a step is done.
    done_by: DoneBy,
    head: Head,
}

impl Session {
    /// Opens a port. The machine's answer comes by [`Session::poll`]; until then the state is
    /// [`Phase::Connecting`]. `line` is the program's own way to the port, by which it stops the machine where the
    /// driver does not, or is lost while the machine may move. It has to be opened before: see [`StopLine::open`].
    ///
    /// # Errors
    /// [`SessionError::Unsupported`] for a driver that only writes files; [`SessionError::Host`] when the
    /// port cannot be opened.
    pub fn connect(driver: OpenDriver, port: &str, line: Option<StopLine>) -> Result<Self, SessionError> {
        Self::connected(driver, port, None, line)
    }

    /// The same with the token of an earlier arming: where the machine still is in that wire, it becomes
    /// [`Phase::Interrupted`], and [`Session::resume_state`] gives how far it is. What it has taken already it may
    /// run by itself; everything else needs [`Session::reattach`].
    ///
    /// # Errors
    /// As [`Session::connect`].
    pub fn connect_resuming(
        driver: OpenDriver,
        port: &str,
        token: &str,
        line: Option<StopLine>,
    ) -> Result<Self, SessionError> {
        Self::connected(driver, port, Some(token.to_owned()), line)
    }

    fn connected(
        driver: OpenDriver,
        port: &str,
        resume: Option<String>,
        line: Option<StopLine>,
    ) -> Result<Self, SessionError> {
        let arming = Arming::first();
        let session = Self {
            driver,
            port: port.to_owned(),
            is_simulated: OnceCell::new(),
            questions: Questions::default(),
            phase: Phase::Connecting,
            position: None,
            speed_percent: 100,
            known: arming.now(),
            known_stops: arming.stops(),
            arming,
            steps: None,
            sent: 0,
            done: 0,
            times: None,
            off: AxisOffsets::default(),
            differences: Vec::new(),
            limits: Limits::default(),
            resuming: resume.is_some(),
            resume: None,
            holds: false,
            guard: SessionGuard::default(),
            identity: String::new(),
            contact: Contact::There,
            reference: ReferenceBy::default(),
            done_by: DoneBy::default(),
            head: Head::default(),
        };
        session.require(Capability::Live)?;
        session.guard.use_line(line);
        let guard = session.guard.copy();
        session.driver.handle().when_lost(move || guard.driver_is_lost());
        if session.resuming {
            // It may be in the middle of the wire.
            session.guard.may_move();
        }
        session.driver.call("connecting", &Call::Connect { port: port.to_owned(), resume })?;
        Ok(session)
    }

    /// How far the machine was in the wire of the token when it was connected; `None` when it is not in it any
    /// more, or was not asked.
    #[must_use]
    pub const fn resume_state(&self) -> Option<ResumeState> {
        self.resume
    }

    /// How far the head is turned from its reference, degrees, in the machine's signs, as far as it is known.
    #[must_use]
    pub const fn head_deg(&self) -> f64 {
        self.off.rotate_deg()
    }

    /// What the machine says that it is; empty before it has answered.
    #[must_use]
    pub fn identity(&self) -> &str {
        &self.identity
    }

    /// Whether the machine or a person brings the axes to their reference. Where a person does, [`Session::home`] moves
    /// nothing, and their yes has to be that the axes stand there.
    #[must_use]
    pub const fn reference(&self) -> ReferenceBy {
        self.reference
    }

    /// What reports that a step is done: the machine, or the clock alone.
    #[must_use]
    pub const fn done_by(&self) -> DoneBy {
        self.done_by
    }

    /// What the machine is in.
    #[must_use]
    pub const fn phase(&self) -> Phase {
        self.phase
    }

    /// Whether the wire that it was armed for last is done: nothing was asked of the machine since.
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.phase == Phase::Ready && self.steps == Some(self.done)
    }

    #[must_use]
    pub const fn driver(&self) -> &OpenDriver {
        &self.driver
    }

    /// The last step that was sent, and the last that is done.
    #[must_use]
    pub const fn progress(&self) -> (u32, u32) {
        (self.sent, self.done)
    }

    /// Settings of the machine with which wires come out wrong; none when a person has accepted them.
    #[must_use]
    pub fn differences(&self) -> &[SettingCheck] {
        &self.differences
    }

    /// What the machine itself says of how far its axes go and how fast.
    #[must_use]
    pub const fn machine_limits(&self) -> &Limits {
        &self.limits
    }

    /// Refuses a step that the driver or its machine would bend to the wrong side. `at`: which step it is.
    ///
    /// # Errors
    /// [`HostError::Refused`].
    pub fn takes(&self, at: &str, step: &Step) -> Result<(), HostError> {
        self.driver.takes(at, step)?;
        let lacks = self.limits.lacks.iter().find(|lack| lack.capability == Capability::BeforeZero);
        let Some(lack) = lacks.filter(|_| step.ends_before_zero()) else { return Ok(()) };
        let message = format!(
            "the bend axis stops before zero in {at}, at {:.2}°, and the machine is not told to which side that is: {}",
            step.bend_deg, lack.reason
        );
        let error = DriverError::new("unsupported", message, lack.help.clone());
        Err(HostError::Refused { driver: self.driver.description().id.clone(), error })
    }

    /// Bends wires although settings of the machine differ.
    ///
    /// # Errors
    /// [`SessionError`] where the permit does not hold or is not for a wire.
    pub fn accept_differences(&mut self, permit: &Permit) -> Result<(), SessionError> {
        self.permits(permit, "accepting settings that differ", &[PermitKind::Wire])?;
        self.differences.clear();
        Ok(())
    }

    /// Closes the port and gives the driver back.
    ///
    /// # Errors
    /// [`SessionError::Host`]; the port is closed in any case, for the driver is ended then.
    pub fn disconnect(self) -> Result<OpenDriver, SessionError> {
        self.driver.call("disconnecting", &Call::Disconnect)?;
        self.share_port();
        Ok(self.driver)
    }

    /// Whether no stop has come of which this session does not know yet.
    fn unstopped(&self) -> impl FnOnce() -> bool + use<> {
        let (arming, known) = (self.arming.clone(), self.known);
        move || arming.now() == known
    }

    /// A call that moves the machine or leads to it: not after a stop.
    fn motion(&self, during: &'static str, call: &Call) -> Result<(), HostError> {
        self.motion_for::<serde_json::Value>(during, call).map(drop)
    }

    /// From here on the machine may move, unless the driver says no.
    fn motion_for<T: DeserializeOwned>(&self, during: &'static str, call: &Call) -> Result<T, HostError> {
        let before = self.guard.may_move();
        let called = self.driver.motion_for(during, call, deadline::CALL, self.unstopped());
        if let Err(HostError::Refused { .. } | HostError::StoppedBefore { .. }) = &called
            && !before
        {
            self.guard.rests();
        }
        called
    }

    fn may(&self, act: Act) -> Result<Phase, SessionError> {
        // After a fault, too, nothing begins before the machine stands.
        let awaited = self.guard.standstill() == Some(Standstill::Awaited);
        let state = if awaited && self.phase == Phase::Failed { Phase::Stopping } else { self.phase };
        match state.on(act) {
            Transition::To(next) => Ok(next),
            Transition::Refused { expected } => Err(SessionError::State { act, state, expected }),
        }
    }

    fn valid(&self, armed: &Armed) -> Result<(), SessionError> {
        if armed.arming == self.arming.now() { Ok(()) } else { Err(SessionError::Stale) }
    }

    fn require(&self, capability: Capability) -> Result<(), SessionError> {
        let description = self.driver.description();
        if description.can(capability) {
            return Ok(());
        }
        Err(SessionError::Unsupported { driver: description.id.clone(), capability })
    }

    /// A refusal leaves the machine as it is; any other failure of the driver is a fault.
    fn faulting<T>(&mut self, result: Result<T, HostError>) -> Result<T, SessionError> {
        match &result {
            Err(HostError::Refused { error, .. }) if error.has_panicked() => self.driver_failed(),
            Ok(_) | Err(HostError::Refused { .. }) => {}
            Err(HostError::StoppedBefore { .. }) => self.notice_stop(),
            Err(_) => self.driver_failed(),
        }
        result.map_err(SessionError::from)
    }
}
