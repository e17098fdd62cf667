//! The session actor: a machine that stays connected has one thread, which alone uses its session. It carries out one order
//! at a time and publishes how the machine stands; other threads order, read, and stop it at any time.
//!
//! The session itself is with the [`ActorClient`], which carries the orders out on that thread: an order may need a job that is
//! planned and a person who is asked, and neither is known here.

mod state;

use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use crate::session::{Because, OrderName, Phase, Snapshot, StopHandle, StopOutcome};
pub use state::ActorView;
use state::{ActorState, Life};

/// A stop is over within a part of this: a driver that does not pass it on is ended.
const STOPPING: Duration = Duration::from_secs(1);

/// An order that an actor takes.
pub trait ActorOrder {
    fn name(&self) -> OrderName;
    /// Whether it begins with homing, so that the machine need not be homed before.
    fn homes_first(&self) -> bool;
    /// What it wants of the wire that is being bent, where it is for the order that is carried out.
    fn wish(&self) -> Option<Wish>;
}

/// Carries out what an actor is ordered, on its thread.
pub trait ActorClient<O> {
    /// Carries out an order, and lets the machine come to rest: [`Actor::rest`]. Whether there is anything more to do.
    fn execute(&mut self, order: O) -> Next;
    /// Looks at a machine of which nothing is ordered.
    fn look(&mut self);
    /// Reports what other threads have changed.
    fn tell(&mut self);
}

/// What follows an order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Next {
    Continue,
    /// Nothing: the thread ends.
    End,
}

/// What a person wants of a wire that is being bent. It goes to the order that is being carried out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wish {
    /// The machine holds.
    Pause,
    /// It continues after that.
    Resume,
    /// It has so many percent of the programmed speed.
    Speed(u8),
}

/// An order that is not taken now.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NotTaken {
    pub order: OrderName,
    pub because: Because,
    /// What the machine is in.
    pub phase: Phase,
}

/// What all threads have of an actor.
///
/// Its lock is held for moments only, never while a driver is asked. So a stop, which comes from any thread, never has to
/// wait for it.
#[derive(Debug)]
pub struct Actor<O> {
    state: Mutex<ActorState<O>>,
    /// Notified when there is something for the actor's thread, and when that has ended.
    woken: Condvar,
}

/// What the thread is to do.
enum Task<O> {
    Order(O),
    Look,
    End,
}

impl<O: ActorOrder> Actor<O> {
    /// For a machine that is being connected: its thread takes orders once it has come to [`Actor::rest`].
    #[must_use]
    pub fn connecting() -> Self {
        Self { state: Mutex::new(ActorState::connecting()), woken: Condvar::new() }
    }

    /// What a thread that failed left behind is still true.
    fn lock(&self) -> MutexGuard<'_, ActorState<O>> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    #[must_use]
    pub fn view(&self) -> ActorView {
        self.lock().view()
    }

    /// Takes an order, if it makes sense now. `taken` is called before it can be carried out.
    ///
    /// # Errors
    /// [`NotTaken`].
    pub fn order(&self, order: O, taken: impl FnOnce()) -> Result<(), NotTaken> {
        let mut state = self.lock();
        state.take_order(order)?;
        taken();
        drop(state);
        self.woken.notify_all();
        Ok(())
    }

    /// Stops the machine, from any thread; one that is being connected as soon as it can be stopped. When this returns the stop
    /// is out. Whether there was, or will be, a machine to stop.
    #[must_use = "where there is no machine nothing was stopped"]
    pub fn stop(&self) -> bool {
        let handle = {
            let mut state = self.lock();
            let Some(handle) = state.stops.handle.clone() else {
                let connecting = state.phase() == Phase::Connecting && state.life != Life::Ended;
                state.stops.wanted |= connecting;
                return connecting;
            };
            state.stop_begins(handle.stops());
            handle
        };
        self.bring_about(&handle);
        true
    }

    fn bring_about(&self, handle: &StopHandle) {
        let outcome = handle.stop();
        tracing::info!(by = ?outcome.by, took = ?outcome.took, "STOP");
        let mut state = self.lock();
        state.stops.under_way -= 1;
        state.stops.outcome = Some(outcome);
        self.woken.notify_all();
    }

    /// The machine can be stopped from here on; a stop that was asked for before comes now. Whether there was one.
    pub fn connected(&self, handle: &StopHandle) -> bool {
        let wanted = {
            let mut state = self.lock();
            state.can_be_stopped(handle);
            let wanted = std::mem::take(&mut state.stops.wanted);
            if wanted {
                state.stop_begins(handle.stops());
            }
            wanted
        };
        if wanted {
            self.bring_about(handle);
        }
        wanted
    }

