//! What both threads share, and what follows from it.

use std::collections::BTreeSet;

use wirebend_driver_host::api::{Capability, ReferenceBy};
use wirebend_driver_host::{StopHandle, StopOutcome};

use super::error::OperatorError;
use super::order::{Answer, Order, OrderName};
use super::state::{MachineState, Phase, allowed, knows};
use crate::{Move, Wish};

/// Whether there still is an operator.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Life {
    Open,
    /// Its thread is to end.
    Closing,
    /// It has.
    Ended,
}

/// What both threads share.
pub(super) struct Kept {
    pub state: MachineState,
    /// What the driver of the machine can do; nothing as long as none is connected.
    pub abilities: BTreeSet<Capability>,
    /// Where a person brings its axes to zero, by jogging too, it can be moved by hand before it is homed.
    pub reference: ReferenceBy,
    /// The state was changed by another thread, and nobody has heard of it.
    pub untold: bool,
    pub order: Option<Order>,
    /// An order was given and is not done.
    pub busy: bool,
    /// The number of the last question.
    pub asked: u64,
    pub answer: Option<Answer>,
    /// What was said last about what is to come.
    pub lines: Vec<String>,
    pub wish: Option<Wish>,
    pub stop: Option<StopHandle>,
    /// A stop was asked for before there was anything to stop.
    pub stop_wanted: bool,
    /// Stops that are on their way.
    pub stops: u32,
    /// How the last one went, which nobody has heard of.
    pub outcome: Option<StopOutcome>,
    pub recorded: Vec<Move>,
    pub life: Life,
}

impl Kept {
    pub fn new(state: MachineState) -> Self {
        Self {
            state,
            abilities: BTreeSet::new(),
            reference: ReferenceBy::default(),
            untold: true,
            order: None,
            // It is being connected.
            busy: true,
            asked: 0,
            answer: None,
            lines: Vec::new(),
            wish: None,
            stop: None,
            stop_wanted: false,
            stops: 0,
            outcome: None,
            recorded: Vec::new(),
            life: Life::Open,
        }
    }

    /// The state with what can be ordered in it.
    pub fn state(&self) -> MachineState {
        let phase = self.state.phase;
        let waits = self.busy && !matches!(phase, Phase::Making | Phase::Holding);
        let can = if waits || self.life == Life::Ended || self.state.question.is_some() {
            &[]
        } else {
            allowed(phase)
        };
        let jog = self.jogs_first(phase) && !can.is_empty();
        let can = can
            .iter()
            .copied()
            .chain(jog.then_some(OrderName::Jog))
            .filter(|order| knows(&self.abilities, *order))
            .collect();
        let busy = self.busy && self.life != Life::Ended;
        MachineState { busy, can, ..self.state.clone() }
    }

    /// Whether an order makes sense now.
    pub fn may(&self, order: &Order) -> Result<(), OperatorError> {
        let (order_name, phase) = (order.name(), self.state.phase);
        if self.life == Life::Ended {
            return Err(OperatorError::NotNow { order: order_name, phase });
        }
        if self.state.question.is_some() {
            return Err(OperatorError::QuestionOpen { order: order_name });
        }
        let at_work = matches!(phase, Phase::Making | Phase::Holding);
        let finds_itself = matches!(order, Order::Jog { moves, .. } if moves.first() == Some(&Move::Home));
        let homes = (finds_itself && matches!(phase, Phase::Connected | Phase::Stopped))
            || (order_name == OrderName::Jog && self.jogs_first(phase));
        if !allowed(phase).contains(&order_name) && !homes {
            return Err(OperatorError::NotNow { order: order_name, phase });
        }
        if self.busy && !at_work {
            return Err(OperatorError::Busy { order: order_name });
        }
        if knows(&self.abilities, order_name) {
            return Ok(());
        }
        Err(match phase {
            Phase::Failed => OperatorError::NotNow { order: order_name, phase },
            _ => OperatorError::Unable { order: order_name },
        })
    }

    fn jogs_first(&self, phase: Phase) -> bool {
        self.reference == ReferenceBy::Person && matches!(phase, Phase::Connected | Phase::Stopped)
    }

    /// A stop is on its way.
    pub fn stop_begins(&mut self) {
        self.stops += 1;
        // What was ordered before was ordered of a machine that nobody had stopped.
        (self.order, self.wish) = (None, None);
        (self.state.phase, self.untold) = (Phase::Stopping, true);
    }

    /// Answers the open question with no.
    pub fn withdraw(&mut self) {
        if self.state.question.is_some() {
            self.answer = Some(Answer::No);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::operator::{Question, QuestionKind};

    /// Were it still to be carried out, a machine would move because of what was said before somebody stopped it.
    #[test]
    fn a_stop_throws_away_what_was_ordered_and_answers_with_no() {
        let mut kept = Kept::new(MachineState::connecting("kit".to_owned(), None));
        (kept.order, kept.wish, kept.answer) = (Some(Order::Home), Some(Wish::Resume), Some(Answer::Yes));
        kept.state.question = Some(Question {
            id: 1,
            kind: QuestionKind::Move,
            lines: Vec::new(),
            question: String::new(),
            doubt: None,
            head: None,
        });
        kept.stop_begins();
        kept.withdraw();
        assert_eq!((&kept.order, kept.wish, kept.answer), (&None, None, Some(Answer::No)));
        assert_eq!(kept.state.phase, Phase::Stopping);
        kept.state.question = None;
        let error = kept.may(&Order::Home).unwrap_err();
        assert_eq!(error, OperatorError::NotNow { order: OrderName::Home, phase: Phase::Stopping });
    }
}
