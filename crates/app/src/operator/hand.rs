//! Homing, and moves by hand.

use std::time::Instant;

use wirebend_driver_host::State;
use wirebend_driver_host::api::ReferenceBy;

use super::event::{OperatorEvent, QuestionKind};
use super::leave::Leave;
use super::order::OrderName;
use super::post::Post;
use super::state::Phase;
use crate::by_hand::{QUESTION, lines, make_all, moves_of, require};
use crate::design::Input;
use crate::live::{Yes, Zero};
use crate::{AppError, Move};

impl Post<'_> {
    pub fn home(&mut self) -> Result<(), AppError> {
        self.move_by_hand(OrderName::Home, &[Move::Home], Vec::new(), false)
    }

    pub fn jog(&mut self, moves: &[Move], record: bool) -> Result<(), AppError> {
        if moves.is_empty() {
            let expected = "say what to move, such as a feed of 10 mm";
            return Err(AppError::Value { name: "the row of moves", value: "empty".to_owned(), expected });
        }
        moves.iter().try_for_each(|one| one.check())?;
        self.move_by_hand(OrderName::Jog, moves, Vec::new(), record)
    }

    pub fn replay(&mut self, file: &Input, other_machine: bool) -> Result<(), AppError> {
        let (moves, more) = moves_of(file, &self.machine, other_machine)?;
        // Many moves at one word: a leave for moves one by one is none for them.
        self.leave = None;
        self.move_by_hand(OrderName::Replay, &moves, more, false)
    }

    fn move_by_hand(
        &mut self,
        order: OrderName,
        moves: &[Move],
        more: Vec<String>,
        record: bool,
    ) -> Result<(), AppError> {
        let at_reference = self.at_reference;
        let by_hand = self.is_zeroed_by_hand();
        let connection = self.connected(order)?;
        require(connection, moves)?;
        // A recording counts from the reference. Where a person brings the axes to zero, they do it by jogging.
        let homed = matches!(connection.session.state(), State::Homed | State::Armed | State::Done);
        let homes = match order {
            OrderName::Replay => !at_reference,
            _ => by_hand && !homed,
        } && moves.first() != Some(&Move::Home)
            && connection.can_home();
        self.settle_head(order, homes || moves.first() == Some(&Move::Home))?;
        let sets_zero = order == OrderName::Home && by_hand;
        let yes = if sets_zero {
            // Nothing moves for it.
            Yes::where_nothing_moves()
        } else {
            self.leave_to_move(order, moves, more, homes)?
        };
        if homes || moves.first() == Some(&Move::Home) {
            self.ask_zero(order, if homes && order == OrderName::Jog { Zero::Moves } else { Zero::Wire })?;
        }
        self.armed = None;
        let (signs, shared) = (self.signs, self.shared);
        shared.enter(if order == OrderName::Home { Phase::Homing } else { Phase::Moving });
        // Until they are where a wire begins again.
        let mut at_reference = at_reference || (homes && order != OrderName::Jog);
        let connection = self.connected(order)?;
        connection.wire_used |= moves.iter().any(|one| matches!(one, Move::Feed { .. } | Move::Bend { .. }));
        let mut told = |made| {
            at_reference = match made {
                Move::Home => true,
                Move::Feed { .. } => at_reference,
                Move::Rotate { .. } | Move::Bend { .. } => false,
            };
            if record {
                shared.record(made);
            }
            shared.hear(&OperatorEvent::Jogged { made });
            shared.catch_up();
            // What comes after a homing is none.
            if made == Move::Home && order != OrderName::Home {
                shared.enter(Phase::Moving);
            }
        };
        let homed = if homes { connection.home(&yes).map(|()| shared.enter(Phase::Moving)) } else { Ok(()) };
        let made = homed.and_then(|()| make_all(connection, signs, moves, false, &yes, &mut told));
        // One that was not made to its end has turned something.
        self.at_reference = at_reference && made.is_ok();
        made?;
        if !sets_zero {
            self.leave = Some(Leave::new(yes, Instant::now()));
        }
        Ok(())
    }

    /// Whether a person brings the axes to their reference.
    fn is_zeroed_by_hand(&self) -> bool {
        self.connection.as_ref().is_some_and(|connection| connection.reference() == ReferenceBy::Person)
    }

    /// Asks whether every axis stands at zero, where a person brings them there: each time, whatever they have said before.
    pub fn ask_zero(&mut self, order: OrderName, wanted: Zero) -> Result<(), AppError> {
        if self.is_zeroed_by_hand() {
            let lines = self.connected(order)?.zero_lines(wanted);
            self.ask(QuestionKind::Move, lines, wanted.question())?;
            self.connected(order)?.zero_was_said(wanted)?;
        }
        Ok(())
    }

    /// A person's word that the machine may be moved, which holds for a while. Where nothing moves nobody is asked but for what is in a file,
    /// which they have not seen.
    fn leave_to_move(
        &mut self,
        order: OrderName,
        moves: &[Move],
        more: Vec<String>,
        homes: bool,
    ) -> Result<Yes, AppError> {
        if self.is_simulated() && order != OrderName::Replay {
            return Ok(Yes::where_nothing_moves());
        }
        if let Some(yes) = self.leave.take().and_then(|leave| leave.holds(Instant::now())) {
            return Ok(yes);
        }
        let machine = self.machine.clone();
        let mut about = lines(self.connected(order)?, &machine, moves, more, homes);
        if moves.contains(&Move::Home) && !self.is_zeroed_by_hand() {
            about.push("to search its reference it moves the bend axis at once".to_owned());
        }
        self.ask(QuestionKind::Move, about, QUESTION)
    }
}
