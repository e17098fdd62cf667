//! What became of a job's wires.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_driver_host::api::DoneBy;
use wirebend_driver_host::jobs::Piece;
use wirebend_driver_host::{Standstill, StoppedBy};
use wirebend_error::{ProblemReport, RunTarget};

use crate::PiecesReport;
use wirebend_planning::PartOfStep;
use wirebend_planning::report::{JobStep, NoteReport};

/// What became of the wires of the request.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct RunResponse {
    pub machine: String,
    pub material: String,
    pub job_hash: String,
    /// Where the machine was; null where none was connected.
    pub port: Option<String>,
    /// What the machine says that it is.
    pub identity: Option<String>,
    /// The wires, in the order in which they were run.
    pub wires: Vec<WireRun>,
    /// Wires of the piece that were asked for and are not begun: of several that a machine bends one after the other, those that follow.
    pub left: Vec<usize>,
    /// Why not; null where nothing is left, or a wire before them was not finished.
    pub left_because: Option<LeftBecause>,
    /// How many pieces of the same came to their end.
    pub pieces: PiecesReport,
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
    /// What was interrupted is resumed; these were never begun.
    NothingToResume,
    /// There was no user to ask whether the next wire is in the machine, or where its axes stand.
    NobodyAsked,
}

/// A step that was stopped in its middle.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct StoppedIn {
    pub step: u32,
    /// How much of it is fed, mm of wire, and turned, degrees.
    pub made: PartOfStep,
    /// What the machine is told of it in all, with its feed in mm of wire: the bend starts from its beginning.
    pub of: JobStep,
    /// Where the bend axis stands, degrees; null where the machine was homed since.
    pub bend_at_deg: Option<f64>,
    /// Whether that is sure. An axis that was on its way may have lost steps: then the user has to look at the wire.
    pub sure: bool,
}

/// What became of one wire.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct WireRun {
    /// Its index, from 0.
    pub wire: usize,
    /// Which piece it is of, where there were to be several.
    pub piece: Option<Piece>,
    /// The id of its record: see `wirebend runs`.
    pub id: String,
    /// What became of it.
    pub outcome: RunOutcome,
    /// The last step that is done, or, where the machine does not report that, that has had its time.
    pub made: u32,
    /// What reports that a step is done.
    pub done_by: DoneBy,
    /// How many there are.
    pub steps: u32,
    /// Steps in doubt, of which it is not known whether they were done: the first and the last.
    pub in_doubt: Option<[u32; 2]>,
    /// The step that was stopped in its middle, as far as the machine counts.
    pub stopped_in: Option<StoppedIn>,
    /// Wire that had to be put in, in mm.
    pub stock_mm: f64,
    /// How long the machine was at work on it, in all of its parts, without pauses, s.
    pub elapsed_s: f64,
    /// What caused a stop; null without one, and for one of the machine itself.
    pub stopped_by: Option<StoppedBy>,
    /// Whether the machine stands after a stop, after its driver was lost, or after a fault while it might move; null
    /// where there was none of them.
    pub standstill: Option<Standstill>,
    /// What failed, or why it was stopped without a request.
    pub problem: Option<ProblemReport>,
    /// How far each vertex is from the design, in mm, where a simulated machine bent the wire.
    pub deviations_mm: Option<Vec<f64>>,
    /// The command that resumes it, where there is something to resume; only a command line has one.
    pub resume: Option<String>,
    /// The wire, where there is something to resume.
    #[serde(skip)]
    pub resumable: Option<RunTarget>,
}

/// What became of a wire.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RunOutcome {
    Made,
    /// It was finished before: nothing was left to do.
    MadeBefore,
    /// All of its steps were sent, now or before, to a machine that does not report whether it has run them.
    Sent,
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
    pub const fn is_whole(self) -> bool {
        matches!(self, Self::Made | Self::Sent)
    }
}

impl WireRun {
    /// The largest deviation, in mm.
    #[must_use]
    pub fn worst_deviation_mm(&self) -> Option<f64> {
        self.deviations_mm.as_ref().map(|all| all.iter().copied().fold(0.0, f64::max))
    }
}
