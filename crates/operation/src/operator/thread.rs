//! The operator's thread: it owns the connection and executes orders.

use std::time::{Duration, Instant};

use wirebend_driver_host::{
    ActorClient, Next, OrderName, Permit, PermitKind, Phase, Snapshot, Standstill, StopLine, StopOutcome,
};
use wirebend_error::{ErrorRemedy, ProblemReport};
use wirebend_profile::{MachineProfile, Resolved};

use super::ConnectRequest;
use super::armed::ArmedWire;
use super::jog_permit::JogPermit;
use super::question::QuestionKind;
use super::shared::Shared;
use super::shared_state::Ordered;
use super::unfinished::Unfinished;
use crate::error::OperatorError;
use crate::live::{At, Connection, HEAD_QUESTION, Unnamed, await_standstill, connect, refused};
use crate::order::{Answer, Order};
use crate::{LiveProblem, OperationError};
use wirebend_planning::job::SimulatedAs;
use wirebend_planning::signs::Signs;
use wirebend_planning::{Input, Installation};

/// Between two looks at a machine without an order. A controller of the kit that waits for its next
/// line is content with less, and a driver that computes its machine as fast as it can does not keep a core busy.
const IDLE: Duration = Duration::from_millis(250);
/// What a person has to know of a machine whose driver is lost, besides why.
const NOT_CONFIRMED: &str = "the machine has not confirmed that it stands";
/// How long a machine that was stopped is waited for when the connection is to end.
const CLOSING: Duration = Duration::from_secs(2);

pub(super) struct OperatorThread<'a> {
    pub app: &'a Installation,
    pub shared: &'a Shared,
    pub machine: Resolved<MachineProfile>,
    pub signs: Signs,
    /// The port that was named.
    pub named: Option<String>,
    pub simulated_as: SimulatedAs,
    pub connection: Option<Connection<'a>>,
    /// Keeps a board from being reset between two connections.
    pub line: Option<StopLine>,
    pub jog_permit: Option<JogPermit>,
    pub armed: Option<ArmedWire<'a>>,
    /// Both axes stand where homing has left them.
    pub at_reference: bool,
    /// What to do with a machine that has not confirmed that it stands was shown with the wire.
    pub power_told: bool,
}

/// Says that the thread has ended, however it did.
struct Ending<'a> {
    shared: &'a Shared,
    phase: Phase,
}

impl Drop for Ending<'_> {
    fn drop(&mut self) {
        self.shared.end(self.phase);
    }
}

/// Connects, and does what is ordered until the end.
pub(super) fn run(app: &Installation, shared: &Shared, request: &ConnectRequest) {
    let mut ending = Ending { shared, phase: Phase::Failed };
    let machine = app.library.machine(&request.machine).map_err(OperationError::from);
    let known = machine.and_then(|machine| {
        let signs = Signs::of(&machine.figures()?);
        Ok((machine, signs))
    });
    let (machine, signs) = match known {
        Ok(known) => known,
        Err(error) => return shared.problem(ProblemReport::from(&error)),
    };
    let mut thread = OperatorThread {
        app,
        shared,
        machine,
        signs,
        named: request.port.clone(),
        simulated_as: request.simulated_as.clone(),
        connection: None,
        line: None,
        jog_permit: None,
        armed: None,
        at_reference: false,
        power_told: false,
    };
    shared.know(signs);
    shared.catch_up();
    let connected = thread.connect();
    thread.conclude(connected);
    shared.actor.run(IDLE, &mut thread);
    ending.phase = Phase::Closed;
}

impl ActorClient<Ordered> for OperatorThread<'_> {
    fn execute(&mut self, Ordered { order, job }: Ordered) -> Next {
        if matches!(order, Order::Disconnect) {
            return Next::End;
        }
        let done = self.carry_out(&order, job);
        self.conclude(done);
        Next::Continue
    }

    fn look(&mut self) {
        let looked = self.look_at_rest();
        if looked.is_err() || self.shared.actor.stop_is_out() {
            self.conclude(looked);
        }
    }

    fn tell(&mut self) {
        self.shared.catch_up();
    }
}

/// What failed, for a machine that has not confirmed that it stands.
pub(super) fn with_power(ProblemReport { code, message, mut remedies }: ProblemReport) -> ProblemReport {
    remedies.insert(0, ErrorRemedy::CutPower);
    ProblemReport { code, message: format!("{message}; {NOT_CONFIRMED}"), remedies }
}

/// Whether what happened to a wire could not be written down.
const fn is_unrecorded(error: &OperationError) -> bool {
    matches!(error, OperationError::Live(LiveProblem::Unrecorded { .. }))
}

