//! The session with a machine: what may be done when, and a stop that always works.

mod armed;
mod axes;
mod error;
mod head;
mod listening;
mod motions;
mod standstill;
mod state;
mod stop;
mod stop_line;

use serde::de::DeserializeOwned;
use wirebend_driver_api::{Call, Capability, DoneBy, GoingOn, Limits, ReferenceBy, SettingCheck, deadline};

use crate::driver::OpenDriver;
use crate::error::HostError;
pub use armed::{Armed, Asked, Confirmed, Purpose};
use axes::OffZero;
pub use error::SessionError;
use head::Head;
pub use head::{HeadKeeper, HeadPlace};
pub(crate) use motions::turned;
pub use standstill::Standstill;
use standstill::{DRIVER_CONFIRMS_WITHIN, GIVE_UP_AFTER, SessionGuard};
pub use state::State;
use state::{Act, Transition};
use stop::Arming;
pub use stop::{StopHandle, StopOutcome, StoppedBy};
pub use stop_line::{StopLine, StopLineError};

/// A connection to a machine through a driver. Dropping it closes the port and ends the driver.
#[derive(Debug)]
pub struct Session {
    driver: OpenDriver,
    state: State,
    arming: Arming,
    /// The arming, or the stop, that this session knows of.
    known: u64,
    /// Steps of the wire in hand, when armed for one.
    steps: Option<u32>,
    sent: u32,
    done: u32,
    /// How far rotate and bend axis are from their reference, degrees, in the machine's signs.
    off: OffZero,
    /// Settings of the machine that make wires come out wrong, as long as no person has accepted them.
    differences: Vec<SettingCheck>,
    /// What the machine itself says of its axes.
    limits: Limits,
    /// The driver was given the token of an earlier arming.
    resuming: bool,
    /// What the machine said of it.
    going_on: Option<GoingOn>,
    /// The last that the machine said of holding.
    holds: bool,
    guard: SessionGuard,
    /// What the machine says that it is.
    identity: String,
    /// The driver was ended because the machine may move and the driver is not to be trusted with that.
    lost: bool,
    /// Who brings its axes to their reference.
    reference: ReferenceBy,
    /// Who says that a step is made.
    done_by: DoneBy,
    head: Head,
}

impl Session {
    /// Opens a port. The machine's answer comes by [`Session::poll`]; until then the state is
    /// [`State::Disconnected`]. `line` is the program's own way to the port, by which it stops the machine where the
    /// driver does not, or is lost while the machine may move. It has to be opened before: see [`StopLine::open`].
    ///
    /// # Errors
    /// [`SessionError::Unsupported`] for a driver that only writes files; [`SessionError::Host`] when the
    /// port cannot be opened.
    pub fn connect(driver: OpenDriver, port: &str, line: Option<StopLine>) -> Result<Self, SessionError> {
        Self::connected(driver, port, None, line)
    }

