//! Homing, and moves by hand.

use std::path::Path;
use std::time::Instant;

use wirebend_driver_host::api::ReferenceBy;
use wirebend_driver_host::{OrderName, Permit, PermitKind, Phase};

use super::event::OperatorEvent;
use super::jog_permit::JogPermit;
use super::question::QuestionKind;
use super::thread::OperatorThread;
use crate::by_hand::{DryRun, MoveProgress, MoveRow, check_moves, lines, make_all, moves_of, require};
use crate::live::Zero;
use crate::{LiveProblem, Move, OperationError, OperatorError, Repeat, RunHow};
use wirebend_planning::design::Input;

impl OperatorThread<'_> {
    pub fn home(&mut self) -> Result<(), OperationError> {
        self.move_by_hand(
            OrderName::Home,
            &MoveRow { moves: &[Move::Home], notes: Vec::new(), dry: None },
            false,
        )
    }

    pub fn jog(&mut self, moves: &[Move], record: bool) -> Result<(), OperationError> {
        check_moves(moves)?;
        self.move_by_hand(OrderName::Jog, &MoveRow { moves, notes: Vec::new(), dry: None }, record)
    }

    pub fn replay(&mut self, file: Option<&Path>, other_machine: bool) -> Result<(), OperationError> {
        let (moves, more) = match file {
            Some(file) => moves_of(&Input::File(file.to_owned()), &self.machine, other_machine)?,
            None => (self.recorded()?, Vec::new()),
        };
        // Many moves at one word: a permit for moves one by one is none for them.
        self.jog_permit = None;
        self.move_by_hand(OrderName::Replay, &MoveRow { moves: &moves, notes: more, dry: None }, false)
    }

    /// The moves of a wire with no wire loaded.
    pub fn dry_run(&mut self, job: Input, wire: usize, accept_settings: bool) -> Result<(), OperationError> {
        let task = self.task(job, Some(wire), RunHow::Begin, Repeat::default(), accept_settings)?;
        let dry = DryRun::of(&task, wire)?;
        let moves = dry.moves()?;
        self.jog_permit = None;
        self.move_by_hand(
            OrderName::DryRun,
            &MoveRow { moves: &moves, notes: dry.lines(), dry: Some(dry) },
            false,
        )
    }

    fn recorded(&self) -> Result<Vec<Move>, OperationError> {
        let moves = self.shared.recorded();
        if moves.is_empty() { Err(OperatorError::NothingRecorded.into()) } else { Ok(moves) }
    }

    fn move_by_hand(&mut self, order: OrderName, row: &MoveRow, record: bool) -> Result<(), OperationError> {
        let moves = row.moves;
        let at_reference = self.at_reference;
        let by_hand = self.is_zeroed_by_hand();
        let connection = self.connected(order)?;
        require(connection, row)?;
        // A recording counts from the reference. Where a person brings the axes to zero, they do it by jogging.
        let homed = matches!(connection.session.phase(), Phase::Ready | Phase::Moving | Phase::Armed);
        let homes = match order {
            OrderName::Replay | OrderName::DryRun => !at_reference,
            _ => by_hand && !homed,
        } && moves.first() != Some(&Move::Home)
            && connection.can_home();
        self.settle_head(order, homes || moves.first() == Some(&Move::Home))?;
        let sets_zero = order == OrderName::Home && by_hand;
        let mut permit = if sets_zero { None } else { Some(self.permit_to_move(order, row, homes)?) };
        if homes || moves.first() == Some(&Move::Home) {
            let zero = if homes && order == OrderName::Jog { Zero::Moves } else { Zero::Wire };
            permit = permit.or(self.ask_zero(order, zero)?);
        }
        let permit = permit.ok_or(LiveProblem::NotConfirmed)?;
        self.armed = None;
        let (signs, shared) = (self.signs, self.shared);
        // Until they are where a wire begins again.
        let mut at_reference = at_reference || (homes && order != OrderName::Jog);
        let connection = self.connected(order)?;
        connection.wire_used |=
            row.dry.is_none() && moves.iter().any(|one| matches!(one, Move::Feed { .. } | Move::Bend { .. }));
        let mut told = |progress| {
            let made = match progress {
                // Nothing of a dry run is in a wire that is drawn.
                MoveProgress::Begins(one) if row.dry.is_none() => return shared.begin_move(one),
                MoveProgress::Begins(_) => return,
                MoveProgress::Made(one) => one,
            };
            at_reference = match made {
                Move::Home => true,
                Move::Feed { .. } => at_reference,
                Move::Rotate { .. } | Move::Bend { .. } => false,
            };
            if record {
                shared.record(made);
            }
            if row.dry.is_none() {
                shared.hear(&OperatorEvent::Jogged { made });
            }
            shared.catch_up();
        };
        let homed =
            if homes { connection.home(&permit).map(|()| shared.enter(Phase::Moving)) } else { Ok(()) };
        let made = homed.and_then(|()| make_all(connection, signs, row, false, &permit, &mut told));
        // One that was not finished has turned something.
        self.at_reference = at_reference && made.is_ok();
        made?;
        // A dry run was confirmed for itself alone.
        if !sets_zero && row.dry.is_none() {
            self.jog_permit = Some(JogPermit::new(permit, Instant::now()));
        }
        Ok(())
    }

    /// Whether a person brings the axes to their reference.
    fn is_zeroed_by_hand(&self) -> bool {
        self.connection.as_ref().is_some_and(|connection| connection.reference() == ReferenceBy::Person)
    }

    /// Asks whether every axis stands at zero, where a person brings them there: each time, whatever they have said before.
    /// Their yes is enough to set zero, for which nothing moves.
    pub fn ask_zero(&mut self, order: OrderName, wanted: Zero) -> Result<Option<Permit>, OperationError> {
        if !self.is_zeroed_by_hand() {
            return Ok(None);
        }
        let lines = self.connected(order)?.zero_lines(wanted);
        let permit = self.ask(QuestionKind::Move, PermitKind::ByHand, lines, wanted.question())?;
        self.connected(order)?.zero_was_said(wanted)?;
        Ok(Some(permit))
    }

    /// A person's word that the machine may be moved, which holds for a while. Where nothing moves, the user is asked only
    /// about many moves at one word: a dry run is practised as it is done, and what is in a file they have not seen.
    fn permit_to_move(
        &mut self,
        order: OrderName,
        row: &MoveRow,
        homes: bool,
    ) -> Result<Permit, OperationError> {
        let simulation = self.connected(order)?.session.simulated();
        if let Some(simulation) =
            simulation.filter(|_| !matches!(order, OrderName::Replay | OrderName::DryRun))
        {
            return Ok(simulation.permit(PermitKind::ByHand));
        }
        if let Some(permit) = self.jog_permit.take().and_then(|permit| permit.holds(Instant::now())) {
            return Ok(permit);
        }
        let machine = self.machine.clone();
        let mut about = lines(self.connected(order)?, &machine, row, homes);
        if row.moves.contains(&Move::Home) && !self.is_zeroed_by_hand() {
            about.push("homing moves the bend axis at once".to_owned());
        }
        self.ask(QuestionKind::Move, PermitKind::ByHand, about, row.question())
    }
}