    /// No machine is connected any more.
    pub fn disconnected(&self) {
        self.lock().stops.handle = None;
    }

    /// Has the thread end. Whether something is under way, and has to be stopped for it: also an order between two of its motions.
    #[must_use = "what moves has to be stopped"]
    pub fn close(&self) -> bool {
        let mut state = self.lock();
        if state.life == Life::Open {
            state.life = Life::Closing;
        }
        self.woken.notify_all();
        state.is_at_work()
    }

    /// Whether the thread has ended within a time.
    pub fn ended_within(&self, patience: Duration) -> bool {
        let going = |state: &mut ActorState<O>| state.life != Life::Ended;
        let waited = self.woken.wait_timeout_while(self.lock(), patience, going);
        waited.unwrap_or_else(PoisonError::into_inner).0.life == Life::Ended
    }

    /// The thread: carries out orders until the last, or until it is closed. It looks at the machine when nothing comes
    /// within a time.
    pub fn run(&self, idle: Duration, client: &mut impl ActorClient<O>) {
        loop {
            match self.next(idle) {
                Task::End => return,
                Task::Look => {
                    client.tell();
                    client.look();
                }
                Task::Order(order) => {
                    client.tell();
                    if client.execute(order) == Next::End {
                        return;
                    }
                }
            }
        }
    }

    fn next(&self, patience: Duration) -> Task<O> {
        let idle = |state: &mut ActorState<O>| {
            state.order.is_none()
                && state.life == Life::Open
                && !state.changed
                && state.stops.outcome.is_none()
        };
        let waited = self.woken.wait_timeout_while(self.lock(), patience, idle);
        let mut state = waited.unwrap_or_else(PoisonError::into_inner).0;
        if state.life != Life::Open {
            return Task::End;
        }
        state.order.take().map_or(Task::Look, Task::Order)
    }

    /// For the thread: how the machine stands while an order is carried out. What has changed while nothing was ordered counts
    /// when the thread has seen to it.
    pub fn publish(&self, snapshot: &Snapshot) {
        self.lock().publish(snapshot);
    }

    /// For the thread: the order is done, if there was one, and the machine at rest, as its session says, or failed where there
    /// is none.
    pub fn rest(&self, snapshot: Option<&Snapshot>) {
        self.lock().rest(snapshot);
    }

    /// For the thread: a phase that the session does not know of, since there is none, or it is between two motions. After a stop
    /// nothing but that is under way.
    pub fn enter(&self, phase: Phase) {
        let mut state = self.lock();
        if phase == state.phase() || (state.stops.in_order && phase != Phase::Stopping) {
            return;
        }
        state.enter(phase);
        state.changed = true;
    }

    /// For the thread: it is at its end. A caller that waits for that waits until the last event was reported.
    pub fn end(&self, phase: Phase, tell: impl FnOnce()) {
        self.lock().end(phase);
        tell();
        self.woken.notify_all();
    }

    /// Whether an order is being carried out.
    pub fn is_busy(&self) -> bool {
        self.lock().busy()
    }

    /// Whether the thread is to end, or has.
    pub fn is_closing(&self) -> bool {
        self.lock().life != Life::Open
    }

    /// A person is asked, or not any more. Whether they need not answer: the machine was stopped, or is let go.
    pub fn asks(&self, open: bool) -> bool {
        let mut state = self.lock();
        (state.question_open, state.changed) = (open, true);
        state.stops.in_order || state.life != Life::Open
    }

    /// What a person wants of the wire that is being bent, once.
    pub fn wish(&self) -> Option<Wish> {
        self.lock().take_wish()
    }

    /// Whether a stop waits until there is something to stop.
    pub fn stop_is_wanted(&self) -> bool {
        self.lock().stops.wanted
    }

    /// Whether a stop is on its way, or its outcome was not taken yet.
    pub fn stop_is_out(&self) -> bool {
        let state = self.lock();
        state.stops.under_way > 0 || state.stops.outcome.is_some()
    }

    /// How a stop went once it is over, if there was one; once.
    pub fn take_stop(&self) -> Option<StopOutcome> {
        let going = |state: &mut ActorState<O>| state.stops.under_way > 0;
        let waited = self.woken.wait_timeout_while(self.lock(), STOPPING, going);
        waited.unwrap_or_else(PoisonError::into_inner).0.stops.outcome.take()
    }

    /// There is something to report.
    pub fn changed(&self) {
        self.lock().changed = true;
        self.woken.notify_all();
    }

    /// Whether there is, once.
    pub fn take_changed(&self) -> bool {
        std::mem::take(&mut self.lock().changed)
    }
}
