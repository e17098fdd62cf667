//! `run`: a job run on its machine, wire by wire, with a journal that outlives whatever happens.

mod about;
mod absence;
mod begin;
mod cutting;
mod doubt;
mod giving_up;
mod interrupted;
mod making;
mod pausing;
mod report;
mod resume;
mod stale;
mod step_watch;
mod task;

use schemars::JsonSchema;
use serde::Deserialize;

use crate::FrontEnd;
use crate::live::Answers;
use crate::{Decided, OperationError, Repeat};
pub use about::about;
pub use cutting::{AfterCut, WirePermit};
pub use report::{LeftBecause, RunOutcome, RunResponse, StoppedIn, WireRun};
pub use task::Task;
use wirebend_planning::Installation;
use wirebend_planning::design::Input;
use wirebend_planning::job::SimulatedAs;
use wirebend_planning::misnamed::RECORD;
use wirebend_planning::output::Output;

/// What to run. Nothing moves unless the user confirms it: here, or when they are asked.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct RunRequest {
    /// A job, or a program in the format of its machine, which is run as it stands.
    pub job: Input,
    /// The machine that a program is for; a job says it itself.
    #[serde(default)]
    pub machine: Option<String>,
    /// The wire that a program is for; absent, the one that the machine's profile names.
    #[serde(default)]
    pub material: Option<String>,
    /// Whether to run a program although a check says that the machine cannot make it, or a wire although it hits the machine or itself.
    #[serde(default)]
    pub despite_errors: bool,
    /// Where the machine is; absent, the machine that its driver simulates is taken, if it has one. A wire resumes
    /// there only where it was begun on it.
    pub port: Option<String>,
    /// Index of the one wire to bend, from 0; absent, all of them.
    pub wire: Option<usize>,
    /// How many pieces of the same are bent in a row.
    #[serde(default)]
    pub repeat: Repeat,
    /// Whether to begin, to resume, or to give up.
    #[serde(default)]
    pub how: RunHow,
    /// What a simulated machine bends, and with what head; refused for a real one.
    #[serde(default)]
    pub simulated_as: SimulatedAs,
    #[serde(flatten)]
    pub answers: Answers,
    /// Whether to bend wires although the machine's settings are not those of its profile.
    #[serde(default)]
    pub accept_settings: bool,
    /// Where the records go besides; those of several wires get numbers.
    pub record: Option<Output>,
}

/// What to do with a job's wires.
#[derive(Debug, Clone, Copy, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(tag = "how", rename_all = "kebab-case")]
pub enum RunHow {
    /// To bend them from their beginning.
    #[default]
    Begin,
    /// To resume the one that was interrupted.
    Resume {
        /// What became of the first step in doubt; absent, the user is asked where the machine does not know.
        decided: Option<Decided>,
    },
    /// To give up what was interrupted, so that it can be begun anew. Nothing moves for it.
    Abandon,
}

pub fn run(
    app: &Installation,
    request: &RunRequest,
    progress: &dyn FrontEnd,
) -> Result<RunResponse, OperationError> {
    let task = Task::open(app, request.clone(), progress)?;
    let mut response = match request.how {
        RunHow::Begin => task.begin(),
        RunHow::Resume { decided } => task.resume(decided),
        RunHow::Abandon => task.abandon(),
    }?;
    if !response.files.is_empty() {
        response.notes.extend(RECORD.misnamed(request.record.as_ref()));
    }
    Ok(response)
}