    /// The same with the token of an earlier arming: where the machine still is in that wire, it becomes
    /// [`State::Interrupted`], and [`Session::going_on`] tells how far it is. What it has taken already it may
    /// make by itself; everything else needs [`Session::take_up`].
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
            state: State::Disconnected,
            known: arming.now(),
            arming,
            steps: None,
            sent: 0,
            done: 0,
            off: OffZero::default(),
            differences: Vec::new(),
            limits: Limits::default(),
            resuming: resume.is_some(),
            going_on: None,
            holds: false,
            guard: SessionGuard::default(),
            identity: String::new(),
            lost: false,
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
    pub const fn going_on(&self) -> Option<GoingOn> {
        self.going_on
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

    /// Who brings the axes to their reference. Where a person does, [`Session::home`] moves nothing, and their yes has to be
    /// that the axes stand there.
    #[must_use]
    pub const fn reference(&self) -> ReferenceBy {
        self.reference
    }

    /// Who says that a step is made: the machine, or the clock alone.
    #[must_use]
    pub const fn done_by(&self) -> DoneBy {
        self.done_by
    }

    /// The state.
    #[must_use]
    pub const fn state(&self) -> State {
        self.state
    }

    /// The driver.
    #[must_use]
    pub const fn driver(&self) -> &OpenDriver {
        &self.driver
    }

    /// The last step that was sent, and the last that was made.
    #[must_use]
    pub const fn progress(&self) -> (u32, u32) {
        (self.sent, self.done)
    }

    /// Settings of the machine that make wires come out wrong; none when a person has accepted them.
    #[must_use]
    pub fn differences(&self) -> &[SettingCheck] {
        &self.differences
    }

    /// What the machine itself says of how far its axes go and how fast.
    #[must_use]
    pub const fn machine_limits(&self) -> &Limits {
        &self.limits
    }

    /// Makes wires although settings of the machine differ.
    pub fn accept_differences(&mut self, _confirmed: Confirmed) {
        self.differences.clear();
    }

    /// Stops the machine; see [`StopHandle::stop`].
    pub fn stop(&mut self) -> StopOutcome {
        let outcome = self.stop_handle().stop();
        self.notice_stop();
        if outcome.driver_ended {
            self.driver_failed();
        }
        outcome
    }

    /// Whether the machine stands after the last stop, after its driver was lost, or after a fault while it might move;
    /// `None` when there was none of them since. While it is awaited, [`Session::poll`] follows it.
    #[must_use]
    pub fn standstill(&self) -> Option<Standstill> {
        self.guard.standstill()
    }

    /// How the last stop through this session or one of its handles went.
    #[must_use]
    pub fn last_stop(&self) -> Option<StopOutcome> {
        self.arming.stopped()
    }

    /// The same, and forgets it: whoever goes on with the session has heard of it. What it ended stays ended.
    #[must_use]
    pub fn take_stop(&mut self) -> Option<StopOutcome> {
        self.notice_stop();
        self.guard.forget();
        self.arming.take_stopped()
    }

    /// What stops the machine from any thread, whatever this one is doing.
    #[must_use]
    pub fn stop_handle(&self) -> StopHandle {
        let can_stop = self.driver.description().can(Capability::Stop);
        StopHandle::new(self.driver.handle(), self.arming.clone(), can_stop, self.guard.copy())
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

    /// Learns of a stop through a handle, whether or not the driver reports it.
    fn notice_stop(&mut self) {
        let now = self.arming.now();
        if now != self.known {
            self.known = now;
            if !matches!(self.state, State::Disconnected | State::Faulted) {
                let awaited = self.guard.standstill() == Some(Standstill::Awaited);
                self.state = if awaited { State::Stopping } else { State::Stopped };
            }
        }
    }

    /// A driver that does not bring the machine's confirmation in time is ended: the program asks for it itself.
    fn see_stop_through(&mut self) {
        let Some(awaited) = self.guard.awaited_for() else { return };
        if awaited > DRIVER_CONFIRMS_WITHIN && !self.lost && self.guard.line().is_some() {
            self.lose_driver();
        } else if awaited > GIVE_UP_AFTER && self.guard.line().is_none() {
            self.guard.give_up();
            self.state = State::Faulted;
        }
    }

    /// The driver has told of a fault while the machine may move. Whether that has ended the motion the driver need not
    /// know, and what the machine was sent before it may still make: it is stopped as by a person, and says that it stands.
    fn halt(&mut self) {
        if self.stop_handle().halt().driver_ended {
            self.driver_failed();
        }
    }

    /// What it was asked it did not do, and it may be gone. Where the machine may move, nothing more is left to it.
    fn driver_failed(&mut self) {
        if self.guard.concerns() {
            self.lose_driver();
        }
        self.state = State::Faulted;
        self.share_port();
    }

    /// Ends the driver, for whose loss the guard stops the machine.
    fn lose_driver(&mut self) {
        self.lost = true;
        self.driver.handle().kill();
        // One that had ended before was noticed then.
        self.guard.driver_is_lost();
        self.state = State::Faulted;
        self.share_port();
    }

    /// Lets a new driver open the port although this program keeps it.
    fn share_port(&self) {
        if let Some(line) = self.guard.line() {
            line.share();
        }
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

    fn may(&self, act: Act) -> Result<State, SessionError> {
        // After a fault, too, nothing begins before the machine stands.
        let awaited = self.guard.standstill() == Some(Standstill::Awaited);
        let state = if awaited && self.state == State::Faulted { State::Stopping } else { self.state };
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
