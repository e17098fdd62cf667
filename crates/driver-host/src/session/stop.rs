//! STOP: by the driver if it answers in time; if not, by ending it and writing to the port itself.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use wirebend_driver_api::{Call, deadline};

use crate::driver::to_body;
use crate::frame::Mark;
use crate::process::ProcessHandle;

use super::standstill::{Guard, Standstill};

/// Stops a machine from any thread.
#[derive(Debug, Clone)]
pub struct StopHandle {
    process: ProcessHandle,
    arming: Arming,
    can_stop: bool,
    guard: Guard,
}

/// Which arming is in force. A stop moves it on, and so every token of before becomes stale.
#[derive(Debug, Clone)]
pub(super) struct Arming {
    session: u64,
    number: Arc<AtomicU64>,
    /// How many stops there were, those at the machine itself included.
    stops: Arc<AtomicU64>,
    /// How the last stop went.
    stopped: Arc<Mutex<Option<StopOutcome>>>,
}

/// Numbers of one session are no other's: a token of another machine is stale here.
static SESSIONS: AtomicU64 = AtomicU64::new(1);

impl Arming {
    /// For a new session.
    pub fn first() -> Self {
        let session = SESSIONS.fetch_add(1, Ordering::Relaxed);
        let number = Arc::new(AtomicU64::new(session << 32));
        Self { session, number, stops: Arc::default(), stopped: Arc::default() }
    }

    pub const fn session(&self) -> u64 {
        self.session
    }

    pub fn stops(&self) -> u64 {
        self.stops.load(Ordering::SeqCst)
    }

    /// The machine was stopped, by whomever.
    pub fn count_stop(&self) {
        self.stops.fetch_add(1, Ordering::SeqCst);
    }

    pub fn now(&self) -> u64 {
        self.number.load(Ordering::SeqCst)
    }

    /// The next one; `None` when `known` is no longer in force.
    pub fn follow(&self, known: u64) -> Option<u64> {
        self.number
            .compare_exchange(known, known + 1, Ordering::SeqCst, Ordering::SeqCst)
            .is_ok()
            .then_some(known + 1)
    }

    fn end(&self) {
        self.count_stop();
        self.number.fetch_add(1, Ordering::SeqCst);
    }

    /// How the last stop went, if there was one.
    pub fn stopped(&self) -> Option<StopOutcome> {
        *self.stopped.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The same, once.
    pub fn take_stopped(&self) -> Option<StopOutcome> {
        self.stopped.lock().unwrap_or_else(PoisonError::into_inner).take()
    }

    fn note(&self, outcome: StopOutcome) {
        *self.stopped.lock().unwrap_or_else(PoisonError::into_inner) = Some(outcome);
    }
}

/// What sent the stop.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum StoppedBy {
    /// The driver: it has passed the stop on to the machine.
    Driver,
    /// The machine cannot be stopped. The driver sends nothing more; the machine runs what it has been
    /// sent. Cut its power.
    NothingMore,
    /// This program: the driver did not answer in time or refused, so its process was ended and its port
    /// closed with it. What the machine holds in its own memory may still run: cut its power.
    EndOfDriver,
    /// This program: the driver did not answer in time or refused, so its process was ended, and with it the machine that it
    /// simulated. Nothing moves.
    EndOfSimulation,
    /// This program: the driver did not pass the stop on, and so the stop bytes of the machine's profile were
    /// written to the port by the program itself.
    Host,
}

/// How a stop was sent. Whether the machine stands is known later: [`StopHandle::standstill`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StopOutcome {
    /// What sent it.
    pub by: StoppedBy,
    /// Whether the driver's process was ended for it, or had ended before.
    pub driver_ended: bool,
    /// From the call to its end.
    pub took: Duration,
}

impl StopHandle {
    pub(super) const fn new(process: ProcessHandle, arming: Arming, can_stop: bool, guard: Guard) -> Self {
        Self { process, arming, can_stop, guard }
    }

    /// Sends a stop. Does not depend on the driver: one that has not answered within [`deadline::STOP`] is ended,
    /// whatever else it is doing, and where the machine's profile has stop bytes the program writes them to the port
    /// itself, until the machine confirms. It can be asked for as often as a person wants.
    #[must_use = "a driver that had to be ended cannot have passed the stop on"]
    pub fn stop(&self) -> StopOutcome {
        let outcome = self.halt();
        self.arming.note(outcome);
        outcome
    }

    /// The same where no person has asked for it: what was under way has failed, and the machine may move.
    pub(super) fn halt(&self) -> StopOutcome {
        let started = Instant::now();
        // In one moment with the place in the queue: no motion that was allowed before comes after it.
        let latch = || {
            // A thread that sees that it was stopped also has to see that the machine is waited for.
            self.guard.stop_begins();
            self.arming.end();
            true
        };
        let answer = self.process.request_if(Mark::Call, to_body(&Call::Stop), deadline::STOP, latch);
        // What answers nonsense cannot be relied on to have done it.
        let sound = |body: &[u8]| serde_json::from_slice::<serde_json::Map<String, Value>>(body).is_ok();
        let passed_on = answer.is_ok_and(|frame| frame.mark == Mark::Ok && sound(&frame.body));
        let by = self.brought_about(passed_on);
        let driver_ended = !passed_on || by == StoppedBy::Host;
        StopOutcome { by, driver_ended, took: started.elapsed() }
    }

    fn brought_about(&self, passed_on: bool) -> StoppedBy {
        if passed_on && self.can_stop {
            return StoppedBy::Driver;
        }
        if passed_on && self.guard.line().is_none() {
            self.guard.give_up();
            return StoppedBy::NothingMore;
        }
        // A driver that has not passed the stop on is of no use: it would read the machine's reply.
        self.process.kill();
        match self.guard.take_over() {
            true => StoppedBy::Host,
            false if self.guard.is_simulated() => StoppedBy::EndOfSimulation,
            false => StoppedBy::EndOfDriver,
        }
    }

    /// How many stops there were through this session, those at the machine itself included.
    #[must_use]
    pub fn stops(&self) -> u64 {
        self.arming.stops()
    }

    /// Whether the machine stands after the last stop, after its driver was lost, or after a fault while it might move;
    /// `None` when there was none of them.
    #[must_use]
    pub fn standstill(&self) -> Option<Standstill> {
        self.guard.standstill()
    }
}
