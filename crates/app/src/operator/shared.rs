//! What the front end's threads and the operator's thread share: orders one way, the state and events the other.
//!
//! The lock is held for moments only, never while a driver is asked or the listener is called. So a stop, which
//! comes from any thread, waits for nobody.

use std::collections::BTreeSet;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use wirebend_driver_host::api::{Capability, ReferenceBy};
use wirebend_driver_host::{StopHandle, StopOutcome};

use super::error::OperatorError;
use super::event::{HeadAsked, OperatorEvent, OperatorListener, Question, QuestionKind};
use super::kept::{Kept, Life};
use super::order::{Answer, Order};
use super::state::{MachineState, Phase};
use crate::live::HeadQuestion;
use crate::{Doubt, Move, RunProblem, Wish};

/// A stop is over within a part of this: a driver that does not pass it on is ended.
const STOPPING: Duration = Duration::from_secs(1);

pub(super) struct Shared {
    listener: Arc<dyn OperatorListener>,
    kept: Mutex<Kept>,
    /// Told when there is something for the operator's thread, and when that has ended.
    woken: Condvar,
}

/// What the operator's thread is to do next.
pub(super) enum Next {
    Order(Order),
    /// Nothing: to look at the machine.
    Look,
    Close,
}

impl Shared {
    pub fn new(state: MachineState, listener: Arc<dyn OperatorListener>) -> Self {
        Self { listener, kept: Mutex::new(Kept::new(state)), woken: Condvar::new() }
    }

    /// What a thread that failed left behind is still true.
    fn lock(&self) -> MutexGuard<'_, Kept> {
        self.kept.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub fn state(&self) -> MachineState {
        self.lock().state()
    }

    /// Takes an order, if it makes sense now.
    pub fn order(&self, order: Order) -> Result<(), OperatorError> {
        let mut kept = self.lock();
        kept.may(&order)?;
        match order {
            Order::Pause => kept.wish = Some(Wish::Pause),
            Order::Resume => kept.wish = Some(Wish::Resume),
            order => {
                kept.state.problem = None;
                (kept.order, kept.busy, kept.untold) = (Some(order), true, true);
            }
        }
        self.woken.notify_all();
        Ok(())
    }

    /// Takes the answer to the open question.
    pub fn answer(&self, id: u64, answer: Answer) -> Result<(), OperatorError> {
        let mut kept = self.lock();
        let open = kept.state.question.as_ref().filter(|open| open.id == id && kept.answer.is_none());
        let Some(open) = open else { return Err(OperatorError::NoQuestion { id }) };
        let within = |deg: f64| {
            open.head.as_ref().is_some_and(|head| (head.range_deg[0]..=head.range_deg[1]).contains(&deg))
        };
        let counted = open.doubt.as_ref().is_some_and(|doubt| doubt.counted.is_some());
        let (fits, expected) = match open.kind {
            QuestionKind::Doubt => (
                matches!(answer, Answer::Made | Answer::NotMade | Answer::Part(_))
                    || (counted && answer == Answer::AsCounted),
                "made, not-made, as-counted where it was, a part, or no when nobody knows",
            ),
            QuestionKind::Head => (
                matches!(answer, Answer::Head(deg) if within(deg)),
                "where the head stands, within the limits of its cable, or no when nobody knows",
            ),
            _ => (answer == Answer::Yes, "yes or no"),
        };
        if !fits && answer != Answer::No {
            return Err(OperatorError::WrongAnswer { id, expected });
        }
        kept.answer = Some(answer);
        self.woken.notify_all();
        Ok(())
    }

    /// Stops the machine, from any thread. Whether there is one to stop, or will be once it is connected.
    pub fn stop(&self) -> bool {
        let handle = {
            let mut kept = self.lock();
            let Some(handle) = kept.stop.clone() else {
                let connecting = kept.state.phase == Phase::Connecting && kept.life != Life::Ended;
                kept.stop_wanted |= connecting;
                return connecting;
            };
            kept.stop_begins();
            handle
        };
        self.bring_about(&handle);
        true
    }

    fn bring_about(&self, handle: &StopHandle) {
        let outcome = handle.stop();
        tracing::info!(by = ?outcome.by, took = ?outcome.took, "STOP");
        let mut kept = self.lock();
        kept.stops -= 1;
        kept.outcome = Some(outcome);
        kept.withdraw();
        self.woken.notify_all();
    }

