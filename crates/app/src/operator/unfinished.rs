//! A wire that was interrupted and can be gone on with.

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_driver_host::api::DoneBy;
use wirebend_driver_host::jobs::JournalError;

use super::state::WireState;
use crate::App;
use crate::run::Task;
use crate::runs::{Kept, RunsFolder};

/// A wire that was interrupted and can be gone on with.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Unfinished {
    /// The id of its record.
    pub id: String,
    /// Hash of its job.
    pub job_hash: String,
    /// Name of the design.
    pub name: String,
    /// Index of the wire, from 0.
    pub wire: usize,
    /// Where it was begun.
    pub port: String,
    /// When.
    pub started: String,
    /// The last step that is known to be made.
    pub made: u32,
    /// How many there are.
    pub of: u32,
    /// Steps of which nobody knows whether they were made: the first and the last.
    pub in_doubt: Option<[u32; 2]>,
    /// Whether it can be gone on with: its record may be damaged. Then it can be given up, and nothing is known of when and
    /// where it was begun.
    pub resumable: bool,
}

impl Unfinished {
    /// What a journal tells of; `None` when the wire is over, none of it was sent, or the journal cannot be read.
    pub(super) fn of(kept: &Kept) -> Option<Self> {
        let written = kept.read.as_ref().ok()?;
        let account = &written.account;
        if account.is_over() || account.sent == 0 {
            return None;
        }
        let heading = &account.heading;
        Some(Self {
            id: kept.id.clone(),
            job_hash: heading.job_hash.clone(),
            name: heading.name.clone(),
            wire: heading.wire,
            port: heading.port.clone(),
            started: written.entries.first().map(|entry| entry.at.clone()).unwrap_or_default(),
            made: account.done,
            of: heading.steps,
            in_doubt: account.in_doubt().map(|steps| [*steps.start(), *steps.end()]),
            resumable: true,
        })
    }

    /// The last wire that was begun on a machine at a port, where it is not over.
    pub(super) fn last_on(app: &App, machine: &str, port: &str) -> Option<Self> {
        // Without a place for journals no wire was made.
        let all = RunsFolder::of(app).and_then(|folder| folder.all()).ok()?;
        let here = all.iter().filter(|kept| {
            kept.read.as_ref().is_ok_and(|written| {
                let heading = &written.account.heading;
                heading.machine == machine && heading.port == port
            })
        });
        let begun = |kept: &&Kept| {
            let at = kept.read.as_ref().ok().and_then(|written| written.entries.first());
            (at.map(|entry| entry.at.clone()), kept.id.clone())
        };
        here.max_by_key(begun).and_then(Self::of)
    }

    /// The last time that a wire of a job was begun, where it is not over.
    pub(super) fn of_wire(task: &Task, wire: usize) -> Option<Self> {
        let kept = task.last(wire).ok()??;
        match kept.read {
            Err(JournalError::Damaged { .. } | JournalError::Impossible { .. }) => {
                let WireState { job_hash, name, of, .. } =
                    WireState::of(task, wire, task.request.job.stem(), 0, DoneBy::default());
                let (port, started, in_doubt) = (String::new(), String::new(), None);
                Some(Self {
                    id: kept.id,
                    job_hash,
                    name,
                    wire,
                    port,
                    started,
                    made: 0,
                    of,
                    in_doubt,
                    resumable: false,
                })
            }
            _ => Self::of(&kept),
        }
    }
}
