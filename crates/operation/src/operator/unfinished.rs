//! A wire that was interrupted and can be resumed.

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_driver_host::jobs::{JournalError, Piece};

use crate::run::Task;
use crate::runs::{RunsFolder, StoredRun};
use wirebend_planning::Installation;

/// A wire that was interrupted and can be resumed.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Unfinished {
    /// The id of its record.
    pub id: String,
    pub job_hash: String,
    /// Name of the design.
    pub name: String,
    /// Index of the wire, from 0.
    pub wire: usize,
    /// Which piece it is, where several were to be bent in a row.
    pub piece: Option<Piece>,
    /// Where it was begun.
    pub port: String,
    pub started: String,
    /// The last step that is known to be done.
    pub made: u32,
    /// How many there are.
    pub of: u32,
    /// Steps in doubt, of which it is not known whether they were done: the first and the last.
    pub in_doubt: Option<[u32; 2]>,
    /// Whether it can be resumed: its record may be damaged. Then it can be given up, and nothing is known of when and
    /// where it was begun.
    pub resumable: bool,
}

impl Unfinished {
    /// The unfinished wire of a journal; `None` when the wire is over, nothing of it is made, or the journal cannot be read.
    pub(super) fn of(kept: &StoredRun) -> Option<Self> {
        let written = kept.read.as_ref().ok()?;
        let state = &written.state;
        if state.is_over() || state.is_blank() {
            return None;
        }
        let heading = &state.heading;
        Some(Self {
            id: kept.id.clone(),
            job_hash: heading.job_hash.clone(),
            name: heading.name.clone(),
            wire: heading.wire,
            piece: heading.piece,
            port: heading.port.clone(),
            started: written.entries.first().map(|entry| entry.at.clone()).unwrap_or_default(),
            made: state.done,
            of: heading.steps,
            in_doubt: state.in_doubt().map(|steps| [*steps.start(), *steps.end()]),
            resumable: true,
        })
    }

    /// The last wire that was begun on a machine at a port, where it is not over.
    pub(super) fn last_on(app: &Installation, machine: &str, port: &str) -> Option<Self> {
        // Without a place for journals no wire was begun.
        let last = RunsFolder::of(app).and_then(|folder| folder.last_at(machine, port)).ok()??;
        Self::of(&last)
    }

    /// The last time that a wire of a job was begun, where it is not over.
    pub(super) fn of_wire(task: &Task, wire: usize) -> Option<Self> {
        let kept = task.last(wire).ok()??;
        match kept.read {
            Err(JournalError::Damaged { .. } | JournalError::Impossible { .. }) => {
                let steps = task.wire(wire).map_or(0, |kept| kept.compensated.len());
                Some(Self {
                    id: kept.id,
                    job_hash: task.job.hash().to_owned(),
                    name: task.request.job.stem(),
                    wire,
                    piece: None,
                    port: String::new(),
                    started: String::new(),
                    made: 0,
                    of: u32::try_from(steps).unwrap_or(u32::MAX),
                    in_doubt: None,
                    resumable: false,
                })
            }
            _ => Self::of(&kept),
        }
    }
}
