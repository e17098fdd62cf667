//! What the front end's threads and the operator's thread share: the actor, what a person is asked, and what they hear.
//!
//! Locks are held for moments only, never while a driver is asked or the listener is called. So a stop, which comes from any
//! thread, waits for no other thread.

use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use wirebend_driver_host::api::SPEEDS;
use wirebend_driver_host::{Actor, Phase, Snapshot, StopHandle, StopOutcome};
use wirebend_error::ProblemReport;
use wirebend_planning::signs::Signs;

use super::event::{OperatorEvent, OperatorListener};
use super::question::{HeadAsked, Question, QuestionKind};
use super::shared_state::{Ordered, SharedState};
use super::state::MachineState;
use crate::error::OperatorError;
use crate::live::HeadQuestion;
use crate::order::{Answer, Order};
use crate::{Doubt, Move, Wish};
use wirebend_planning::Input;

pub(super) struct Shared {
    listener: Arc<dyn OperatorListener>,
    pub actor: Actor<Ordered>,
    /// Locked after the actor where both are.
    kept: Mutex<SharedState>,
    /// Notified when a question is answered.
    answered: Condvar,
}

impl Shared {
    pub fn new(state: MachineState, listener: Arc<dyn OperatorListener>) -> Self {
        let (actor, kept) = (Actor::connecting(), Mutex::new(SharedState::new(state)));
        Self { listener, actor, kept, answered: Condvar::new() }
    }

    /// What a thread that failed left behind is still true.
    pub fn lock(&self) -> MutexGuard<'_, SharedState> {
        self.kept.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub fn state(&self) -> MachineState {
        let view = self.actor.view();
        self.lock().state(view)
    }

