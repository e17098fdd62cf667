//! Where the operator stands: the thread that holds the connection and does what is ordered.

use std::time::{Duration, Instant};

use wirebend_driver_host::{Standstill, State, StopLine, StopOutcome};
use wirebend_profile::{MachineProfile, Resolved};

use super::ConnectRequest;
use super::error::OperatorError;
use super::event::QuestionKind;
use super::leave::Leave;
use super::order::{Answer, Order, OrderName};
use super::shared::{Next, Shared};
use super::state::Phase;
use super::unfinished::Unfinished;
use super::wire::ArmedWire;
use crate::drivers::Signs;
use crate::live::{At, Connection, HEAD_QUESTION, Unnamed, Yes, await_standstill};
use crate::{App, AppError, LiveProblem, RunProblem};

/// Between two looks at a machine that nobody has ordered anything of. A controller of the kit that waits for its next
/// line is content with less, and a driver that computes its machine as fast as it can does not keep a core busy.
const IDLE: Duration = Duration::from_millis(250);
/// What a person has to know of a machine whose driver is lost, besides why.
const CUT_ITS_POWER: &str = "the machine has not confirmed that it stands: cut its power";
/// How long a machine that was stopped is waited for when the connection is to end.
const CLOSING: Duration = Duration::from_secs(2);

/// The operator's thread.
pub(super) struct Post<'a> {
    pub app: &'a App,
    pub shared: &'a Shared,
    pub machine: Resolved<MachineProfile>,
    pub signs: Signs,
    /// The port that was named.
    pub named: Option<String>,
    pub connection: Option<Connection<'a>>,
    /// Keeps a board from being reset between two connections.
    pub line: Option<StopLine>,
    pub leave: Option<Leave>,
    pub armed: Option<ArmedWire<'a>>,
    /// Both axes stand where the search for the reference has left them.
    pub at_reference: bool,
    /// What to do with a machine that has not confirmed that it stands was told with the wire.
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
pub(super) fn stand(app: &App, shared: &Shared, request: &ConnectRequest) {
    let mut ending = Ending { shared, phase: Phase::Failed };
    let machine = app.library.machine(&request.machine).map_err(AppError::from);
    let known = machine.and_then(|machine| {
        let signs = Signs::of(&machine.figures()?);
        Ok((machine, signs))
    });
    let (machine, signs) = match known {
        Ok(known) => known,
        Err(error) => return shared.problem(RunProblem::from(&error)),
    };
    let mut post = Post {
        app,
        shared,
        machine,
        signs,
        named: request.port.clone(),
        connection: None,
        line: None,
        leave: None,
        armed: None,
        at_reference: false,
        power_told: false,
    };
    shared.catch_up();
    let connected = post.connect();
    post.conclude(connected);
    ending.phase = Phase::Closed;
    loop {
        match shared.next(IDLE) {
            Next::Close | Next::Order(Order::Disconnect) => return,
            Next::Look => post.tend(),
            Next::Order(order) => {
                let done = post.obey(order);
                post.conclude(done);
            }
        }
    }
}

/// What failed, for a machine that has not confirmed that it stands.
pub(super) fn with_power(RunProblem { code, message }: RunProblem) -> RunProblem {
    RunProblem { code, message: format!("{message}; {CUT_ITS_POWER}") }
}

