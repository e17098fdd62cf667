//! What the threads of an actor share, and what follows from it: values only.

use std::collections::BTreeSet;

use wirebend_driver_api::{ReferenceBy, Step};

use super::{ActorOrder, NotTaken, Wish};
use crate::session::{Because, Orders, Phase, Snapshot, StopHandle, StopOutcome};

/// Whether there still is an actor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Life {
    Open,
    /// Its thread is to end.
    Closing,
    Ended,
}

/// How a machine and its actor stand.
#[derive(Debug, Clone, PartialEq)]
pub struct ActorView {
    /// What the machine is in.
    pub phase: Phase,
    /// An order was given and is not done.
    pub busy: bool,
    /// Which orders are taken now, and why the others are not.
    pub orders: Orders,
    /// No machine is there: its driver computes one.
    pub simulated: bool,
    /// What it says that it is; `None` before it has answered.
    pub identity: Option<String>,
    /// Where its axes are, in the machine's signs.
    pub position: Option<Step>,
    /// How fast it is, percent of the programmed speed; `None` where that cannot be changed.
    pub speed_percent: Option<u8>,
}

/// What the threads share.
#[derive(Debug)]
pub(super) struct ActorState<O> {
    /// What the session said last; where there is none, what is known without.
    view: ActorView,
    /// Something was changed, and the thread has not reported it.
    pub changed: bool,
    pub order: Option<O>,
    /// A person is asked.
    pub question_open: bool,
    /// That it pauses or resumes, and then how fast it is: one does not take the place of the other.
    wish: Option<Wish>,
    wished_speed: Option<Wish>,
    pub stops: Stops,
    pub life: Life,
}

/// The stops of a machine.
#[derive(Debug, Default)]
pub(super) struct Stops {
    /// By what it is stopped; `None` where no machine is connected.
    pub handle: Option<StopHandle>,
    /// One was asked for before there was anything to stop.
    pub wanted: bool,
    /// One came while the order was carried out: what is left of that moves nothing.
    pub in_order: bool,
    /// How many are on their way.
    pub under_way: u32,
    /// How many a snapshot has to know of: one that knows less is older than the last.
    known: u64,
    /// How the last one went, until that is taken.
    pub outcome: Option<StopOutcome>,
}

impl<O: ActorOrder> ActorState<O> {
    /// A machine that is being connected.
    pub fn connecting() -> Self {
        Self {
            view: ActorView {
                phase: Phase::Connecting,
                busy: true,
                orders: without_session(Phase::Connecting),
                simulated: false,
                identity: None,
                position: None,
                speed_percent: None,
            },
            changed: true,
            order: None,
            question_open: false,
            wish: None,
            wished_speed: None,
            stops: Stops::default(),
            life: Life::Open,
        }
    }

    pub const fn phase(&self) -> Phase {
        self.view.phase
    }

    pub const fn busy(&self) -> bool {
        self.view.busy
    }

    /// Whether something moves, or an order that is carried out may move it next.
    pub fn is_at_work(&self) -> bool {
        self.view.busy || self.view.phase.is_under_way()
    }

    pub fn view(&self) -> ActorView {
        let orders = match self.none() {
            Some(because) => Orders::none(because),
            None => self.view.orders.clone(),
        };
        ActorView { busy: self.view.busy && self.life != Life::Ended, orders, ..self.view.clone() }
    }

    /// Why no order at all is taken.
    fn none(&self) -> Option<Because> {
        if self.life == Life::Ended {
            Some(Because::NotConnected)
        } else if self.question_open {
            Some(Because::QuestionOpen)
        } else {
            // What is under way says more of why something has to wait than that it has to.
            (self.view.busy && !self.view.phase.is_under_way()).then_some(Because::Busy)
        }
    }

    /// Takes an order, if it makes sense now.
    pub fn take_order(&mut self, order: O) -> Result<(), NotTaken> {
        let name = order.name();
        if let Some(because) = self.why_not(&order) {
            return Err(NotTaken { order: name, because, phase: self.view.phase });
        }
        match order.wish() {
            Some(Wish::Speed(percent)) => self.wished_speed = Some(Wish::Speed(percent)),
            Some(wish) => self.wish = Some(wish),
            None => (self.order, self.view.busy, self.changed) = (Some(order), true, true),
        }
        Ok(())
    }

