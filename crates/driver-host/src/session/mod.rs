//! The session with a machine: what may be done when, and a stop that always works.

mod armed;
mod axes;
mod error;
mod state;
mod stop;

use wirebend_driver_api::{
    Axis, Batch, Call, Capability, Event, Motion, NumberedStep, Sent, SettingCheck, deadline,
};

use crate::driver::OpenDriver;
use crate::error::HostError;
pub use armed::{Armed, Asked, Confirmed, Purpose};
use axes::OffZero;
pub use error::SessionError;
pub use state::State;
use state::{Act, Transition};
use stop::Arming;
pub use stop::{StopHandle, StopOutcome, StoppedBy};

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
}

impl Session {
    /// Opens a port. The machine's answer comes by [`Session::poll`]; until then the state is
    /// [`State::Disconnected`].
    ///
    /// # Errors
    /// [`SessionError::Unsupported`] for a driver that only writes files; [`SessionError::Host`] when the
    /// port cannot be opened.
    pub fn connect(driver: OpenDriver, port: &str) -> Result<Self, SessionError> {
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
        };
        session.require(Capability::Live)?;
        session.driver.call("connecting", &Call::Connect { port: port.to_owned() })?;
        Ok(session)
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

    /// Takes what the driver reports, and moves the state along.
    ///
    /// # Errors
    /// [`SessionError::Host`] when the driver fails or refuses, [`SessionError::OutOfOrder`] when its account
    /// cannot be true: the state is [`State::Faulted`] then.
    pub fn poll(&mut self) -> Result<Vec<Event>, SessionError> {
        let polled = self.driver.poll();
        // A driver that refuses to report no longer trusts its connection.
        let events = polled.inspect_err(|_| self.state = State::Faulted)?;
        for event in &events {
            self.take_note(event)?;
            self.state = self.state.after(event);
        }
        self.notice_stop();
        Ok(events)
    }

    /// What an event says of the wire and of the axes. A driver that skips a step, reports one that it was not
    /// sent, or a wire as made before its last step is, is not to be believed.
    fn take_note(&mut self, event: &Event) -> Result<(), SessionError> {
        let complete = self.done == self.sent && self.steps == Some(self.done);
        let believed = match event {
            Event::Done { n } => *n == self.done + 1 && *n <= self.sent,
            Event::Finished => complete || self.state != State::Running,
            _ => true,
        };
        match event {
            Event::Done { n } if believed => self.done = *n,
            Event::Homed => self.off = OffZero::default(),
            Event::Connected { settings, .. } => {
                self.off = OffZero::default();
                self.differences = settings.iter().filter(|setting| setting.matters).cloned().collect();
            }
            _ => {}
        }
        if believed {
            return Ok(());
        }
        self.state = State::Faulted;
        let n = if let Event::Done { n } = event { *n } else { self.done };
        Err(SessionError::OutOfOrder { n, done: self.done, sent: self.sent })
    }

    /// Settings of the machine that make wires come out wrong; none when a person has accepted them.
    #[must_use]
    pub fn differences(&self) -> &[SettingCheck] {
        &self.differences
    }

    /// Makes wires although settings of the machine differ.
    pub fn accept_differences(&mut self, _confirmed: Confirmed) {
        self.differences.clear();
    }

