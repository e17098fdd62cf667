//! What is written down.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_driver_api::{DoneBy, DriverError, ResumeState, Step};

use crate::session::StoppedBy;

/// The version of the format; a journal of a later one is refused. Since 2 there are [`EntryKind::Standstill`] and
/// [`EntryKind::NotTaken`]. Since 3 there are [`EntryKind::PartMade`] and [`EntryKind::Part`], and the steps after the one that a
/// [`EntryKind::Fault`] names were not begun. Since 4 there is [`EntryKind::PauseConfirmed`].
pub const VERSION: u32 = 4;

/// A line of a journal.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Entry {
    /// When, as the caller writes times: for people.
    pub at: String,
    #[serde(flatten)]
    pub what: EntryKind,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "record", rename_all = "kebab-case")]
pub enum EntryKind {
    /// The first line: what is to be bent, of what, on which machine.
    Job(Heading),
    /// The machine has answered.
    Connected {
        /// What it says that it is.
        identity: String,
        /// Where it is in the wire, when it still is in it.
        #[serde(default, rename = "going_on")]
        resume: Option<ResumeState>,
    },
    /// A person has confirmed, and the machine is ready.
    Armed {
        /// What the driver calls the machine's session.
        #[serde(default)]
        token: Option<String>,
        /// How many steps were done before.
        after: u32,
        /// The machine still is in the session of before, with the steps that it has taken.
        #[serde(default, rename = "going_on")]
        resumed: bool,
    },
    /// Steps are about to be sent. On the disk before they are.
    Intent {
        /// The first: the one after the last that was intended.
        from: u32,
        /// The last.
        to: u32,
    },
    /// The driver has taken the steps up to this one.
    Accepted {
        /// The last.
        n: u32,
    },
    /// The driver has refused, or has no room for, the steps after this one: they were not sent.
    NotTaken {
        /// The last that it has taken.
        after: u32,
    },
    /// A step is done.
    Done { n: u32 },
    /// The machine holds.
    Paused,
    /// The machine resumes.
    Resumed,
    /// A person has said that the wire goes on past the pause point after a step.
    PauseConfirmed {
        after: u32,
        /// What they had to do there.
        note: String,
    },
    /// The machine was stopped.
    Stopped {
        /// What caused it; absent when the machine stopped by itself or at a button of its own.
        #[serde(default)]
        by: Option<StoppedBy>,
    },
    /// What came of a stop, or of the stop that follows the loss of a driver: whether the machine has confirmed that it
    /// stands. Where this is missing, the program ended before it was known.
    Standstill {
        /// Whether it has.
        confirmed: bool,
    },
    /// The machine, its line or its driver failed.
    Fault {
        error: DriverError,
        /// The step of which the driver does not know whether it was done; those after it were not begun. Without it, all
        /// that were sent and not reported are in doubt: the machine may have continued without the driver.
        #[serde(default)]
        in_doubt: Option<u32>,
    },
    /// The machine stands in the middle of a step, and has not begun those after it.
    PartMade {
        /// The step.
        n: u32,
        /// How much of what was sent of it is fed and turned, and where the bend axis stands, in the machine's signs.
        #[serde(default)]
        made: Option<Step>,
        /// The axis that was on its way stands exactly there.
        #[serde(default)]
        exact: bool,
    },
    /// So much of the first step in doubt is in the wire: the machine has counted it, or a person has measured it. The rest of
    /// it follows, with its bend from the beginning.
    Part {
        n: u32,
        /// How much of it is fed, in the machine's signs.
        feed_mm: f64,
        /// How much of it is turned, in the machine's signs.
        rotate_deg: f64,
        /// Whether the machine or a person has said so.
        by: ToldBy,
    },
    /// A person has looked whether a step in doubt was done.
    Decided {
        /// The first in doubt.
        n: u32,
        /// Whether it was. If not, those after it were not either: steps are run in order.
        made: bool,
    },
    /// A person takes back what they have said of a step, and of those after it. Nothing was bent since.
    TakenBack { n: u32 },
    /// What came out, as far as it is known.
    Made {
        /// Corners of the wire as a simulated machine bent it, mm.
        #[serde(default)]
        corners_mm: Vec<[f64; 3]>,
        /// How far each corner is from the design, mm.
        #[serde(default)]
        deviations_mm: Option<Vec<f64>>,
    },
    /// The wire is finished.
    Finished,
    /// A person has given the wire up.
    Abandoned,
}

/// Whether the machine or a person has said how much of a step is done.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ToldBy {
    /// The machine, for axes that were at rest when it was stopped.
    Machine,
    Person,
}

/// One of several pieces of the same, which are bent in a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Piece {
    /// Counted from 1.
    pub number: u32,
    /// How many there were to be.
    pub of: u32,
}

/// What is to be bent, of what, on which machine.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Heading {
    /// Version of the format.
    pub version: u32,
    pub job_hash: String,
    /// Hash of the design that it was planned from.
    pub design_hash: String,
    /// Name of the design.
    pub name: String,
    /// Index of the wire, from 0.
    pub wire: usize,
    /// Which piece it is, where several of the same were to be bent in a row; absent otherwise.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub piece: Option<Piece>,
    /// How many steps it has.
    pub steps: u32,
    /// Id of the machine's profile.
    pub machine: String,
    /// Id of the driver.
    pub driver: String,
    pub driver_version: String,
    /// The port that the machine is at.
    pub port: String,
    /// Id of the material.
    pub material: String,
    /// Wire that has to be put in, mm.
    #[serde(default)]
    pub stock_mm: Option<f64>,
    /// What reports that a step is done.
    #[serde(default)]
    pub done_by: DoneBy,
    /// How long each step is reckoned to take, s; empty where there is no estimate.
    #[serde(default)]
    pub estimates_s: Vec<f64>,
}
