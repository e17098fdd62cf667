//! The machine that is connected: what a window orders, and what it is asked.

use std::path::PathBuf;
use std::sync::{Arc, PoisonError};
use wirebend_planning::PlanningError;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_files::document::{Job, save_atomically};

use super::{WindowEvent, Workspace};
use crate::{
    Answer, ApiError, ConnectRequest, Input, MachineState, Move, NoProgress, Operator, OperatorError,
    OperatorEvent, Order, Phase, Progress,
};
use wirebend_planning::job::SimulatedAs;
use wirebend_planning::output::Output;
use wirebend_planning::playback::PlayedWire;

/// Connects the machine of the open design, or of what is open to be run. One that was connected before is let go.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ConnectMachine {
    /// Where it is; absent, the machine that its driver simulates is taken, if it has one.
    pub port: Option<String>,
    /// What a simulated machine bends, and with what head, to try a calibration; refused with the first wire of a real one.
    #[serde(default)]
    pub simulated_as: SimulatedAs,
}

/// Says what the connected machine is to do.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct OrderMachine {
    pub request: Order,
}

/// Answers what was asked.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct AnswerMachine {
    pub question: u64,
    /// What is said.
    pub answer: Answer,
}

/// Asks how the machine stands.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct MachineStateRequest {}

#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MachineNow {
    /// Its state; null where none was connected.
    pub state: Option<MachineState>,
}

/// Asks for the moves that were recorded.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct RecordedRequest {}

/// Asks for the wire that moves by hand have bent since the machine was homed or connected.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ByHandRequest {}

/// The wire that moves by hand have bent.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ByHandResponse {
    /// How many moves are done.
    pub moves: usize,
    /// The wire at the end of its last step, with what is done of the move that is under way. It is the wire as ordered,
    /// without springback, in a frame of its own.
    pub wire: PlayedWire,
}

/// Forgets the moves that were recorded.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ClearRecording {}

/// The moves that were recorded.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Recorded {
    /// In the order in which they ran.
    pub moves: Vec<Move>,
}

/// Writes the moves that were recorded.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct SaveRecording {
    pub output: Output,
}

/// The recording that was written.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct SavedRecording {
    pub file: PathBuf,
}

impl Workspace {
    pub(crate) fn connect(&self, asked: &ConnectMachine, _: &dyn Progress) -> Result<MachineNow, ApiError> {
        let app = self.installation();
        let of_file = self.run_file().map(|file| file.report.machine.clone());
        let machine = of_file.or_else(|| self.open().state().machine);
        let machine = machine.ok_or_else(|| PlanningError::NoMachine { known: app.machine_ids() })?;
        // The port of the one before has to be free again.
        self.let_go();
        let events = Arc::clone(&self.events);
        let hear = move |event: &OperatorEvent| events.emit(&WindowEvent::Operator(Box::new(event.clone())));
        let request =
            ConnectRequest { machine, port: asked.port.clone(), simulated_as: asked.simulated_as.clone() };
        self.put_operator(Operator::connect(app, request, Arc::new(hear)));
        Ok(self.now())
    }

    pub(crate) fn order(
        &self,
        asked: &OrderMachine,
        progress: &dyn Progress,
    ) -> Result<MachineNow, ApiError> {
        self.require_file_as_read(&asked.request)?;
        let operator = self.operator().ok_or(OperatorError::NotConnected)?;
        if asked.request.moves() && operator.state().phase != Phase::Closed {
            operator.require_as_in(&self.installation())?;
        }
        match self.job_for(&asked.request, progress)? {
            Some(job) => operator.order_wire(asked.request.clone(), job)?,
            None => operator.order(asked.request.clone())?,
        }
        Ok(self.now())
    }

    pub(crate) fn answer_machine(
        &self,
        asked: &AnswerMachine,
        _: &dyn Progress,
    ) -> Result<MachineNow, ApiError> {
        let operator = self.operator().ok_or(OperatorError::NotConnected)?;
        operator.answer(asked.question, asked.answer)?;
        Ok(self.now())
    }

    pub(crate) fn machine_state(
        &self,
        _: &MachineStateRequest,
        _: &dyn Progress,
    ) -> Result<MachineNow, ApiError> {
        Ok(self.now())
    }

