//! A wire: armed, started, resumed, given up.

use wirebend_driver_host::api::DoneBy;
use wirebend_driver_host::{OrderName, Permit, Phase, Standstill};
use wirebend_planning::PlanningError;

use super::armed::ArmedWire;
use super::event::OperatorEvent;
use super::question::QuestionKind;
use super::state::WireState;
use super::thread::{OperatorThread, with_power};
use super::unfinished::Unfinished;
use crate::error::OperatorError;
use crate::live::{Answers, Connection, Unnamed, Zero, connect};
use crate::run::{AfterCut, Task, WirePermit, about};
use crate::{Decided, LiveProblem, OperationError, Repeat, RunHow, RunRequest, RunResponse};
use wirebend_planning::design::Input;

impl<'a> OperatorThread<'a> {
    /// Checks a wire, or all of them one after the other, and asks; nothing moves.
    pub fn arm(
        &mut self,
        job: Input,
        wire: Option<usize>,
        repeat: Repeat,
        accept_settings: bool,
    ) -> Result<(), OperationError> {
        self.armed = None;
        let task = self.task(job, wire, RunHow::Begin, repeat, accept_settings)?;
        let wanted = task.wanted();
        for &wire in &wanted {
            task.require_clear(wire).inspect_err(|_| self.look_for_unfinished(&task, wire))?;
        }
        let homes = self.homes_first();
        let connection = self.connected(OrderName::Arm)?;
        connection.require_settings(task.setup.machine_id(), accept_settings)?;
        wanted.iter().try_for_each(|&wire| task.require_within(connection, wire, 1))?;
        task.require_cutter(connection, &wanted)?;
        self.settle_head(OrderName::Arm, homes)?;
        let wire = *wanted.first().ok_or(LiveProblem::NoWire { wire: 0, count: 0 })?;
        let connection = self.connected(OrderName::Arm)?;
        let lines = about(&task, connection, wire, Some(task.wire_lines(wire)?), homes)?;
        let question = "Is the wire in, and may the machine move once it is started?";
        let permit = self.ask(QuestionKind::Arm, task.permit_kind(), lines, question)?;
        let connection = self.connected(OrderName::Arm)?;
        (connection.wire_used, connection.wire_bent) = (false, false);
        task.wire_confirmed(wire)?;
        let done_by = connection.session.done_by();
        // A user who has asked for a wire has their hands at the machine.
        self.jog_permit = None;
        self.armed = Some(ArmedWire { task, wire, done_by, permit });
        Ok(())
    }

    pub fn start(&mut self) -> Result<(), OperationError> {
        let phase = self.shared.state().phase;
        let not_now = || OperatorError::NotNow { order: OrderName::Start, phase };
        let ArmedWire { task, mut permit, done_by, .. } = self.armed.take().ok_or_else(not_now)?;
        let wanted = task.wanted();
        let mut sequence = task.sequence(&wanted).peekable();
        while let Some((wire, rest)) = sequence.next() {
            self.shared.wait_for_wire();
            let homes = self.homes_first();
            // Another program may have begun it meanwhile.
            task.require_clear(wire)?;
            if homes {
                // Before anything of the wire is written down.
                self.ask_zero(OrderName::Start, Zero::Wire)?;
            }
            let connection = self.connection.take().ok_or_else(not_now)?;
            let permitted = WirePermit::new(&connection.session, permit, task.request.repeat.cut);
            let WirePermit { wire: of_wire, row } = match permitted {
                Ok(permitted) => permitted,
                Err(error) => {
                    self.connection = Some(connection);
                    return Err(error.into());
                }
            };
            let mut response = task.response();
            response.port = Some(connection.port.clone());
            response.identity = Some(connection.session.identity().to_owned());
            self.at_reference = false;
            let (connection, made) = task.make(connection, wire, homes, of_wire, &mut response);
            self.connection = connection;
            if let Some(connection) = &mut self.connection {
                connection.wire_bent |= !response.wires.is_empty();
            }
            let whole = response.wires.last().is_some_and(|made| made.outcome.is_whole());
            task.wire_ended(wire, rest.is_empty(), &mut response)?;
            let after = match (row, &mut self.connection) {
                (Some(row), Some(connection)) if whole => task.cut_off(connection, row, &mut response),
                _ => AfterCut::Asks,
            };
            let ends = !whole || matches!(after, AfterCut::Ends);
            response.left = rest.to_vec();
            self.tell_run(&task, wire, response);
            made?;
            let Some(&(next, _)) = sequence.peek().filter(|_| !ends) else { return Ok(()) };
            permit = match after {
                AfterCut::GoesOn(row) if task.goes_on(next) => row,
                _ => self.ask_for_next(&task, next, done_by)?,
            };
            task.wire_confirmed(next)?;
            let told = WireState::of(&task, next, task.request.job.stem(), 0, done_by);
            self.shared.change(|state| state.wire = Some(told));
        }
        Ok(())
    }

    /// Asks for the next of several wires. Nothing moves before a person has cut off the one before.
    fn ask_for_next(&mut self, task: &Task, wire: usize, done_by: DoneBy) -> Result<Permit, OperationError> {
        self.shared.wait_for_wire();
        let next = WireState::of(task, wire, task.request.job.stem(), 0, done_by);
        self.shared.change(|state| state.wire = Some(next));
        let homes = self.homes_first();
        let connection = self.connected(OrderName::Start)?;
        let lines = about(task, connection, wire, Some(task.wire_lines(wire)?), homes)?;
        let question = task.pieces.get().question(task.wire(wire)?);
        self.ask(QuestionKind::Piece, task.permit_kind(), lines, question)
    }