    /// The machine can be stopped from here on; a stop that was asked for before comes now.
    pub fn can_be_stopped(&self, handle: &StopHandle) {
        let wanted = {
            let mut kept = self.lock();
            kept.stop = Some(handle.clone());
            let wanted = std::mem::take(&mut kept.stop_wanted);
            if wanted {
                kept.stop_begins();
            }
            wanted
        };
        if wanted {
            self.bring_about(handle);
        }
    }

    /// No machine is connected any more.
    pub fn is_lost(&self) {
        let mut kept = self.lock();
        (kept.stop, kept.abilities) = (None, BTreeSet::new());
    }

    /// Has the operator's thread end: what moves is stopped.
    pub fn close(&self) {
        let under_way = {
            let mut kept = self.lock();
            if kept.life == Life::Open {
                kept.life = Life::Closing;
            }
            kept.withdraw();
            self.woken.notify_all();
            kept.state.phase.is_under_way()
        };
        if under_way {
            let _ = self.stop();
        }
    }

    /// Whether the operator's thread has ended within a time.
    pub fn ended_within(&self, patience: Duration) -> bool {
        let going = |kept: &mut Kept| kept.life != Life::Ended;
        let waited = self.woken.wait_timeout_while(self.lock(), patience, going);
        waited.unwrap_or_else(PoisonError::into_inner).0.life == Life::Ended
    }

    /// For the operator's thread: what is next, if anything comes within a time.
    pub fn next(&self, patience: Duration) -> Next {
        let idle = |kept: &mut Kept| {
            kept.order.is_none() && kept.life == Life::Open && !kept.untold && kept.outcome.is_none()
        };
        let waited = self.woken.wait_timeout_while(self.lock(), patience, idle);
        let mut kept = waited.unwrap_or_else(PoisonError::into_inner).0;
        if kept.life != Life::Open {
            return Next::Close;
        }
        let order = kept.order.take();
        drop(kept);
        self.catch_up();
        order.map_or(Next::Look, Next::Order)
    }

    /// The order is done, if there was one, and the machine at rest.
    pub fn rest(&self, change: impl FnOnce(&mut MachineState)) {
        {
            let mut kept = self.lock();
            let before = kept.state();
            // Another order may have come while it was at rest.
            kept.busy = kept.order.is_some();
            (kept.wish, kept.stop_wanted, kept.state.doing) = (None, false, None);
            change(&mut kept.state);
            kept.untold |= kept.state() != before;
        }
        self.catch_up();
    }

    pub fn is_closing(&self) -> bool {
        self.lock().life != Life::Open
    }

    /// Whether a stop waits until there is something to stop.
    pub fn stop_is_wanted(&self) -> bool {
        self.lock().stop_wanted
    }

    pub fn wished(&self) -> Option<Wish> {
        self.catch_up();
        self.lock().wish.take()
    }

    /// Tells what another thread has changed.
    pub fn catch_up(&self) {
        let state = {
            let mut kept = self.lock();
            std::mem::take(&mut kept.untold).then(|| kept.state())
        };
        if let Some(state) = state {
            self.hear(&OperatorEvent::State(Box::new(state)));
        }
    }

    pub fn hear(&self, event: &OperatorEvent) {
        self.listener.hear(event);
    }

    /// Changes the state; it is told if it is another one then.
    pub fn change(&self, change: impl FnOnce(&mut MachineState)) {
        {
            let mut kept = self.lock();
            let before = kept.state.clone();
            change(&mut kept.state);
            kept.untold |= kept.state != before;
        }
        self.catch_up();
    }

    /// Changes what is told as news, and so not as a state.
    pub fn change_untold(&self, change: impl FnOnce(&mut MachineState)) {
        change(&mut self.lock().state);
    }

    /// Changes the phase; not while a stop is on its way.
    pub fn enter(&self, phase: Phase) {
        self.change(|state| {
            if state.phase != Phase::Stopping {
                state.phase = phase;
            }
        });
    }

    pub fn know(&self, abilities: BTreeSet<Capability>, reference: ReferenceBy) {
        let mut kept = self.lock();
        (kept.abilities, kept.reference) = (abilities, reference);
    }

    pub fn problem(&self, problem: RunProblem) {
        let RunProblem { code, message } = problem.clone();
        tracing::info!(%code, "{message}");
        self.hear(&OperatorEvent::Problem { code, message });
        self.change(|state| state.problem = Some(problem));
    }