/// Whether what failed says that the machine is not as it was taken to be.
const fn is_of_machine(error: &AppError) -> bool {
    use LiveProblem::{Fault, Held, Job, NoAnswer, Session, Stopped, Unstopped};
    matches!(
        error,
        AppError::Live(
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

impl<'a> Post<'a> {
    fn connect(&mut self) -> Result<(), AppError> {
        let at = At {
            profile: &self.machine.profile,
            signs: self.signs,
            port: self.named.as_deref(),
            unnamed: Unnamed::Simulate,
            token: None,
            journal: None,
            axes_at_zero: false,
        };
        let connected = self.app.connect(&at, self.shared);
        if let (Err(_), Some(port)) = (&connected, &self.named) {
            // A machine that still is in a wire may take nobody in without that.
            let unfinished = Unfinished::last_on(self.app, &self.machine.profile.id, port);
            self.shared.change_untold(|state| state.unfinished = unfinished);
        }
        self.is_connected(connected?);
        Ok(())
    }

    /// Takes a connection over, and tells of it.
    pub fn is_connected(&mut self, connection: Connection<'a>) {
        let driver = connection.session.driver();
        // A driver that does not tell where it simulates is taken to move something.
        let simulated = connection.unnamed
            || driver
                .ports()
                .is_ok_and(|ports| ports.iter().any(|port| port.simulated && port.name == connection.port));
        let abilities = driver.description().capabilities.clone();
        let unfinished = Unfinished::last_on(self.app, &self.machine.profile.id, &connection.port);
        self.shared.know(abilities, connection.reference());
        self.shared.change_untold(|state| {
            state.port = Some(connection.port.clone());
            state.simulated = simulated;
            state.identity = Some(connection.session.identity().to_owned());
            state.driver = Some(connection.driver_id.clone());
            state.unfinished = unfinished;
        });
        // What it says of itself it may have known before somebody has turned it by hand.
        self.at_reference = false;
        self.line.clone_from(&connection.line);
        self.connection = Some(connection);
    }

    fn obey(&mut self, order: Order) -> Result<(), AppError> {
        match order {
            Order::Home => self.home(),
            Order::Jog { moves, record } => self.jog(&moves, record),
            Order::Replay { file, other_machine } => self.replay(&file, other_machine),
            Order::Arm { job, wire, accept_settings } => self.arm(job, wire, accept_settings),
            Order::Disarm => {
                self.armed = None;
                Ok(())
            }
            Order::Start => self.start(),
            Order::ResumeRun { job, wire, decided, accept_settings } => {
                self.resume_run(job, wire, decided, accept_settings)
            }
            Order::Abandon { job, wire } => self.abandon(job, wire),
            Order::WriteSettings => self.write_settings(),
            // These do not come to this thread as orders.
            Order::Pause | Order::Resume | Order::Disconnect => Ok(()),
        }
    }

    /// Looks at a machine of which nothing was ordered.
    fn tend(&mut self) {
        let looked = self.look();
        if looked.is_err() || self.shared.stop_is_out() {
            self.conclude(looked);
        }
    }

    fn look(&mut self) -> Result<(), AppError> {
        match &mut self.connection {
            // What has failed is not asked again.
            Some(connection) if connection.session.state() != State::Faulted => {
                Ok(connection.look_at_rest()?)
            }
            _ => Ok(()),
        }
    }

    /// What becomes of the machine after an order, or after something that nobody has ordered.
    fn conclude(&mut self, done: Result<(), AppError>) {
        let stop = self.shared.tell_stop();
        let standstill = self.come_to_rest(stop.is_some() || done.as_ref().is_err_and(is_of_machine));
        // What was told of these says what to do already.
        let advised = std::mem::take(&mut self.power_told)
            || stop.is_some_and(|stop| stop.driver_ended)
            || matches!(done, Err(AppError::Live(LiveProblem::Unstopped { .. })));
        let problem = match (stop, done) {
            (Some(StopOutcome { driver_ended: true, by, .. }), _) => {
                Some(RunProblem::from(&AppError::from(OperatorError::DriverEnded { by })))
            }
            // What failed while a stop was on its way is its doing.
            (Some(_), Err(_)) if self.connection.is_some() => None,
            // A person has said it.
            (_, Ok(()) | Err(AppError::Live(LiveProblem::Declined))) => None,
            (_, Err(error)) => Some(RunProblem::from(&error)),
        };
        let problem = match problem {
            problem if standstill != Some(Standstill::NotConfirmed) || advised => problem,
            None => Some(RunProblem::from(&LiveProblem::MayMove { during: "it was connected" })),
            Some(problem) => Some(with_power(problem)),
        };
        if let Some(problem) = problem {
            self.leave = None;
            self.shared.problem(problem);
        }
        let phase = self.phase();
        let wire = self.armed.as_ref().map(ArmedWire::state);
        let settings = self.connection.as_ref().map(|connection| connection.hearing.settings.clone());
        self.shared.rest(|state| {
            state.phase = phase;
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
                shared.change(|state| state.phase = Phase::Stopping);
            }
            let begun = Instant::now();
            let unwanted = || shared.is_closing() && begun.elapsed() > CLOSING;
            await_standstill(&mut connection.session, &mut connection.hearing, unwanted)
        });
        let stop = self.connection.as_mut().and_then(|connection| connection.session.take_stop());
        let lost = self.phase() == Phase::Failed;
        if upset || lost || stop.is_some() {
            (self.leave, self.armed, self.at_reference) = (None, None, false);
        }
        standstill
    }

    fn phase(&self) -> Phase {
        let Some(connection) = &self.connection else { return Phase::Failed };
        match connection.session.state() {
            State::Connected | State::Homed | State::Armed | State::Done | State::Stopped
                if self.armed.is_some() =>
            {
                Phase::Armed
            }
            State::Connected => Phase::Connected,
            State::Homed | State::Armed | State::Done => Phase::Ready,
            State::Stopped => Phase::Stopped,
            // A wire that is not gone on with is not held on to.
            State::Disconnected
            | State::Interrupted
            | State::Running
            | State::Paused
            | State::Stopping
            | State::Faulted => Phase::Failed,
        }
    }

    /// The machine, if one is connected.
    pub fn connected(&mut self, order: OrderName) -> Result<&mut Connection<'a>, OperatorError> {
        let phase = self.phase();
        self.connection.as_mut().ok_or(OperatorError::NotNow { order, phase })
    }

    /// Whether it can only be gone on with by connecting it anew.
    pub fn is_out_of_order(&self) -> bool {
        self.phase() == Phase::Failed
    }

    /// Whether the machine is left in the middle of a wire.
    pub fn is_in_a_wire(&self) -> bool {
        self.connection.as_ref().is_some_and(|connection| {
            matches!(connection.session.state(), State::Interrupted | State::Running | State::Paused)
        })
    }

    pub fn is_simulated(&self) -> bool {
        self.shared.state().simulated
    }

    /// Asks a person, and watches the machine meanwhile.
    pub fn ask(&mut self, kind: QuestionKind, lines: Vec<String>, question: &str) -> Result<Yes, AppError> {
        self.shared.ask(kind, Some(lines.clone()), question, None);
        if self.answer()? != Answer::Yes {
            return Err(LiveProblem::Declined.into());
        }
        Ok(Yes::ask(self.shared, lines, question, true)?)
    }

    /// Where nobody knows where the head stands and the machine does not find it, a person says it before the search for
    /// the reference, which turns it back.
    pub fn settle_head(&mut self, order: OrderName, homes: bool) -> Result<(), AppError> {
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
    fn answer(&mut self) -> Result<Answer, AppError> {
        loop {
            if let Some(answer) = self.shared.answered(Some(IDLE)) {
                return Ok(answer);
            }
            if let Err(error) = self.look() {
                self.shared.close_question();
                return Err(error);
            }
        }
    }
}
