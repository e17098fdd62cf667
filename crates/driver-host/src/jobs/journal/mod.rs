//! The journal of a wire: a file to which lines are only added, each on the disk before anything else happens.

mod entry;
mod reading;
#[cfg(test)]
mod tests;

use std::io;
use std::path::{Path, PathBuf};

use wirebend_journal::{Lines, Log, LogError};

use super::account::Account;
pub use entry::{Entry, Heading, ToldBy, What};
pub use reading::Written;

/// Why a journal cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum JournalError {
    /// There is one already.
    #[error("there is a journal {} already: take up the wire that it tells of, or give it up", path.display())]
    Exists {
        /// The file.
        path: PathBuf,
    },
    /// Another program, or another window of this one, makes the wire.
    #[error("the journal {} is in use: another program, or another window of this one, makes this wire: wait until it is made, or stop it there", path.display())]
    InUse {
        /// The file.
        path: PathBuf,
    },
    /// It has not one whole line.
    #[error("the journal {} tells of no job: nothing was sent to a machine, and it can be deleted", path.display())]
    Empty {
        /// The file.
        path: PathBuf,
    },
    /// A line was changed, or says what cannot be.
    #[error(
        "line {line} of the journal {} is damaged: {what}; what was made cannot be told from it: look at the wire, home the machine and begin anew",
        path.display()
    )]
    Damaged {
        /// The file.
        path: PathBuf,
        /// Which line, from 1.
        line: usize,
        /// What is wrong.
        what: String,
    },
    /// What was to be written contradicts what is there.
    #[error("this cannot be written down: {what}")]
    Impossible {
        /// Why.
        what: String,
    },
    /// Writing failed before: what is in the file is not sure any more.
    #[error("the journal {} could not be written before: open it again", path.display())]
    Broken {
        /// The file.
        path: PathBuf,
    },
    /// The system refuses.
    #[error("the journal {} cannot be {doing}: {cause}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// What was tried.
        doing: &'static str,
        /// Why not.
        cause: io::Error,
    },
}

impl From<LogError> for JournalError {
    fn from(error: LogError) -> Self {
        match error {
            LogError::Exists { path } => Self::Exists { path },
            LogError::InUse { path } => Self::InUse { path },
            LogError::Empty { path } => Self::Empty { path },
            LogError::Damaged { path, line, what } => Self::Damaged { path, line, what },
            LogError::Broken { path } => Self::Broken { path },
            LogError::Io { path, doing, cause } => Self::Io { path, doing, cause },
        }
    }
}

/// A journal that is being written. It is locked: no other process has it at the same time. The lock ends with
/// the process, however that ends.
#[derive(Debug)]
pub struct Journal {
    log: Log,
    written: Written,
}

impl Journal {
    /// Begins a journal. `at` is the time of day as people shall read it.
    ///
    /// # Errors
    /// [`JournalError::Exists`], [`JournalError::Io`].
    pub fn create(path: &Path, heading: Heading, at: String) -> Result<Self, JournalError> {
        let heading = Heading { version: entry::VERSION, ..heading };
        let first = Entry { at, what: What::Job(heading) };
        let account =
            reading::counted(None, &first.what).map_err(|what| JournalError::Impossible { what })?;
        let log = Log::create(path, &body(&first)?)?;
        Ok(Self { log, written: Written { entries: vec![first], account, torn: false } })
    }

    /// Takes a journal up again. A last line that was not written to its end is taken away.
    ///
    /// # Errors
    /// [`JournalError`]; the whole lines of the file are as they were then.
    pub fn open(path: &Path) -> Result<Self, JournalError> {
        let (log, lines) = Log::open(path)?;
        let written = understood(path, &lines)?;
        Ok(Self { log, written })
    }

    /// Reads a journal without taking it up: another process may be writing it.
    ///
    /// # Errors
    /// [`JournalError::Empty`], [`JournalError::Damaged`], [`JournalError::Io`].
    pub fn read(path: &Path) -> Result<Written, JournalError> {
        understood(path, &Log::read(path)?)
    }

    /// Whether somebody writes it: the wire is being made, by this program or another.
    #[must_use]
    pub fn is_in_use(path: &Path) -> bool {
        Log::is_in_use(path)
    }

    /// Adds an entry. When this returns it is on the disk.
    ///
    /// # Errors
    /// [`JournalError::Impossible`] when it contradicts what is there: nothing is written. [`JournalError::Io`]
    /// when the disk is full or gone: from then on [`JournalError::Broken`].
    pub fn add(&mut self, entry: Entry) -> Result<(), JournalError> {
        let account = reading::counted(Some(self.written.account.clone()), &entry.what)
            .map_err(|what| JournalError::Impossible { what })?;
        self.log.add(&body(&entry)?)?;
        self.written.account = account;
        self.written.entries.push(entry);
        Ok(())
    }

    /// What it comes to.
    #[must_use]
    pub const fn account(&self) -> &Account {
        &self.written.account
    }

    /// What happened, in order.
    #[must_use]
    pub fn entries(&self) -> &[Entry] {
        &self.written.entries
    }

    /// The file.
    #[must_use]
    pub fn path(&self) -> &Path {
        self.log.path()
    }
}

fn understood(path: &Path, lines: &Lines) -> Result<Written, JournalError> {
    let damaged = |(line, what)| JournalError::Damaged { path: path.to_owned(), line, what };
    Written::of(lines).map_err(damaged)
}

fn body(entry: &Entry) -> Result<String, JournalError> {
    serde_json::to_string(entry).map_err(|error| JournalError::Impossible { what: error.to_string() })
}
