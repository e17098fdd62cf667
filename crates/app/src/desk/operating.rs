//! The machine that is connected: what a window orders, and what it is asked.

use std::path::PathBuf;
use std::sync::{Arc, PoisonError};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_files::document::{Job, save_atomically};

use super::{Desk, Tell};
use crate::output::Output;
use crate::{
    Answer, AppError, ConnectRequest, Decided, Input, MachineState, Move, NoProgress, Operator,
    OperatorError, OperatorEvent, Order, Phase, Progress,
};

/// Connects the machine of the open design. One that was connected before is let go.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ConnectMachine {
    /// Where it is; absent, the machine that its driver simulates is taken, if it has one.
    pub port: Option<String>,
}

/// Says what the connected machine is to do.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct OrderMachine {
    /// What.
    pub request: MachineOrder,
}

/// What a window orders. A stop is none of these: it is always possible.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(tag = "order", rename_all = "kebab-case", deny_unknown_fields)]
pub enum MachineOrder {
    /// The machine searches its reference.
    Home,
    /// Moves by hand.
    Jog {
        /// The moves, in order.
        moves: Vec<Move>,
        /// Whether those that are made are kept for a recording.
        #[serde(default)]
        record: bool,
    },
    /// Plans the open design, checks one of its wires and asks a person; after a yes it can be started.
    Arm {
        /// Index of the wire, from 0.
        wire: usize,
        /// Whether to make it although the machine's settings are not those of its profile.
        #[serde(default)]
        accept_settings: bool,
        /// Whether to make it although a check says that it cannot be made.
        #[serde(default)]
        despite_errors: bool,
    },
    /// What was armed is not started.
    Disarm,
    /// Makes the armed wire.
    Start,
    /// The machine holds in the middle of a wire.
    Pause,
    /// It goes on after a pause.
    Resume,
    /// Goes on with the wire that was interrupted.
    ResumeRun {
        /// Hash of its job.
        job_hash: String,
        /// Index of the wire, from 0.
        wire: usize,
        /// What became of the first step of which nobody knows; absent, a person is asked.
        #[serde(default)]
        decided: Option<Decided>,
        /// Whether to make it although the machine's settings are not those of its profile.
        #[serde(default)]
        accept_settings: bool,
    },
    /// Gives up the wire that was interrupted. Nothing moves for it.
    Abandon {
        /// Hash of its job.
        job_hash: String,
        /// Index of the wire, from 0.
        wire: usize,
    },
    /// Makes recorded moves again.
    Replay {
        /// The recording.
        file: PathBuf,
        /// Whether to make them although they were recorded on another machine, or before its profile was changed.
        #[serde(default)]
        other_machine: bool,
    },
    /// Sets the machine as its profile says, for good. Nothing moves for it, and it has to be homed afterwards.
    WriteSettings,
    /// Closes the port.
    Disconnect,
}

/// Answers what was asked.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct AnswerMachine {
    /// The number of the question.
    pub question: u64,
    /// What is said.
    pub answer: Answer,
}

/// Asks how the machine stands.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct MachineStateRequest {}

/// How the machine stands.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MachineNow {
    /// Its state; null where none was connected.
    pub state: Option<MachineState>,
}

/// Asks for the moves that were recorded.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct RecordedRequest {}

/// Forgets the moves that were recorded.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ClearRecording {}

/// The moves that were recorded.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Recorded {
    /// In the order in which they were made.
    pub moves: Vec<Move>,
}

/// Writes the moves that were recorded.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct SaveRecording {
    /// Where.
    pub output: Output,
}

/// The recording that was written.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct SavedRecording {
    /// Its file.
    pub file: PathBuf,
}

impl MachineOrder {
    /// Whether something moves or is set by it, or is to be.
    const fn moves(&self) -> bool {
        match self {
            Self::Home
            | Self::Jog { .. }
            | Self::Arm { .. }
            | Self::Start
            | Self::ResumeRun { .. }
            | Self::Replay { .. }
            | Self::WriteSettings => true,
            // A wire that was begun goes on as it was begun.
            Self::Disarm | Self::Pause | Self::Resume | Self::Abandon { .. } | Self::Disconnect => false,
        }
    }
}

impl Desk {
    pub(super) fn connect(&self, asked: &ConnectMachine, _: &dyn Progress) -> Result<MachineNow, AppError> {
        let app = self.app();
        let machine = self.open().state().machine;
        let machine = machine.ok_or_else(|| AppError::NoMachine { known: app.machine_ids() })?;
        // The port of the one before has to be free again.
        self.let_go();
        let listener = Arc::clone(&self.listener);
        let hear = move |event: &OperatorEvent| listener.hear(&Tell::Operator(Box::new(event.clone())));
        let request = ConnectRequest { machine, port: asked.port.clone() };
        self.put_operator(Some(Arc::new(Operator::connect(app, request, Arc::new(hear)))));
        Ok(self.now())
    }