/// Whether what failed says that the machine is not as it was taken to be.
const fn is_of_machine(error: &OperationError) -> bool {
    use LiveProblem::{Fault, Held, Job, NoAnswer, Session, Stopped, Unstopped};
    matches!(
        error,
        OperationError::Live(
            Stopped { .. }
                | Held { .. }
                | Unstopped { .. }
                | Fault(_)
                | Session(_)
                | Job(_)
                | NoAnswer { .. }
        )
    )
}

impl<'a> OperatorThread<'a> {
    fn connect(&mut self) -> Result<(), OperationError> {
        let at = At {
            profile: &self.machine.profile,
            signs: self.signs,
            port: self.named.as_deref(),
            unnamed: Unnamed::Simulate,
            reattached: None,
            axes_at_zero: false,
        };
        let connected = connect(self.app, &at, self.shared);
        if let (Err(_), Some(port)) = (&connected, &self.named) {
            // A machine that still is in a wire may refuse a connection without that.
            let unfinished = Unfinished::last_on(self.app, &self.machine.profile.id, port);
            self.shared.change_untold(|state| state.unfinished = unfinished);
        }
        self.is_connected(connected?);
        Ok(())
    }

    /// Takes a connection over, and reports it.
    pub fn is_connected(&mut self, connection: Connection<'a>) {
        let unfinished = Unfinished::last_on(self.app, &self.machine.profile.id, &connection.port);
        self.shared.change_untold(|state| {
            state.port = Some(connection.port.clone());
            state.driver = Some(connection.driver_id.clone());
            state.cutter_mm = connection.cutter_mm();
            state.unfinished = unfinished;
        });
        // What it says of itself it may have known before it was turned by hand.
        self.at_reference = false;
        self.line.clone_from(&connection.line);
        self.connection = Some(connection);
    }

    fn carry_out(&mut self, order: &Order, job: Option<Input>) -> Result<(), OperationError> {
        let of_job = || job.ok_or(OperatorError::NoJob { order: order.name() });
        match order {
            Order::Home => self.home(),
            Order::Jog { moves, record } => self.jog(moves, *record),
            Order::Replay { file, other_machine } => self.replay(file.as_deref(), *other_machine),
            &Order::Arm { wire, repeat, accept_settings, .. } => {
                self.arm(of_job()?, wire, repeat, accept_settings)
            }
            &Order::DryRun { wire, accept_settings, .. } => self.dry_run(of_job()?, wire, accept_settings),
            Order::Disarm => {
                self.armed = None;
                Ok(())
            }
            Order::Start => self.start(),
            &Order::ResumeRun { wire, decided, accept_settings, .. } => {
                self.resume_run(of_job()?, wire, decided, accept_settings)
            }
            &Order::Abandon { wire, .. } => self.abandon(of_job()?, wire),
            Order::WriteSettings => self.write_settings(),
            Order::Console { line } => self.console(line),
            // These do not come to this thread as orders.
            Order::Pause | Order::Resume | Order::Speed { .. } | Order::Disconnect => Ok(()),
        }
    }

    /// Looks at a machine of which nothing was ordered.
    fn look_at_rest(&mut self) -> Result<(), OperationError> {
        match &mut self.connection {
            // What has failed is not asked again.
            Some(connection) if connection.session.phase() != Phase::Failed => Ok(connection.look_at_rest()?),
            _ => Ok(()),
        }
    }

    /// What becomes of the machine after an order, or after something that was not ordered.
    fn conclude(&mut self, done: Result<(), OperationError>) {
        let stop = self.shared.tell_stop();
        let standstill = self.come_to_rest(stop.is_some() || done.as_ref().is_err_and(is_of_machine));
        // The message of these says what to do already.
        let advised = std::mem::take(&mut self.power_told)
            || stop.is_some_and(|stop| stop.driver_ended)
            || matches!(done, Err(OperationError::Live(LiveProblem::Unstopped { .. })));
        let problem = match (stop, done) {
            (Some(StopOutcome { driver_ended: true, by, .. }), _) => {
                Some(ProblemReport::from(&OperationError::from(OperatorError::DriverEnded { by })))
            }
            // What a wire cannot be recorded by is no doing of a stop.
            (Some(_), Err(error)) if is_unrecorded(&error) => Some(ProblemReport::from(&error)),
            // What failed while a stop was on its way is its doing.
            (Some(_), Err(_)) if self.connection.is_some() => None,
            // A person has said it.
            (_, Ok(()) | Err(OperationError::Live(LiveProblem::Declined))) => None,
            (_, Err(error)) => Some(ProblemReport::from(&error)),
        };
        let problem = match problem {
            problem if standstill != Some(Standstill::NotConfirmed) || advised => problem,
            None => Some(ProblemReport::from(&LiveProblem::MayMove { during: "it was connected" })),
            Some(problem) => Some(with_power(problem)),
        };
        match problem {
            Some(problem) => {
                self.jog_permit = None;
                self.shared.problem(problem);
            }
            None if self.is_out_of_order() => self.shared.is_as_before(),
            None => {}
        }
        let snapshot = self.snapshot();
        let wire = self.armed.as_ref().map(ArmedWire::state);
        let settings = self.connection.as_ref().map(|connection| connection.observer.settings.clone());
        self.shared.rest(snapshot.as_ref(), |state| {
            state.wire = wire.or_else(|| state.wire.take());
            if let Some(settings) = settings {
                state.settings = settings.into_iter().filter(|one| one.machine != one.expected).collect();
            }
        });
    }

