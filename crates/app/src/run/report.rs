//! What became of a job's wires.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_driver_host::api::{DoneBy, DriverError};
use wirebend_driver_host::{SessionError, Standstill, StoppedBy};

use crate::report::{NoteReport, StepReport};
use crate::{AppError, DriverProblem, LiveProblem, PartOfStep};

/// What became of the wires that were to be made.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct RunResponse {
    /// The machine.
    pub machine: String,
    /// The material.
    pub material: String,
    /// Hash of the job.
    pub job_hash: String,
    /// Where the machine was; null where none was connected.
    pub port: Option<String>,
    /// What the machine says that it is.
    pub identity: Option<String>,
    /// The wires, in the order in which they were taken up.
    pub wires: Vec<WireRun>,
    /// Wires that were asked for and not begun.
    pub left: Vec<usize>,
    /// Why not; null where nothing is left, or a wire before them was not made.
    pub left_because: Option<LeftBecause>,
    /// What a person should know.
    pub notes: Vec<NoteReport>,
    /// The records that were written where they were asked for.
    pub files: Vec<PathBuf>,
}

/// Why wires, or moves by hand, were not begun.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum LeftBecause {
    /// A person has said no.
    Declined,
    /// Nobody was there to be asked: whether the next wire is in the machine, or where its axes stand.
    NobodyAsked,
}

/// A step that was stopped in its middle.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct StoppedIn {
    /// The step.
    pub step: u32,
    /// How much of it is fed, mm, and turned, degrees.
    pub made: PartOfStep,
    /// What the machine is told of it in all: the bend is made from its beginning.
    pub of: StepReport,
    /// Where the bend axis stands, degrees.
    pub bend_at_deg: f64,
    /// Whether that is sure. An axis that was on its way may have lost steps: then somebody has to look at the wire.
    pub sure: bool,
}

/// What became of one wire.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct WireRun {
    /// Its index, from 0.
    pub wire: usize,
    /// The id of its record: see `wirebend runs`.
    pub id: String,
    /// What became of it.
    pub outcome: RunOutcome,
    /// The last step that was made, or, where the machine does not say so, that has had its time.
    pub made: u32,
    /// Who says that a step is made.
    pub done_by: DoneBy,
    /// How many there are.
    pub steps: u32,
    /// Steps of which nobody knows whether they were made: the first and the last.
    pub in_doubt: Option<[u32; 2]>,
    /// The step that was stopped in its middle, as far as the machine counts.
    pub stopped_in: Option<StoppedIn>,
    /// Wire that had to be put in, in mm.
    pub stock_mm: f64,
    /// How long it took this time, in s.
    pub elapsed_s: f64,
    /// Who brought a stop about; null without one, and for one of the machine itself.
    pub stopped_by: Option<StoppedBy>,
    /// Whether the machine stands after a stop, after its driver was lost, or after a fault while it might move; null
    /// where there was none of them.
    pub standstill: Option<Standstill>,
    /// What failed, or why it was stopped where nobody has asked for that.
    pub problem: Option<RunProblem>,
    /// How far each vertex is from the design, in mm, where a simulated machine made the wire.
    pub deviations_mm: Option<Vec<f64>>,
    /// The command that goes on with it, where there is something to go on with.
    pub resume: Option<String>,
}

/// What became of a wire.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RunOutcome {
    /// It is made.
    Made,
    /// It was made before: nothing was left to do.
    MadeBefore,
    /// All of its steps were sent, now or before, to a machine that does not say whether it has made them.
    Sent,
    /// It was stopped.
    Stopped,
    /// The machine, its line or its driver failed.
    Failed,
    /// It was given up.
    Abandoned,
}

impl RunOutcome {
    /// Of a wire that was taken to its end just now.
    pub(super) const fn ended(done_by: DoneBy) -> Self {
        match done_by {
            DoneBy::Machine => Self::Made,
            DoneBy::Clock => Self::Sent,
        }
    }

    /// Of one of which nothing was left to do.
    pub(super) const fn ended_before(done_by: DoneBy) -> Self {
        match done_by {
            DoneBy::Machine => Self::MadeBefore,
            DoneBy::Clock => Self::Sent,
        }
    }

    /// Whether it came to its end just now.
    pub(super) const fn is_whole(self) -> bool {
        matches!(self, Self::Made | Self::Sent)
    }
}

/// What failed.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct RunProblem {
    /// A name that stays.
    pub code: String,
    /// What happened and what to do.
    pub message: String,
}

macro_rules! from_coded {
    ($($error:ty),*) => {$(
        impl From<&$error> for RunProblem {
            fn from(error: &$error) -> Self {
                Self { code: error.code().to_owned(), message: error.to_string() }
            }
        }
    )*};
}

from_coded!(AppError, DriverProblem, LiveProblem, SessionError);

impl From<&DriverError> for RunProblem {
    fn from(error: &DriverError) -> Self {
        Self { code: error.code.clone(), message: error.to_string() }
    }
}

impl WireRun {
    /// The largest deviation, in mm.
    #[must_use]
    pub fn worst_deviation_mm(&self) -> Option<f64> {
        self.deviations_mm.as_ref().map(|all| all.iter().copied().fold(0.0, f64::max))
    }
}