    /// What a person wants of the wire that is being bent, once.
    pub fn take_wish(&mut self) -> Option<Wish> {
        self.wish.take().or_else(|| self.wished_speed.take())
    }

    fn why_not(&self, order: &O) -> Option<Because> {
        let why = self.view.orders.why_not(order.name());
        // What begins with homing needs none before.
        let why = why.filter(|why| *why != Because::NotHomed || !order.homes_first());
        match (self.none(), why) {
            // That the machine is in the wrong phase for it says more than that it has to wait.
            (Some(Because::Busy), Some(why)) if why != Because::Unable => Some(why),
            (none, why) => none.or(why),
        }
    }

    /// A machine can be stopped by this from here on.
    pub fn can_be_stopped(&mut self, handle: &StopHandle) {
        (self.stops.handle, self.stops.known) = (Some(handle.clone()), 0);
    }

    /// A stop is on its way: after `before` of them.
    pub fn stop_begins(&mut self, before: u64) {
        self.stops.under_way += 1;
        (self.stops.known, self.stops.in_order) = (before + 1, true);
        // What was ordered before was ordered of a machine that had not been stopped.
        (self.order, self.wish, self.wished_speed) = (None, None, None);
        self.enter(Phase::Stopping);
        self.changed = true;
    }

    /// How the machine stands, as its session says while an order is carried out. What has changed while nothing was ordered
    /// counts when the thread has seen to it: [`ActorState::rest`].
    pub fn publish(&mut self, snapshot: &Snapshot) {
        self.view.position = snapshot.position.or(self.view.position);
        // What is left of an order after a stop moves nothing: nothing but the stop is under way.
        let over = self.stops.in_order && snapshot.phase.is_under_way() && snapshot.phase != Phase::Stopping;
        if !self.view.busy || over || self.is_stale(snapshot) {
            return;
        }
        self.changed |=
            self.view.phase != snapshot.phase || self.view.speed_percent != snapshot.speed_percent;
        self.take(snapshot);
    }

    /// The order is done, if there was one, and the machine at rest: as its session says, or failed where there is none.
    pub fn rest(&mut self, snapshot: Option<&Snapshot>) {
        // Another order may have come while it was at rest.
        self.view.busy = self.order.is_some();
        (self.wish, self.wished_speed, self.stops.wanted) = (None, None, false);
        // What is older than a stop counts once that is over.
        self.stops.in_order = snapshot.is_some_and(|snapshot| self.is_stale(snapshot));
        match snapshot {
            Some(_) if self.stops.in_order => {}
            Some(snapshot) => self.take(snapshot),
            None => self.enter(Phase::Failed),
        }
    }

    /// Whether a snapshot is older than the last stop.
    const fn is_stale(&self, snapshot: &Snapshot) -> bool {
        snapshot.stops < self.stops.known
    }

    fn take(&mut self, snapshot: &Snapshot) {
        self.view.phase = snapshot.phase;
        self.view.orders.clone_from(&snapshot.orders);
        self.view.speed_percent = snapshot.speed_percent;
        // Before it has answered it has said nothing of itself.
        if snapshot.phase != Phase::Connecting {
            self.view.simulated = snapshot.simulated;
            self.view.identity = Some(snapshot.identity.clone());
        }
    }

    /// A phase of which no session says anything: there is none, or it does not know of it yet.
    pub fn enter(&mut self, phase: Phase) {
        (self.view.phase, self.view.orders) = (phase, without_session(phase));
    }

    /// The thread is at its end.
    pub fn end(&mut self, phase: Phase) {
        (self.life, self.stops.handle, self.order) = (Life::Ended, None, None);
        (self.question_open, self.changed) = (false, true);
        self.enter(phase);
    }
}

/// What can be ordered where no driver can do anything.
fn without_session(phase: Phase) -> Orders {
    Orders::of(phase, &BTreeSet::new(), ReferenceBy::default())
}

#[cfg(test)]
mod tests;