    /// After a stop or a failure nothing that was said before holds any more. What came of a stop since the machine was at
    /// rest last.
    fn come_to_rest(&mut self, upset: bool) -> Option<Standstill> {
        let shared = self.shared;
        let standstill = self.connection.as_mut().and_then(|connection| {
            if connection.session.standstill() == Some(Standstill::Awaited) {
                shared.enter(Phase::Stopping);
            }
            let begun = Instant::now();
            let unwanted = || shared.actor.is_closing() && begun.elapsed() > CLOSING;
            await_standstill(&mut connection.session, &mut connection.observer, unwanted)
        });
        let stop = self.connection.as_mut().and_then(|connection| connection.session.take_stop());
        let lost = self.phase() == Phase::Failed;
        if upset || lost || stop.is_some() {
            (self.jog_permit, self.armed, self.at_reference) = (None, None, false);
        }
        standstill
    }

    /// How a machine stands of which nothing is ordered; `None` where none is connected.
    fn snapshot(&self) -> Option<Snapshot> {
        Some(self.connection.as_ref()?.session.snapshot_at_rest())
    }

    fn phase(&self) -> Phase {
        self.snapshot().map_or(Phase::Failed, |snapshot| snapshot.phase)
    }

    /// The machine, if one is connected.
    pub fn connected(&mut self, order: OrderName) -> Result<&mut Connection<'a>, OperatorError> {
        let phase = self.phase();
        self.connection.as_mut().ok_or(OperatorError::NotNow { order, phase })
    }

    /// Whether it can only be used again by connecting it anew.
    pub fn is_out_of_order(&self) -> bool {
        self.phase() == Phase::Failed
    }

    /// Whether the machine is left in the middle of a wire.
    pub fn is_in_a_wire(&self) -> bool {
        self.connection.as_ref().is_some_and(|connection| connection.session.phase().is_in_a_wire())
    }

    /// Asks a person, and watches the machine meanwhile.
    pub fn ask(
        &mut self,
        kind: QuestionKind,
        permit: PermitKind,
        lines: Vec<String>,
        question: &str,
    ) -> Result<Permit, OperationError> {
        let connection = self.connection.as_mut().ok_or(OperatorError::NotConnected)?;
        let request = connection.session.ask(permit);
        self.shared.ask(kind, Some(lines.clone()), question, None);
        if self.answer()? != Answer::Yes {
            return Err(LiveProblem::Declined.into());
        }
        // The next question shows them again where it has no lines of its own.
        self.shared.about(lines);
        let session = &mut self.connection.as_mut().ok_or(OperatorError::NotConnected)?.session;
        let permit = session.permit(request.confirm());
        Ok(permit.map_err(|error| refused(session, error, "a person was asked about it"))?)
    }

    /// Where it is not known where the head stands and the machine does not find it, the user says it before homing,
    /// which turns it back.
    pub fn settle_head(&mut self, order: OrderName, homes: bool) -> Result<(), OperationError> {
        let connection = self.connected(order)?;
        if !homes && connection.can_home() {
            return Ok(());
        }
        if let Some(question) = connection.head_question() {
            self.shared.ask_for_head(question, HEAD_QUESTION);
            match self.answer()? {
                Answer::Head(deg) => self.connected(order)?.head_said(deg)?,
                _ => return Err(LiveProblem::Declined.into()),
            }
        }
        Ok(self.connected(order)?.require_head_unturned()?)
    }

    /// The answer to the open question.
    fn answer(&mut self) -> Result<Answer, OperationError> {
        loop {
            if let Some(answer) = self.shared.answered(Some(IDLE)) {
                return Ok(answer);
            }
            if let Err(error) = self.look_at_rest() {
                self.shared.close_question();
                return Err(error);
            }
        }
    }
}