    /// Takes an order, if it is possible now. `job`: what it is about, where it is about a wire.
    pub fn order(&self, order: Order, job: Option<Input>) -> Result<(), OperatorError> {
        if order.is_of_job() && job.is_none() {
            return Err(OperatorError::NoJob { order: order.name() });
        }
        if let Order::Speed { percent } = order
            && !SPEEDS.contains(&percent)
        {
            return Err(OperatorError::Speed { percent });
        }
        // What failed before is over with the next order; a pause is none, nor is another speed.
        let goes_on = matches!(order, Order::Pause | Order::Resume | Order::Speed { .. });
        let taken = || {
            if !goes_on {
                let mut kept = self.lock();
                kept.problem_before = kept.state.problem.take();
            }
        };
        Ok(self.actor.order(Ordered { order, job }, taken)?)
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
                "made, not-made, as-counted where it was, a part, or no when it is not known",
            ),
            QuestionKind::Head => (
                matches!(answer, Answer::Head(deg) if within(deg)),
                "where the head stands, within the limits of its cable, or no when it is not known",
            ),
            _ => (answer == Answer::Yes, "yes or no"),
        };
        if !fits && answer != Answer::No {
            return Err(OperatorError::WrongAnswer { id, expected });
        }
        kept.answer = Some(answer);
        self.answered.notify_all();
        Ok(())
    }

    /// Stops the machine, from any thread. Whether there is one to stop, or will be once it is connected.
    pub fn stop(&self) -> bool {
        let stopped = self.actor.stop();
        self.withdraw();
        stopped
    }

    /// The machine can be stopped from here on; a stop that was asked for before comes now.
    pub fn can_be_stopped(&self, handle: &StopHandle) {
        if self.actor.connected(handle) {
            self.withdraw();
        }
    }

    /// Answers the open question with no.
    fn withdraw(&self) {
        self.lock().withdraw();
        self.answered.notify_all();
    }

    /// Has the operator's thread end: what moves is stopped.
    pub fn close(&self) {
        let under_way = self.actor.close();
        self.withdraw();
        if under_way {
            let _ = self.stop();
        }
    }

    /// The order is done, if there was one, and the machine at rest: as its session says, or failed where there is none.
    pub fn rest(&self, snapshot: Option<&Snapshot>, change: impl FnOnce(&mut MachineState)) {
        let before = self.state();
        self.actor.rest(snapshot);
        {
            let mut kept = self.lock();
            (kept.state.doing, kept.wire_told) = (None, None);
            change(&mut kept.state);
        }
        if self.state() != before {
            self.actor.changed();
        }
        self.catch_up();
    }

    /// How the machine stands while an order is carried out.
    pub fn stands(&self, snapshot: &Snapshot) {
        self.actor.publish(snapshot);
        // Of what was not ordered the wire of before is none.
        let news =
            self.actor.is_busy().then(|| self.lock().take_progress(snapshot, Instant::now())).flatten();
        self.catch_up();
        if let Some(news) = news {
            self.hear(&OperatorEvent::Machine(news));
        }
    }

    /// How far the machine is in the step that it runs.
    pub fn is_in_step(&self, part: f64) {
        let news = self.lock().take_in_step(part, Instant::now());
        if let Some(news) = news {
            self.hear(&OperatorEvent::Machine(news));
        }
    }

    pub fn wished(&self) -> Option<Wish> {
        self.catch_up();
        self.actor.wish()
    }

    /// Reports what another thread has changed.
    pub fn catch_up(&self) {
        if self.actor.take_changed() {
            self.hear(&OperatorEvent::State(Box::new(self.state())));
        }
    }

    pub fn hear(&self, event: &OperatorEvent) {
        self.lock().follow_by_hand(event);
        self.listener.hear(event);
    }

    /// The wire that is told is the next one, which has not begun yet.
    pub fn wait_for_wire(&self) {
        self.lock().wire_waits = true;
    }

    /// Changes the state; it is reported if it is another one then.
    pub fn change(&self, change: impl FnOnce(&mut MachineState)) {
        let changed = {
            let mut kept = self.lock();
            let before = kept.state.clone();
            change(&mut kept.state);
            kept.state != before
        };
        if changed {
            self.actor.changed();
        }
        self.catch_up();
    }

    /// What had gone wrong before the order still is what is wrong, as nothing else is.
    pub fn is_as_before(&self) {
        let mut kept = self.lock();
        let before = kept.problem_before.take();
        kept.state.problem = kept.state.problem.take().or(before);
    }

    /// Changes what is reported as news, and so not as a state.
    pub fn change_untold(&self, change: impl FnOnce(&mut MachineState)) {
        change(&mut self.lock().state);
    }

    /// A phase that the session does not know of.
    pub fn enter(&self, phase: Phase) {
        self.actor.enter(phase);
        self.catch_up();
    }

    /// The signs of the machine.
    pub fn know(&self, signs: Signs) {
        self.lock().signs = Some(signs);
    }

    pub fn problem(&self, problem: ProblemReport) {
        tracing::info!(code = %problem.code, "{}", problem.message);
        self.hear(&OperatorEvent::Problem(problem.clone()));
        self.change(|state| state.problem = Some(problem));
    }

    /// Reports how a stop went once it is over, if there was one.
    pub fn tell_stop(&self) -> Option<StopOutcome> {
        let outcome = self.actor.take_stop()?;
        let StopOutcome { by, driver_ended, took } = outcome;
        let took_ms = u64::try_from(took.as_millis()).unwrap_or(u64::MAX);
        self.hear(&OperatorEvent::Stopped { by, driver_ended, took_ms });
        Some(outcome)
    }

    pub fn about(&self, lines: Vec<String>) {
        self.lock().lines = lines;
    }

    /// Asks a person; `lines` are those that were shown last where none are given.
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
            (kept.state.question, kept.answer, kept.withdrawn) = (Some(asked.clone()), None, false);
            asked
        };
        // A stop or the end of the connection has answered. It is looked up after the question is there to be withdrawn.
        if self.actor.asks(true) {
            self.withdraw();
        }
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
                Some(left) => {
                    self.answered.wait_timeout(kept, left).unwrap_or_else(PoisonError::into_inner).0
                }
                None => self.answered.wait(kept).unwrap_or_else(PoisonError::into_inner),
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
            (kept.state.question.take().map(|open| open.id), answer)
        };
        let _ = self.actor.asks(false);
        if let Some(id) = id {
            self.hear(&OperatorEvent::Answered { id, answer });
        }
        self.catch_up();
        answer
    }

    pub fn record(&self, made: Move) {
        {
            let mut kept = self.lock();
            kept.recorded.push(made);
            kept.state.recorded = kept.recorded.len();
        }
        self.actor.changed();
    }

    pub fn recorded(&self) -> Vec<Move> {
        self.lock().recorded.clone()
    }

    pub fn clear_recording(&self) {
        {
            let mut kept = self.lock();
            kept.recorded.clear();
            kept.state.recorded = 0;
        }
        self.actor.changed();
    }

    /// The operator's thread is at its end.
    pub fn end(&self, phase: Phase) {
        {
            let mut kept = self.lock();
            (kept.state.question, kept.state.doing) = (None, None);
        }
        self.actor.end(phase, || {
            // A listener that has failed is not asked again.
            if !std::thread::panicking() {
                self.catch_up();
            }
        });
    }
}
