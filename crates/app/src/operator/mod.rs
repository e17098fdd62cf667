//! The operator: a machine that stays connected, for a front end with buttons.
//!
//! A board starts anew when its port is opened, so one that is moved jog by jog keeps its connection.
//! [`Operator::connect`] begins a thread that holds it; [`Operator::order`] says what to do and returns at once, and
//! what comes of it is told to an [`OperatorListener`]. What moves a machine asks a person first, by an
//! [`OperatorEvent::Question`]; [`Operator::stop`] works at any time. Wires are made by the same loop as those of
//! `run`, with the same journals: what one has begun the other can go on with.

mod error;
mod event;
mod hand;
mod kept;
mod leave;
mod order;
mod post;
mod settings;
mod shared;
mod state;
mod telling;
mod unfinished;
mod wire;

use std::path::PathBuf;
use std::sync::Arc;
use std::thread::{Builder, JoinHandle};
use std::time::Duration;

use schemars::JsonSchema;
use serde::Deserialize;

use crate::by_hand::{MovesFile, profile_hash};
use crate::output::Output;
use crate::{App, AppError, Move, RunProblem};
pub use error::OperatorError;
pub use event::{HeadAsked, OperatorEvent, OperatorListener, Question, QuestionKind};
pub use order::{Answer, Order, OrderName};
use shared::Shared;
pub use state::{MachineState, Phase, WireState};
pub use unfinished::Unfinished;

/// How long the end of a connection is waited for. A driver that does not end is ended within a part of this.
const ENDING: Duration = Duration::from_secs(10);

/// Which machine, and where.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ConnectRequest {
    /// The machine.
    pub machine: String,
    /// Where it is; absent, the machine that its driver simulates is taken, if it has one.
    #[serde(default)]
    pub port: Option<String>,
}

/// A machine that stays connected. Dropping it stops what moves, and closes the port.
pub struct Operator {
    app: Arc<App>,
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
    /// Begins to connect a machine, and returns at once. Nothing moves for it; what comes of it is told.
    #[must_use]
    pub fn connect(app: Arc<App>, request: ConnectRequest, listener: Arc<dyn OperatorListener>) -> Self {
        let state = MachineState::connecting(request.machine.clone(), request.port.clone());
        let shared = Arc::new(Shared::new(state, listener));
        let machine = request.machine.clone();
        let (of_thread, at) = (Arc::clone(&app), Arc::clone(&shared));
        let thread = Builder::new()
            .name("operator".to_owned())
            .spawn(move || post::stand(&of_thread, &at, &request))
            .inspect_err(|error| {
                let error = AppError::from(OperatorError::NoThread { cause: error.to_string() });
                shared.problem(RunProblem::from(&error));
                shared.end(Phase::Failed);
            })
            .ok();
        Self { app, machine, shared, thread }
    }

    /// Says what to do. It returns at once; what comes of it is told.
    ///
    /// # Errors
    /// [`OperatorError`] where it makes no sense now: [`MachineState::can`] has what does.
    pub fn order(&self, order: Order) -> Result<(), AppError> {
        Ok(self.shared.order(order)?)
    }

    /// Answers the open question.
    ///
    /// # Errors
    /// [`OperatorError::NoQuestion`] when it is not open any more, [`OperatorError::WrongAnswer`].
    pub fn answer(&self, question: u64, answer: Answer) -> Result<(), AppError> {
        Ok(self.shared.answer(question, answer)?)
    }

    /// Stops the machine now, whatever it does, from any thread; one that is being connected as soon as it can be
    /// stopped. The open question is answered with no, and nothing that was said before holds any more. When this
    /// returns the stop is out. Whether there was, or will be, a machine to stop.
    #[allow(clippy::must_use_candidate)] // whoever stops a machine does not look at the answer
    pub fn stop(&self) -> bool {
        self.shared.stop()
    }

    /// How everything stands.
    #[must_use]
    pub fn state(&self) -> MachineState {
        self.shared.state()
    }

    /// The moves that were recorded, in the order in which they were made.
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
    /// [`OperatorError::NothingRecorded`]; [`AppError`] when the file is there or cannot be written.
    pub fn save_recording(&self, output: &Output) -> Result<PathBuf, AppError> {
        let moves = self.shared.recorded();
        if moves.is_empty() {
            return Err(OperatorError::NothingRecorded.into());
        }
        let machine = self.app.library.machine(&self.machine)?;
        output.save(&MovesFile::new(&machine, moves)?.to_bytes()?)
    }

    /// Refuses a machine whose profile has been changed since it was connected.
    ///
    /// # Errors
    /// [`OperatorError::ConnectedBefore`]; [`AppError`] when there is no such profile any more.
    pub(crate) fn require_as_in(&self, app: &App) -> Result<(), AppError> {
        let hash = |app: &App| profile_hash(&app.library.machine(&self.machine)?);
        if std::ptr::eq(app, &raw const *self.app) || hash(app)? == hash(&self.app)? {
            return Ok(());
        }
        Err(OperatorError::ConnectedBefore { machine: self.machine.clone() }.into())
    }

    /// What dropping it does, whoever else still has it.
    pub(crate) fn close(&self) {
        self.shared.close();
        if !self.shared.ended_within(ENDING) {
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
        if self.shared.ended_within(Duration::ZERO)
            && let Some(thread) = self.thread.take()
        {
            // A listener that has failed has been told of by the runtime.
            let _ = thread.join();
        }
    }
}
