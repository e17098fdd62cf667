//! What is not over is given up before a wire is begun anew: by a person, or where nothing of it was sent.

use std::path::Path;

use wirebend_driver_host::jobs::{Clock, Entry, EntryKind, Heading, Journal, JournalError, Record};
use wirebend_error::InputName;

use super::report::{RunOutcome, RunResponse};
use super::task::Task;
use crate::runs::StoredRun;
use crate::{LiveProblem, OperationError};
use wirebend_planning::report::NoteReport;

impl Task<'_> {
    /// Gives up what was interrupted. Nothing moves.
    pub fn abandon(&self) -> Result<RunResponse, OperationError> {
        let mut response = self.response();
        let (mut set_aside, mut is_over) = (false, false);
        for wire in self.wanted() {
            let Some(StoredRun { id, path, read }) = self.last(wire)? else { continue };
            match read {
                Ok(written) if written.state.is_over() => is_over = true,
                Ok(written) => {
                    let (made, done_by) = (written.state.done, written.state.heading.done_by);
                    self.give_up(&path)?;
                    let record = Journal::read(&path).ok().and_then(|read| Record::of(&read.entries));
                    self.keep(record.as_ref(), &path, wire, &mut response)?;
                    let wire = self.untouched(wire, &id, RunOutcome::Abandoned, made, done_by)?;
                    response.wires.push(wire);
                }
                Err(error) if is_damaged(&error) || matches!(error, JournalError::Empty { .. }) => {
                    let aside = self.folder.set_aside(&path)?;
                    let message = format!(
                        "wire {} is given up; how much of it was bent is not known: its damaged journal was set aside as {}",
                        wire + 1,
                        aside.display()
                    );
                    response.notes.push(NoteReport {
                        code: "set-aside".into(),
                        count: 1,
                        message,
                        remedies: Vec::new(),
                    });
                    set_aside = true;
                }
                Err(error) => return Err(LiveProblem::from(error).into()),
            }
        }
        if response.wires.is_empty() && !set_aside {
            let begun = LiveProblem::NothingBegun { input: InputName::Abandon };
            return Err(if is_over { LiveProblem::NothingUnfinished } else { begun }.into());
        }
        Ok(response)
    }

    pub fn give_up(&self, journal: &Path) -> Result<(), LiveProblem> {
        Journal::open(journal)?.add(Entry { at: self.clock.stamp(), what: EntryKind::Abandoned })?;
        Ok(())
    }

    /// Whether a wire may be begun anew. What was begun and never sent a step is given up by itself.
    pub fn require_clear(&self, wire: usize) -> Result<(), OperationError> {
        let Some(kept) = self.last(wire)? else { return Ok(()) };
        match kept.read {
            Ok(written) if written.state.is_over() => Ok(()),
            Ok(written) if written.state.is_blank() => Ok(self.give_up(&kept.path)?),
            Ok(written) if Journal::is_in_use(&kept.path) => {
                let Heading { port, name, .. } = written.state.heading;
                Err(LiveProblem::AtWork { port, name }.into())
            }
            Ok(written) => Err(LiveProblem::Unfinished {
                wire,
                started: written.entries.first().map(|entry| entry.at.clone()).unwrap_or_default(),
                made: written.state.done,
                of: written.state.heading.steps,
                run: self.target(wire),
            }
            .into()),
            // Its first line was not written to its end: nothing was sent.
            Err(JournalError::Empty { .. }) => {
                self.folder.set_aside(&kept.path)?;
                Ok(())
            }
            Err(error) => Err(self.unreadable(wire, error).into()),
        }
    }

    /// A journal that cannot be read: a damaged one can be given up, of any other that is not known.
    pub fn unreadable(&self, wire: usize, error: JournalError) -> LiveProblem {
        if is_damaged(&error) {
            LiveProblem::DamagedJournal { error, run: self.target(wire) }
        } else {
            error.into()
        }
    }
}

/// Whether nobody can read it any more. One that the system does not give, or a later program has written, can be read another time.
const fn is_damaged(error: &JournalError) -> bool {
    matches!(error, JournalError::Damaged { newer: false, .. })
}
