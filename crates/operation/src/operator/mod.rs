//! The operator: a machine that stays connected, for a front end with buttons.
//!
//! A board starts anew when its port is opened, so one that is moved jog by jog keeps its connection.
//! [`Operator::connect`] begins a thread that holds it; [`Operator::order`] says what to do and returns at once, and
//! the result is reported to an [`OperatorListener`]. What moves a machine asks a person first, by an
//! [`OperatorEvent::Question`]; [`Operator::stop`] works at any time. Wires are bent by the same loop as those of
//! `run`, with the same journals: what one has begun the other can resume.

mod armed;
mod console;
mod event;
mod front_end;
mod hand;
mod hand_wire;
mod jog_permit;
mod question;
mod settings;
mod shared;
mod shared_state;
mod state;
mod thread;
mod unfinished;
mod wire;

use std::path::PathBuf;
use std::sync::Arc;
use std::thread::{Builder, JoinHandle};
use std::time::Duration;

use schemars::JsonSchema;
use serde::Deserialize;

use crate::by_hand::{MovesFile, WireByHand, profile_hash};
use crate::order::{Answer, Move, Order};
use crate::{OperationError, OperatorError, Phase};
pub use event::{OperatorEvent, OperatorListener};
pub use question::{HeadAsked, Question, QuestionKind};
use shared::Shared;
pub use state::{MachineState, WireState};
pub use unfinished::Unfinished;
use wirebend_error::ProblemReport;
use wirebend_planning::Input;
use wirebend_planning::Installation;
use wirebend_planning::job::SimulatedAs;
use wirebend_planning::output::Output;
use wirebend_planning::text::shown;

/// How long the end of a connection is waited for. A driver that does not end is ended within a part of this.
const ENDING: Duration = Duration::from_secs(10);

/// Which machine, and where.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ConnectRequest {
    pub machine: String,
    /// Where it is; absent, the machine that its driver simulates is taken, if it has one.
    #[serde(default)]
    pub port: Option<String>,
    /// What a simulated machine bends, and with what head; refused with the first wire of a real one.
    #[serde(default)]
    pub simulated_as: SimulatedAs,
}

impl ConnectRequest {
    /// The machine that the driver of this one simulates.
    #[must_use]
    pub fn simulated(machine: &str) -> Self {
        Self { machine: machine.to_owned(), port: None, simulated_as: SimulatedAs::default() }
    }
}

/// A machine that stays connected. Dropping it stops what moves, and closes the port.
pub struct Operator {
    app: Arc<Installation>,
    machine: String,
    shared: Arc<Shared>,
    thread: Option<JoinHandle<()>>,
}

impl std::fmt::Debug for Operator {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Operator").field("machine", &self.machine).finish_non_exhaustive()
    }
}

impl Operator {
    /// Begins to connect a machine, and returns at once. Nothing moves for it; the result is reported.
    #[must_use]
    pub fn connect(
        app: Arc<Installation>,
        request: ConnectRequest,
        listener: Arc<dyn OperatorListener>,
    ) -> Self {
        let state = MachineState::connecting(request.clone());
        let shared = Arc::new(Shared::new(state, listener));
        let machine = request.machine.clone();
        let (of_thread, at) = (Arc::clone(&app), Arc::clone(&shared));
        let thread = Builder::new()
            .name("operator".to_owned())
            .spawn(move || shown(|| thread::run(&of_thread, &at, &request)))
            .inspect_err(|error| {
                let error = OperationError::from(OperatorError::NoThread { cause: error.to_string() });
                shared.problem(ProblemReport::from(&error));
                shared.end(Phase::Failed);
            })
            .ok();
        Self { app, machine, shared, thread }
    }

    /// Gives an order. It returns at once; the result is reported.
    ///
    /// # Errors
    /// [`OperatorError`] where it is not possible now: [`MachineState::can`] has what does.
    pub fn order(&self, order: Order) -> Result<(), OperationError> {
        Ok(self.shared.order(order, None)?)
    }

    /// The same of a wire of a job.
    ///
    /// # Errors
    /// As [`Operator::order`].
    pub fn order_wire(&self, order: Order, job: Input) -> Result<(), OperationError> {
        Ok(self.shared.order(order, Some(job))?)
    }

    /// Answers the open question.
    ///
    /// # Errors
    /// [`OperatorError::NoQuestion`] when it is not open any more, [`OperatorError::WrongAnswer`].
    pub fn answer(&self, question: u64, answer: Answer) -> Result<(), OperationError> {
        Ok(self.shared.answer(question, answer)?)
    }

    /// Stops the machine now, whatever it does, from any thread; one that is being connected as soon as it can be
    /// stopped. The open question is answered with no, and nothing that was said before holds any more. When this
    /// returns the stop is out. Whether there was, or will be, a machine to stop.
    #[allow(clippy::must_use_candidate)] // a caller that stops a machine does not look at the answer
    pub fn stop(&self) -> bool {
        self.shared.stop()
    }

    #[must_use]
    pub fn state(&self) -> MachineState {
        self.shared.state()
    }

    /// The wire that moves by hand have bent since the machine was homed or connected, as far as it is by now.
    #[must_use]
    pub fn by_hand(&self) -> WireByHand {
        self.shared.by_hand()
    }

    /// The moves that were recorded, in the order in which they ran.
    #[must_use]
    pub fn recorded(&self) -> Vec<Move> {
        self.shared.recorded()
    }

    /// Forgets the moves that were recorded.
    pub fn clear_recording(&self) {
        self.shared.clear_recording();
    }

    /// Writes the moves that were recorded as a file to be replayed.
    ///
    /// # Errors
    /// [`OperatorError::NothingRecorded`]; [`OperationError`] when the file is there or cannot be written.
    pub fn save_recording(&self, output: &Output) -> Result<PathBuf, OperationError> {
        let moves = self.shared.recorded();
        if moves.is_empty() {
            return Err(OperatorError::NothingRecorded.into());
        }
        let machine = self.app.library.machine(&self.machine)?;
        Ok(output.save(&MovesFile::new(&machine, moves)?.to_bytes()?)?)
    }

    /// Refuses a machine whose profile has been changed since it was connected.
    ///
    /// # Errors
    /// [`OperatorError::ConnectedBefore`]; [`OperationError`] when there is no such profile any more.
    pub fn require_as_in(&self, app: &Installation) -> Result<(), OperationError> {
        let hash = |app: &Installation| profile_hash(&app.library.machine(&self.machine)?);
        if std::ptr::eq(app, &raw const *self.app) || hash(app)? == hash(&self.app)? {
            return Ok(());
        }
        Err(OperatorError::ConnectedBefore { machine: self.machine.clone() }.into())
    }

    /// What dropping it does, whatever else still has it.
    pub fn close(&self) {
        self.shared.close();
        if !self.shared.actor.ended_within(ENDING) {
            tracing::warn!("the connection to '{}' does not end", self.machine);
        }
    }
}

impl Drop for Operator {
    fn drop(&mut self) {
        // A listener that lets go of the operator cannot wait for itself.
        if self.thread.as_ref().is_none_or(|thread| thread.thread().id() == std::thread::current().id()) {
            return self.shared.close();
        }
        self.close();
        if self.shared.actor.ended_within(Duration::ZERO)
            && let Some(thread) = self.thread.take()
        {
            // The runtime has reported a listener that has failed.
            let _ = thread.join();
        }
    }
}