    pub(crate) fn recorded(&self, _: &RecordedRequest, _: &dyn Progress) -> Result<Recorded, ApiError> {
        Ok(Recorded { moves: self.operator().map(|operator| operator.recorded()).unwrap_or_default() })
    }

    pub(crate) fn by_hand(&self, _: &ByHandRequest, _: &dyn Progress) -> Result<ByHandResponse, ApiError> {
        let by_hand = self.operator().map(|operator| operator.by_hand()).unwrap_or_default();
        Ok(ByHandResponse { moves: by_hand.moves(), wire: by_hand.played() })
    }

    pub(crate) fn clear_recording(&self, _: &ClearRecording, _: &dyn Progress) -> Result<Recorded, ApiError> {
        if let Some(operator) = self.operator() {
            operator.clear_recording();
        }
        Ok(Recorded { moves: Vec::new() })
    }

    pub(crate) fn save_recording(
        &self,
        asked: &SaveRecording,
        _: &dyn Progress,
    ) -> Result<SavedRecording, ApiError> {
        let operator = self.operator().ok_or(OperatorError::NotConnected)?;
        Ok(SavedRecording { file: operator.save_recording(&asked.output)? })
    }

    /// Stops the machine, whatever else is under way; from any thread. Nothing where none is connected.
    pub fn stop(&self) {
        if let Some(operator) = self.operator() {
            operator.stop();
        }
    }

    /// Stops what moves and closes the port, and waits for that.
    pub(crate) fn let_go(&self) {
        let Some(operator) = self.operator() else { return };
        operator.close();
        // Until then a person may have to stop it.
        let mut kept = self.operator.lock().unwrap_or_else(PoisonError::into_inner);
        kept.take_if(|kept| Arc::ptr_eq(kept, &operator));
    }

    fn now(&self) -> MachineNow {
        MachineNow { state: self.operator().map(|operator| operator.state()) }
    }

    /// Held for this moment alone, so that a stop never has to wait.
    fn operator(&self) -> Option<Arc<Operator>> {
        self.operator.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    fn put_operator(&self, operator: Operator) {
        let mut kept = self.operator.lock().unwrap_or_else(PoisonError::into_inner);
        let before = kept.replace(Arc::new(operator));
        // One that still ends is waited for, and nobody waits for that.
        drop((kept, before));
    }

    /// Refuses an order that begins what is in the file that is open to be run, where that has changed on the disk.
    fn require_file_as_read(&self, order: &Order) -> Result<(), ApiError> {
        let Some(run_file) = self.run_file() else { return Ok(()) };
        match order {
            Order::Arm { .. } | Order::DryRun { .. } => run_file.require_unchanged(),
            Order::Replay { file, .. } if file.is_some() && *file == run_file.report.path => {
                run_file.require_unchanged()
            }
            _ => Ok(()),
        }
    }

    /// The job that an order is about.
    fn job_for(&self, order: &Order, progress: &dyn Progress) -> Result<Option<Input>, ApiError> {
        Ok(match order {
            Order::Arm { despite_errors, .. } => {
                let job = self.job(*despite_errors, progress)?;
                self.keep_job(&job)?;
                Some(job)
            }
            Order::DryRun { despite_errors, .. } => Some(self.job(*despite_errors, progress)?),
            Order::ResumeRun { job_hash, .. } | Order::Abandon { job_hash, .. } => {
                Some(self.job_of(job_hash)?)
            }
            _ => None,
        })
    }

    /// Where the jobs are that were armed: the design may be another one when a wire is to be resumed.
    fn job_file(&self, hash: &str) -> Option<PathBuf> {
        self.places().runs.as_ref().map(|runs| runs.join("jobs").join(format!("{hash}.wbjob")))
    }

    fn keep_job(&self, job: &Input) -> Result<(), ApiError> {
        let (name, bytes) = job.load()?;
        let job = Job::open(&bytes, &name)?;
        let Some(file) = self.job_file(job.hash()).filter(|file| !file.is_file()) else { return Ok(()) };
        super::make_folder_of(&file)?;
        Ok(save_atomically(&file, &bytes)?)
    }

    /// A job that was armed before, or that the open design gives.
    fn job_of(&self, hash: &str) -> Result<Input, ApiError> {
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