    /// Tells how a stop went once it is over, if there was one.
    pub fn tell_stop(&self) -> Option<StopOutcome> {
        let going = |kept: &mut Kept| kept.stops > 0;
        let waited = self.woken.wait_timeout_while(self.lock(), STOPPING, going);
        let outcome = waited.unwrap_or_else(PoisonError::into_inner).0.outcome.take();
        let StopOutcome { by, driver_ended, took } = outcome?;
        let took_ms = u64::try_from(took.as_millis()).unwrap_or(u64::MAX);
        self.hear(&OperatorEvent::Stopped { by, driver_ended, took_ms });
        outcome
    }

    pub fn stop_is_out(&self) -> bool {
        let kept = self.lock();
        kept.stops > 0 || kept.outcome.is_some()
    }

    pub fn about(&self, lines: Vec<String>) {
        self.lock().lines = lines;
    }

    /// Asks a person; `lines` are those that were told last where none are given.
    pub fn ask(
        &self,
        kind: QuestionKind,
        lines: Option<Vec<String>>,
        question: &str,
        doubt: Option<Doubt>,
    ) -> u64 {
        let question = question.to_owned();
        self.open(lines, |id, lines| Question { id, kind, lines, question, doubt, head: None })
    }

    /// Asks a person where the head stands.
    pub fn ask_for_head(&self, about: HeadQuestion, question: &str) -> u64 {
        let (kind, question) = (QuestionKind::Head, question.to_owned());
        let HeadQuestion { lines, range, left_at: left_at_deg } = about;
        let head = Some(HeadAsked { range_deg: range, left_at_deg });
        self.open(Some(lines), |id, lines| Question { id, kind, lines, question, doubt: None, head })
    }

    fn open(&self, lines: Option<Vec<String>>, make: impl FnOnce(u64, Vec<String>) -> Question) -> u64 {
        let asked = {
            let mut kept = self.lock();
            kept.asked += 1;
            let told = std::mem::take(&mut kept.lines);
            let asked = make(kept.asked, lines.unwrap_or(told));
            kept.state.question = Some(asked.clone());
            // Whoever stops or leaves has answered.
            kept.answer =
                (kept.life != Life::Open || kept.state.phase == Phase::Stopping).then_some(Answer::No);
            kept.untold = true;
            asked
        };
        let id = asked.id;
        self.hear(&OperatorEvent::Question(asked));
        self.catch_up();
        id
    }

    /// The answer, if it comes within a time; the question is not open any more then.
    pub fn answered(&self, patience: Option<Duration>) -> Option<Answer> {
        let begun = Instant::now();
        let mut kept = self.lock();
        while kept.answer.is_none() {
            kept = match patience.map(|patience| patience.saturating_sub(begun.elapsed())) {
                Some(Duration::ZERO) => return None,
                Some(left) => self.woken.wait_timeout(kept, left).unwrap_or_else(PoisonError::into_inner).0,
                None => self.woken.wait(kept).unwrap_or_else(PoisonError::into_inner),
            };
        }
        drop(kept);
        Some(self.close_question())
    }

    /// Closes the question: what was said counts, and no where nothing was.
    pub fn close_question(&self) -> Answer {
        let (id, answer) = {
            let mut kept = self.lock();
            let answer = kept.answer.take().unwrap_or(Answer::No);
            kept.untold = true;
            (kept.state.question.take().map(|open| open.id), answer)
        };
        if let Some(id) = id {
            self.hear(&OperatorEvent::Answered { id, answer });
        }
        self.catch_up();
        answer
    }

    pub fn record(&self, made: Move) {
        let mut kept = self.lock();
        kept.recorded.push(made);
        kept.state.recorded = kept.recorded.len();
        kept.untold = true;
    }

    pub fn recorded(&self) -> Vec<Move> {
        self.lock().recorded.clone()
    }

    pub fn clear_recording(&self) {
        let mut kept = self.lock();
        kept.recorded.clear();
        (kept.state.recorded, kept.untold) = (0, true);
        self.woken.notify_all();
    }

    /// The operator's thread is at its end.
    pub fn end(&self, phase: Phase) {
        {
            let mut kept = self.lock();
            (kept.life, kept.stop, kept.untold) = (Life::Ended, None, true);
            (kept.order, kept.state.question, kept.state.doing) = (None, None, None);
            kept.state.phase = phase;
        }
        // A listener that has failed is not asked again.
        if !std::thread::panicking() {
            self.catch_up();
        }
        self.woken.notify_all();
    }
}