    /// Lets the machine find its reference: it moves.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn home(&mut self, _confirmed: &Confirmed) -> Result<(), SessionError> {
        self.require(Capability::Home)?;
        self.may(Act::Home)?;
        // What was reported before is not about this search.
        self.poll()?;
        let next = self.may(Act::Home)?;
        let called = self.motion("homing", &Call::Home);
        self.faulting(called)?;
        self.state = next;
        Ok(())
    }

    /// Makes ready to move. The token that this gives is what every motion needs; it ends with the wire,
    /// with a stop, a fault, or another arming.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn arm(&mut self, purpose: Purpose, _confirmed: Confirmed) -> Result<Armed, SessionError> {
        let next = self.may(Act::Arm)?;
        self.steps = match purpose {
            Purpose::Wire(run) => {
                let steps = run.steps;
                self.off.require_zero()?;
                if !self.differences.is_empty() {
                    return Err(SessionError::SettingsDiffer { settings: self.differences.clone() });
                }
                let called = self.motion("arming", &Call::Arm(run));
                self.faulting(called)?;
                Some(steps)
            }
            Purpose::ByHand => None,
        };
        let Some(arming) = self.arming.follow(self.known) else {
            self.notice_stop();
            return Err(SessionError::Stale);
        };
        (self.state, self.sent, self.done, self.known) = (next, 0, 0, arming);
        Ok(Armed { arming })
    }

    /// Sends steps of the wire, from the one after the last that was sent. The driver takes as many as it
    /// has room for.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn send(&mut self, armed: &Armed, steps: &[NumberedStep]) -> Result<Sent, SessionError> {
        self.valid(armed)?;
        let next = self.may(Act::Send)?;
        let Some(total) = self.steps else { return Err(SessionError::NotForAWire) };
        let follows = steps.iter().zip(self.sent + 1..).all(|(step, n)| step.n == n);
        let Some(last) = steps.last().filter(|last| follows && last.n <= total) else {
            return Err(SessionError::Steps { sent: self.sent, total });
        };
        let call = Call::Send(Batch { steps: steps.to_vec(), last: last.n == total });
        let called = self.driver.motion_for("sending steps", &call, deadline::CALL, self.unstopped());
        let taken: Sent = self.faulting(called)?;
        if taken.accepted < self.sent || taken.accepted > last.n {
            self.state = State::Faulted;
            return Err(SessionError::OutOfOrder { n: taken.accepted, done: self.sent, sent: last.n });
        }
        let newly = steps.iter().filter(|step| step.n <= taken.accepted);
        newly.for_each(|step| self.off.turned(Axis::Rotate, step.step.rotate_deg));
        self.sent = taken.accepted;
        self.state = next;
        Ok(taken)
    }

    /// Moves one axis.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn jog(&mut self, armed: &Armed, motion: Motion) -> Result<(), SessionError> {
        self.require(Capability::Jog)?;
        self.valid(armed)?;
        let next = self.may(Act::Jog)?;
        if self.steps.is_some() {
            return Err(SessionError::ForAWire);
        }
        let called = self.motion("jogging", &Call::Jog(motion));
        self.faulting(called)?;
        self.off.turned(motion.axis, motion.by);
        self.state = next;
        Ok(())
    }

    /// Holds the machine; the state changes when the machine says that it does.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn pause(&mut self) -> Result<(), SessionError> {
        self.require(Capability::Pause)?;
        self.may(Act::Pause)?;
        let called = self.driver.call("pausing", &Call::Pause);
        self.faulting(called)
    }

    /// Goes on after a pause: the machine moves.
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

    /// Stops the machine; see [`StopHandle::stop`].
    pub fn stop(&mut self) -> StopOutcome {
        let outcome = self.stop_handle().stop();
        self.notice_stop();
        if outcome.by == StoppedBy::EndOfDriver {
            self.state = State::Faulted;
        }
        outcome
    }

    /// What stops the machine from any thread, whatever this one is doing.
    #[must_use]
    pub fn stop_handle(&self) -> StopHandle {
        let can_stop = self.driver.description().can(Capability::Stop);
        StopHandle::new(self.driver.handle(), self.arming.clone(), can_stop)
    }

    /// Closes the port and gives the driver back.
    ///
    /// # Errors
    /// [`SessionError::Host`]; the port is closed in any case, for the driver is ended then.
    pub fn disconnect(self) -> Result<OpenDriver, SessionError> {
        self.driver.call("disconnecting", &Call::Disconnect)?;
        Ok(self.driver)
    }

    /// Learns of a stop through a handle, whether or not the driver reports it.
    fn notice_stop(&mut self) {
        let now = self.arming.now();
        if now != self.known {
            self.known = now;
            if !matches!(self.state, State::Disconnected | State::Faulted) {
                self.state = State::Stopped;
            }
        }
    }

    /// Whether no stop has come of which this session does not know yet.
    fn unstopped(&self) -> impl FnOnce() -> bool + use<> {
        let (arming, known) = (self.arming.clone(), self.known);
        move || arming.now() == known
    }

    /// A call that moves the machine or leads to it: not after a stop.
    fn motion(&self, during: &'static str, call: &Call) -> Result<(), HostError> {
        self.driver.motion_for::<serde_json::Value>(during, call, deadline::CALL, self.unstopped()).map(drop)
    }

    fn may(&self, act: Act) -> Result<State, SessionError> {
        match self.state.on(act) {
            Transition::To(next) => Ok(next),
            Transition::Refused { expected } => Err(SessionError::State { act, state: self.state, expected }),
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
            Err(HostError::Refused { error, .. }) if error.has_panicked() => self.state = State::Faulted,
            Ok(_) | Err(HostError::Refused { .. }) => {}
            Err(HostError::StoppedBefore { .. }) => self.notice_stop(),
            Err(_) => self.state = State::Faulted,
        }
        result.map_err(SessionError::from)
    }
}
