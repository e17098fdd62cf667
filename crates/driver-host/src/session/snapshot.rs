//! How the machine stands, as front ends draw it: said by the session alone, in one place.

use std::collections::BTreeSet;
use std::time::Duration;

use wirebend_driver_api::{Capability, Step};

use super::orders::Orders;
use super::{Contact, Phase, Session, Standstill};

/// How a machine stands at a moment.
#[derive(Debug, Clone, PartialEq)]
pub struct Snapshot {
    /// What it is in. A machine at rest for which a person has permitted a wire is armed.
    pub phase: Phase,
    /// No machine is there: its driver computes one.
    pub simulated: bool,
    /// What it says that it is; empty before it has answered.
    pub identity: String,
    /// Where its axes are, in the machine's signs; `None` before it has said so.
    pub position: Option<Step>,
    /// How fast it is, percent of the programmed speed; `None` where that cannot be changed.
    pub speed_percent: Option<u8>,
    /// The wire in hand, or the one before as long as a person has not permitted another.
    pub wire: Option<WireProgress>,
    /// Which orders are possible, and why the others are not.
    pub orders: Orders,
    /// How many stops there had been: what says less than [`StopHandle::stops`](super::StopHandle::stops) is older than
    /// the last of them.
    pub stops: u64,
}

/// How far a wire is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct WireProgress {
    /// The last step that is done.
    pub made: u32,
    /// The last that the driver has taken.
    pub sent: u32,
    /// How many there are.
    pub of: u32,
    /// How long the machine was at work on it, in all of its parts, without pauses.
    pub elapsed: Duration,
    /// What is estimated to be left, without pauses.
    pub remaining: Duration,
}

impl Session {
    /// How the machine stands now.
    #[must_use]
    pub fn snapshot(&self) -> Snapshot {
        self.snapshot_with(|phase| match phase {
            Phase::Connected | Phase::Ready | Phase::Stopped if self.has_permitted_a_wire() => Phase::Armed,
            phase => phase,
        })
    }

    /// The same of a machine without an order. What it is in the middle of is not waited for: it has
    /// to be connected again.
    #[must_use]
    pub fn snapshot_at_rest(&self) -> Snapshot {
        let snapshot = self.snapshot();
        if snapshot.phase.is_under_way() { self.snapshot_with(|_| Phase::Failed) } else { snapshot }
    }

    fn snapshot_with(&self, better: impl FnOnce(Phase) -> Phase) -> Snapshot {
        let abilities = &self.driver.description().capabilities;
        // Before the phase: a stop in between is missed by both.
        let stops = self.arming.stops();
        let phase = better(self.phase_after_stop(stops));
        // A driver that is gone, or a machine that is given up in its wire, would refuse it.
        let given_up =
            self.contact != Contact::There || phase == Phase::Failed && self.phase != Phase::Failed;
        let asked = if given_up { &BTreeSet::new() } else { abilities };
        Snapshot {
            phase,
            simulated: self.is_simulated.get().copied().unwrap_or_default(),
            identity: self.identity.clone(),
            position: self.position,
            speed_percent: abilities.contains(&Capability::Speed).then_some(self.speed_percent),
            wire: self.wire_progress(),
            orders: Orders::of(phase, asked, self.reference),
            stops,
        }
    }

    fn wire_progress(&self) -> Option<WireProgress> {
        let (of, (elapsed, remaining)) = self.steps.zip(self.times)?;
        Some(WireProgress { made: self.done, sent: self.sent, of, elapsed, remaining })
    }

    /// How long the wire in hand takes, as the loop that runs it measures and estimates.
    pub(crate) const fn note_times(&mut self, elapsed: Duration, remaining: Duration) {
        self.times = Some((elapsed, remaining));
    }

    /// What the machine is in, with a stop of which the session has not taken note yet.
    fn phase_after_stop(&self, stops: u64) -> Phase {
        if self.guard.standstill() == Some(Standstill::Awaited) {
            return Phase::Stopping;
        }
        match self.phase {
            phase @ (Phase::Connecting | Phase::Failed) => phase,
            _ if stops != self.known_stops => Phase::Stopped,
            phase => phase,
        }
    }
}
