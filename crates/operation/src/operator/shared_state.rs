//! What both threads share of a person: what they are asked, and what they read besides how the machine stands.

use std::time::{Duration, Instant};

use wirebend_driver_host::{ActorOrder, ActorView, Because, NotTaken, OrderName, Orders, Snapshot};
use wirebend_error::ProblemReport;
use wirebend_planning::signs::Signs;

use super::state::MachineState;
use crate::by_hand::WireByHand;
use crate::error::OperatorError;
use crate::order::{Answer, Order};
use crate::{MachineEvent, Move, Wish};
use wirebend_planning::Input;

/// How often it is reported how far a wire is, at least.
const NEWS: Duration = Duration::from_millis(200);

/// An order, and the job that it is about.
#[derive(Debug)]
pub(super) struct Ordered {
    pub order: Order,
    /// For [`Order::is_of_job`].
    pub job: Option<Input>,
}

impl ActorOrder for Ordered {
    fn name(&self) -> OrderName {
        self.order.name()
    }

    fn homes_first(&self) -> bool {
        matches!(&self.order, Order::Jog { moves, .. } if moves.first() == Some(&Move::Home))
    }

    fn wish(&self) -> Option<Wish> {
        match self.order {
            Order::Pause => Some(Wish::Pause),
            Order::Resume => Some(Wish::Resume),
            Order::Speed { percent } => Some(Wish::Speed(percent)),
            _ => None,
        }
    }
}

impl From<NotTaken> for OperatorError {
    fn from(NotTaken { order, because, phase }: NotTaken) -> Self {
        match because {
            Because::QuestionOpen => Self::QuestionOpen { order },
            Because::Busy => Self::Busy { order },
            Because::Unable => Self::Unable { order },
            _ => Self::NotNow { order, phase },
        }
    }
}

/// What both threads share besides the actor.
pub(super) struct SharedState {
    /// The state without what the actor says of it.
    pub state: MachineState,
    /// The signs of the machine, once that is known.
    pub signs: Option<Signs>,
    /// What had gone wrong before the order that is carried out.
    pub problem_before: Option<ProblemReport>,
    /// The number of the last question.
    pub asked: u64,
    pub answer: Option<Answer>,
    /// A stop or the end of the connection has answered the last question.
    pub withdrawn: bool,
    /// What was said last about what is to come.
    pub lines: Vec<String>,
    pub recorded: Vec<Move>,
    /// When it was reported last how far the wire is, while an order is carried out.
    pub wire_told: Option<Instant>,
    /// The wire is one that has not begun yet: what the session says is of the one before.
    pub wire_waits: bool,
    pub by_hand: WireByHand,
}

impl SharedState {
    pub fn new(state: MachineState) -> Self {
        Self {
            state,
            signs: None,
            problem_before: None,
            asked: 0,
            answer: None,
            withdrawn: false,
            lines: Vec::new(),
            recorded: Vec::new(),
            wire_told: None,
            wire_waits: false,
            by_hand: WireByHand::default(),
        }
    }

    /// The state, with what the actor says of it.
    pub fn state(&self, view: ActorView) -> MachineState {
        let ActorView {
            phase,
            busy,
            orders: Orders { can, cannot },
            simulated,
            identity,
            position,
            speed_percent,
        } = view;
        let position = position.zip(self.signs).map(|(position, signs)| signs.canonical(position));
        let may_move = phase.may_move();
        MachineState {
            phase,
            may_move,
            busy,
            simulated,
            identity,
            position,
            speed_percent,
            can,
            cannot,
            ..self.state.clone()
        }
    }

    /// How far the wire is that an order is carried out for, as the session says; the news of it, where they are due.
    pub fn take_progress(&mut self, snapshot: &Snapshot, now: Instant) -> Option<MachineEvent> {
        self.wire_waits &= !snapshot.phase.is_in_a_wire();
        if self.wire_waits {
            return None;
        }
        let (wire, progress) = self.state.wire.as_mut().zip(snapshot.wire)?;
        let before = wire.clone();
        wire.take(progress);
        let rests = self.wire_told.is_some_and(|told| now.saturating_duration_since(told) < NEWS);
        if before == *wire || (before.made == wire.made && rests) {
            return None;
        }
        self.wire_told = Some(now);
        Some(wire.news())
    }

    /// How far the machine is in the step that it runs; the news of it.
    pub fn take_in_step(&mut self, part: f64, now: Instant) -> Option<MachineEvent> {
        let wire = self.state.wire.as_mut()?;
        wire.in_step = part;
        self.wire_told = Some(now);
        Some(wire.news())
    }

    /// Answers the open question with no, which nobody has said.
    pub const fn withdraw(&mut self) {
        if self.state.question.is_some() {
            (self.answer, self.withdrawn) = (Some(Answer::No), true);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::operator::{ConnectRequest, Question, QuestionKind};

    /// Were a yes of before to count, a machine would move because of what was said before it was stopped.
    #[test]
    fn a_question_that_is_withdrawn_is_answered_with_no() {
        let mut kept = SharedState::new(MachineState::connecting(ConnectRequest::simulated("kit")));
        kept.withdraw();
        assert_eq!(kept.answer, None, "nobody is asked");
        kept.state.question = Some(Question {
            id: 1,
            kind: QuestionKind::Move,
            lines: Vec::new(),
            question: String::new(),
            doubt: None,
            head: None,
        });
        kept.answer = Some(Answer::Yes);
        kept.withdraw();
        assert_eq!(kept.answer, Some(Answer::No));
    }
}