    /// Resumes through the connection that there is, or through a new one where that has failed: there the machine
    /// may still be in the wire.
    pub fn resume_run(
        &mut self,
        job: Input,
        wire: usize,
        decided: Option<Decided>,
        accept_settings: bool,
    ) -> Result<(), OperationError> {
        self.armed = None;
        let task =
            self.task(job, Some(wire), RunHow::Resume { decided }, Repeat::default(), accept_settings)?;
        let mut response = task.response();
        let Some(interrupted) = task.interrupted(&mut response)? else {
            self.tell_run(&task, wire, response);
            return Ok(());
        };
        let state = self.shared.state();
        if let (None, Some(port)) = (&self.named, &state.port)
            && interrupted.begun_at() != *port
        {
            let (begun_at, port) = (interrupted.begun_at(), port.clone());
            return Err(OperatorError::BegunElsewhere { wire, begun_at, port }.into());
        }
        if self.is_out_of_order() {
            // So a stop is kept until there is something to stop.
            self.shared.enter(Phase::Connecting);
            // The port is kept open meanwhile, lest a board be reset.
            self.connection = None;
            if let Some(line) = &self.line {
                line.share();
            }
            let begun_at = interrupted.begun_at();
            let at = task.at(Some(&interrupted), Unnamed::SimulateAgain(&begun_at));
            let connection = connect(self.app, &at, self.shared)?;
            self.is_connected(connection);
        }
        // A machine that still is in the wire knows it itself.
        let knows =
            self.connection.as_ref().is_some_and(|connection| connection.session.resume_state().is_some());
        if !knows && !interrupted.is_made() {
            self.settle_head(OrderName::ResumeRun, !self.at_reference)?;
        }
        let not_now = OperatorError::NotNow { order: OrderName::ResumeRun, phase: state.phase };
        let connection = self.connection.take().ok_or(not_now)?;
        let done_by = connection.session.done_by();
        let resumed = WireState::of(&task, wire, interrupted.name(), interrupted.made(), done_by);
        self.shared.change(|state| state.wire = Some(resumed));
        let homes = !self.at_reference;
        (self.jog_permit, self.at_reference) = (None, false);
        let (connection, made) = task.resume_through(connection, interrupted, homes, decided, &mut response);
        self.connection = connection;
        if let (Ok(()), Some(connection)) = (&made, &mut self.connection) {
            (connection.wire_used, connection.wire_bent) = (false, true);
        }
        if self.is_in_a_wire() {
            // Without a yes the machine is left where it is: it holds, and the user is asked again when it is to resume.
            self.connection = None;
            self.tell_run(&task, wire, response);
            return match made {
                Err(OperationError::Live(LiveProblem::Declined)) => {
                    Err(OperatorError::LeftInWire { wire }.into())
                }
                made => made,
            };
        }
        self.tell_run(&task, wire, response);
        made
    }

    pub fn abandon(&mut self, job: Input, wire: usize) -> Result<(), OperationError> {
        let task = self.task(job, Some(wire), RunHow::Abandon, Repeat::default(), false)?;
        let response = task.abandon()?;
        self.tell_run(&task, wire, response);
        Ok(())
    }

    /// A job for this machine, as this connection can run it. `wire`: absent, all of them.
    pub fn task(
        &self,
        job: Input,
        wire: Option<usize>,
        how: RunHow,
        repeat: Repeat,
        accept_settings: bool,
    ) -> Result<Task<'a>, OperationError> {
        let port = self.named.clone();
        let request = RunRequest {
            job,
            machine: None,
            material: None,
            // What it cannot make was refused, or accepted, with the order.
            despite_errors: true,
            port,
            wire,
            repeat,
            how,
            simulated_as: self.simulated_as.clone(),
            answers: Answers::default(),
            accept_settings,
            record: None,
        };
        let task = Task::open(self.app, request, self.shared)?;
        let (planned, wanted) = (&task.setup.machine.profile, &self.machine.profile);
        if planned.id != wanted.id {
            let (name, planned, wanted) = (task.file.clone(), planned.id.clone(), wanted.id.clone());
            return Err(PlanningError::OtherMachine { name, planned, wanted }.into());
        }
        if planned.driver != wanted.driver || task.setup.signs != self.signs {
            return Err(OperatorError::ProfileChanged { machine: wanted.id.clone() }.into());
        }
        Ok(task)
    }

    /// Whether a wire begins with homing: not where the machine was just homed.
    fn homes_first(&self) -> bool {
        !self.at_reference && self.connection.as_ref().is_some_and(Connection::can_home)
    }

    fn tell_run(&mut self, task: &Task, wire: usize, mut response: RunResponse) {
        if let Some(connection) = &mut self.connection {
            response.notes.append(&mut connection.observer.warnings);
        }
        let last = response.wires.last();
        if let Some(problem) = last.and_then(|made| made.problem.clone()) {
            let may_move = last.is_some_and(|made| made.standstill == Some(Standstill::NotConfirmed));
            self.power_told = may_move;
            self.shared.problem(if may_move { with_power(problem) } else { problem });
        }
        // A wire whose journal is damaged is given up without being one of them.
        if !response.wires.is_empty() || task.request.how == RunHow::Abandon {
            self.shared.hear(&OperatorEvent::RunEnded(Box::new(response)));
        }
        self.look_for_unfinished(task, wire);
    }

    fn look_for_unfinished(&self, task: &Task, wire: usize) {
        let unfinished = Unfinished::of_wire(task, wire);
        self.shared.change(|state| state.unfinished = unfinished);
    }
}