    pub(super) fn order(
        &self,
        asked: &OrderMachine,
        progress: &dyn Progress,
    ) -> Result<MachineNow, AppError> {
        let operator = self.operator().ok_or(OperatorError::NotConnected)?;
        if asked.request.moves() && operator.state().phase != Phase::Closed {
            operator.require_as_in(&self.app())?;
        }
        operator.order(self.resolved(&asked.request, progress)?)?;
        Ok(self.now())
    }

    pub(super) fn answer_machine(
        &self,
        asked: &AnswerMachine,
        _: &dyn Progress,
    ) -> Result<MachineNow, AppError> {
        let operator = self.operator().ok_or(OperatorError::NotConnected)?;
        operator.answer(asked.question, asked.answer)?;
        Ok(self.now())
    }

    pub(super) fn machine_state(
        &self,
        _: &MachineStateRequest,
        _: &dyn Progress,
    ) -> Result<MachineNow, AppError> {
        Ok(self.now())
    }

    pub(super) fn recorded(&self, _: &RecordedRequest, _: &dyn Progress) -> Result<Recorded, AppError> {
        Ok(Recorded { moves: self.operator().map(|operator| operator.recorded()).unwrap_or_default() })
    }

    pub(super) fn clear_recording(&self, _: &ClearRecording, _: &dyn Progress) -> Result<Recorded, AppError> {
        if let Some(operator) = self.operator() {
            operator.clear_recording();
        }
        Ok(Recorded { moves: Vec::new() })
    }

    pub(super) fn save_recording(
        &self,
        asked: &SaveRecording,
        _: &dyn Progress,
    ) -> Result<SavedRecording, AppError> {
        let operator = self.operator().ok_or(OperatorError::NotConnected)?;
        Ok(SavedRecording { file: operator.save_recording(&asked.output)? })
    }

    /// Stops the machine, whatever else is going on; from any thread. Nothing where none is connected.
    pub fn stop(&self) {
        if let Some(operator) = self.operator() {
            operator.stop();
        }
    }

    /// Stops what moves and closes the port, and waits for that.
    pub(super) fn let_go(&self) {
        if let Some(operator) = self.put_operator(None) {
            operator.close();
        }
    }

    fn now(&self) -> MachineNow {
        MachineNow { state: self.operator().map(|operator| operator.state()) }
    }

    /// Held for this moment alone, so that a stop waits for nobody.
    fn operator(&self) -> Option<Arc<Operator>> {
        self.operator.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    fn put_operator(&self, operator: Option<Arc<Operator>>) -> Option<Arc<Operator>> {
        std::mem::replace(&mut *self.operator.lock().unwrap_or_else(PoisonError::into_inner), operator)
    }

    /// The order with the job that it is about.
    fn resolved(&self, order: &MachineOrder, progress: &dyn Progress) -> Result<Order, AppError> {
        Ok(match order.clone() {
            MachineOrder::Home => Order::Home,
            MachineOrder::Jog { moves, record } => Order::Jog { moves, record },
            MachineOrder::Arm { wire, accept_settings, despite_errors } => {
                let job = self.job(despite_errors, progress)?;
                self.keep_job(&job)?;
                Order::Arm { job, wire, accept_settings }
            }
            MachineOrder::Disarm => Order::Disarm,
            MachineOrder::Start => Order::Start,
            MachineOrder::Pause => Order::Pause,
            MachineOrder::Resume => Order::Resume,
            MachineOrder::ResumeRun { job_hash, wire, decided, accept_settings } => {
                Order::ResumeRun { job: self.job_of(&job_hash)?, wire, decided, accept_settings }
            }
            MachineOrder::Abandon { job_hash, wire } => Order::Abandon { job: self.job_of(&job_hash)?, wire },
            MachineOrder::Replay { file, other_machine } => {
                Order::Replay { file: Input::File(file), other_machine }
            }
            MachineOrder::WriteSettings => Order::WriteSettings,
            MachineOrder::Disconnect => Order::Disconnect,
        })
    }

    /// Where the jobs are that were armed: the design may be another one when a wire is to be gone on with.
    fn job_file(&self, hash: &str) -> Option<PathBuf> {
        self.places().runs.as_ref().map(|runs| runs.join("jobs").join(format!("{hash}.wbjob")))
    }

    fn keep_job(&self, job: &Input) -> Result<(), AppError> {
        let (name, bytes) = job.load()?;
        let job = Job::open(&bytes, &name)?;
        let Some(file) = self.job_file(job.hash()).filter(|file| !file.is_file()) else { return Ok(()) };
        super::make_folder_of(&file)?;
        Ok(save_atomically(&file, &bytes)?)
    }

    /// A job that was armed before, or that the open design makes.
    fn job_of(&self, hash: &str) -> Result<Input, AppError> {
        let kept = self.job_file(hash).filter(|file| file.is_file());
        if let Some(file) = kept {
            return Ok(Input::File(file));
        }
        let made = self.job(true, &NoProgress)?;
        let (name, bytes) = made.load()?;
        if Job::open(&bytes, &name)?.hash() == hash {
            return Ok(made);
        }
        Err(OperatorError::JobNotKept { hash: hash.to_owned() }.into())
    }
}
