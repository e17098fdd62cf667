//! The folder of journals: one file for each time that a wire was begun.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use wirebend_driver_host::jobs::{Journal, JournalError, Record, Written};

use crate::{LiveProblem, OperationError};
use wirebend_planning::Installation;

const EXTENSION: &str = "journal";
/// How much of a job's hash is in the name of a journal.
const HASH_DIGITS: usize = 12;

#[derive(Debug, Clone)]
pub struct RunsFolder(PathBuf);

/// A journal that is there.
pub struct StoredRun {
    /// What `wirebend runs` calls it: beginning of the job's hash, wire, and how often that was begun.
    pub id: String,
    pub path: PathBuf,
    pub read: Result<Written, JournalError>,
}

impl StoredRun {
    /// What was done, as far as the journal can be read.
    pub fn record(&self) -> Option<Record> {
        self.read.as_ref().ok().and_then(|written| Record::of(&written.entries))
    }

    /// When its last line was written, where the disk says so.
    pub fn last_written(&self) -> Option<SystemTime> {
        fs::metadata(&self.path).and_then(|metadata| metadata.modified()).ok()
    }
}

impl RunsFolder {
    /// Where journals are kept.
    pub fn of(app: &Installation) -> Result<Self, LiveProblem> {
        app.runs.clone().map(Self).ok_or(LiveProblem::NowhereToRecord)
    }

    pub fn path(&self) -> &Path {
        &self.0
    }

    /// Every journal, by name.
    pub fn all(&self) -> Result<Vec<StoredRun>, LiveProblem> {
        Ok(self
            .names()?
            .into_iter()
            .map(|(id, path)| StoredRun { read: Journal::read(&path), id, path })
            .collect())
    }

    /// The journals of one wire of a job, in the order in which they were begun.
    pub fn of_wire(&self, job_hash: &str, wire: usize) -> Result<Vec<StoredRun>, LiveProblem> {
        let stem = stem(job_hash, wire);
        let mut found: Vec<(u32, StoredRun)> = Vec::new();
        for (id, path) in self.names()? {
            if let Some(number) = id.strip_prefix(&stem).and_then(|number| number.parse().ok()) {
                found.push((number, StoredRun { read: Journal::read(&path), id, path }));
            }
        }
        found.sort_by_key(|(number, _)| *number);
        Ok(found.into_iter().map(|(_, kept)| kept).collect())
    }

    /// The last time that a wire was begun on a machine at a port.
    pub fn last_at(&self, machine: &str, port: &str) -> Result<Option<StoredRun>, LiveProblem> {
        let here = self.all()?.into_iter().filter(|kept| {
            kept.read.as_ref().is_ok_and(|written| {
                let heading = &written.state.heading;
                heading.machine == machine && heading.port == port
            })
        });
        let begun = |kept: &StoredRun| {
            let at = kept.read.as_ref().ok().and_then(|written| written.entries.first());
            (at.map(|entry| entry.at.clone()), kept.id.clone())
        };
        Ok(here.max_by_key(begun))
    }

    /// The name of the next journal of a wire; the folder is created where it is missing.
    pub fn next(&self, job_hash: &str, wire: usize) -> Result<(String, PathBuf), LiveProblem> {
        fs::create_dir_all(&self.0).map_err(|cause| self.failed(cause))?;
        let stem = stem(job_hash, wire);
        // One that is set aside keeps its number, so that no record is written over.
        let numbers = self.files()?.into_iter().filter_map(|path| {
            let name = path.file_name()?.to_str()?.strip_prefix(&stem)?.to_owned();
            name.split('.').next()?.parse::<u32>().ok()
        });
        let id = format!("{stem}{}", numbers.max().unwrap_or(0) + 1);
        let path = self.0.join(format!("{id}.{EXTENSION}"));
        Ok((id, path))
    }

    /// The journal whose id begins so.
    pub fn find(&self, beginning: &str) -> Result<StoredRun, LiveProblem> {
        let mut found = self.names()?;
        if let Some(exact) = found.iter().position(|(id, _)| id == beginning) {
            found = vec![found.swap_remove(exact)];
        }
        found.retain(|(id, _)| id.starts_with(beginning));
        match found.len() {
            0 => Err(LiveProblem::NoRun { id: beginning.to_owned() }),
            1 => {
                let (id, path) = found.swap_remove(0);
                Ok(StoredRun { read: Journal::read(&path), id, path })
            }
            _ => {
                let known = found.into_iter().map(|(id, _)| id).collect();
                Err(LiveProblem::SeveralRuns { id: beginning.to_owned(), known })
            }
        }
    }

    /// Takes a journal that cannot be read out of the way, and gives its new name.
    pub fn set_aside(&self, journal: &Path) -> Result<PathBuf, LiveProblem> {
        let aside = journal.with_extension("damaged");
        fs::rename(journal, &aside).map_err(|cause| self.failed(cause))?;
        Ok(aside)
    }

    fn names(&self) -> Result<Vec<(String, PathBuf)>, LiveProblem> {
        let journals =
            self.files()?.into_iter().filter(|path| path.extension().is_some_and(|e| e == EXTENSION));
        let named = journals.filter_map(|path| Some((path.file_stem()?.to_str()?.to_owned(), path)));
        let mut names: Vec<_> = named.collect();
        names.sort();
        Ok(names)
    }

    /// Nothing where there is no folder yet.
    fn files(&self) -> Result<Vec<PathBuf>, LiveProblem> {
        match fs::read_dir(&self.0) {
            Ok(entries) => Ok(entries.filter_map(Result::ok).map(|entry| entry.path()).collect()),
            Err(cause) if cause.kind() == std::io::ErrorKind::NotFound => Ok(Vec::new()),
            Err(cause) => Err(self.failed(cause)),
        }
    }

    fn failed(&self, cause: std::io::Error) -> LiveProblem {
        LiveProblem::RunsFolder { folder: self.0.clone(), cause }
    }
}

fn stem(job_hash: &str, wire: usize) -> String {
    format!("{}-{wire}-", job_hash.get(..HASH_DIGITS).unwrap_or(job_hash))
}

/// The record of a journal as a file.
pub fn record_bytes(record: &Record) -> Result<Vec<u8>, OperationError> {
    let mut bytes = serde_json::to_vec_pretty(record)?;
    bytes.push(b'\n');
    Ok(bytes)
}
