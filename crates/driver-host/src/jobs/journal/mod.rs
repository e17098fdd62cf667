//! The journal of a wire: a file to which lines are only added, each on the disk before anything else happens.

mod reading;
#[cfg(test)]
mod tests;

use std::io;
use std::path::{Path, PathBuf};

use wirebend_error::{ErrorCode, ErrorRemedy};
use wirebend_journal::{Lines, Log, LogError};

use super::entry::{self, Entry, EntryKind, Heading};
use super::journal_state::JournalState;
pub use reading::Written;
use reading::Wrong;

/// Why a journal cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum JournalError {
    /// There is one already.
    #[error("there is a journal {} already", path.display())]
    Exists { path: PathBuf },
    /// Another program, or another window of this one, bends the wire.
    #[error("the journal {} is in use: another program, or another window of this one, bends this wire", path.display())]
    InUse { path: PathBuf },
    /// It has not one whole line.
    #[error("the journal {} names no job: nothing was sent to a machine", path.display())]
    Empty { path: PathBuf },
    /// A line was changed, or says what cannot be.
    #[error(
        "line {line} of the journal {} is damaged: {what}; it does not show which steps are done",
        path.display()
    )]
    Damaged {
        path: PathBuf,
        /// Which line, from 1.
        line: usize,
        what: String,
        /// A later program has written it.
        newer: bool,
    },
    /// What was to be written contradicts what is there.
    #[error("this cannot be written down: {what}")]
    Impossible { what: String },
    /// Writing failed before: what is in the file is not sure any more.
    #[error("the journal {} could not be written before", path.display())]
    Broken { path: PathBuf },
    /// The system refuses.
    #[error("the journal {} cannot be {doing}: {cause}", path.display())]
    Io {
        path: PathBuf,
        /// What was tried.
        doing: &'static str,
        cause: io::Error,
    },
}

impl JournalError {
    /// A name that stays the same while the wording may change.
    #[must_use]
    pub const fn code(&self) -> ErrorCode {
        match self {
            Self::Exists { .. } => ErrorCode::JournalExists,
            Self::InUse { .. } => ErrorCode::JournalInUse,
            Self::Empty { .. } => ErrorCode::JournalEmpty,
            Self::Damaged { .. } => ErrorCode::JournalDamaged,
            Self::Impossible { .. } => ErrorCode::JournalImpossible,
            Self::Broken { .. } | Self::Io { .. } => ErrorCode::JournalIo,
        }
    }

    /// What can be done about it.
    #[must_use]
    pub fn remedies(&self) -> Vec<ErrorRemedy> {
        match self {
            Self::InUse { .. } => vec![ErrorRemedy::Wait, ErrorRemedy::Stop],
            Self::Damaged { newer: true, .. } => vec![ErrorRemedy::UpdateProgram],
            Self::Damaged { .. } => vec![ErrorRemedy::LookAtWire, ErrorRemedy::Home, ErrorRemedy::BeginAnew],
            Self::Broken { .. } | Self::Io { .. } => vec![ErrorRemedy::CheckDisk],
            Self::Exists { .. } | Self::Empty { .. } => vec![ErrorRemedy::BeginAnew],
            Self::Impossible { .. } => Vec::new(),
        }
    }
}

impl From<LogError> for JournalError {
    fn from(error: LogError) -> Self {
        match error {
            LogError::Exists { path } => Self::Exists { path },
            LogError::InUse { path } => Self::InUse { path },
            LogError::Empty { path } => Self::Empty { path },
            LogError::Damaged { path, line, what } => Self::Damaged { path, line, what, newer: false },
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
        let first = Entry { at, what: EntryKind::Job(heading) };
        let state = reading::counted(None, &first.what).map_err(|what| JournalError::Impossible { what })?;
        let log = Log::create(path, &body(&first)?)?;
        Ok(Self { log, written: Written { entries: vec![first], state, torn: false } })
    }

    /// Opens a journal again to append to it. A last line that was not written to its end is taken away.
    ///
    /// # Errors
    /// [`JournalError`]; the whole lines of the file are as they were then.
    pub fn open(path: &Path) -> Result<Self, JournalError> {
        let (log, lines) = Log::open(path)?;
        let written = understood(path, &lines)?;
        Ok(Self { log, written })
    }

    /// Reads a journal without opening it for writing: another process may be writing it.
    ///
    /// # Errors
    /// [`JournalError::Empty`], [`JournalError::Damaged`], [`JournalError::Io`].
    pub fn read(path: &Path) -> Result<Written, JournalError> {
        understood(path, &Log::read(path)?)
    }

    /// Whether it is open for writing: the wire is being bent, by this program or another.
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
        let state = reading::counted(Some(self.written.state.clone()), &entry.what)
            .map_err(|what| JournalError::Impossible { what })?;
        self.log.add(&body(&entry)?)?;
        self.written.state = state;
        self.written.entries.push(entry);
        Ok(())
    }

    /// What it comes to.
    #[must_use]
    pub const fn state(&self) -> &JournalState {
        &self.written.state
    }

    /// What happened, in order.
    #[must_use]
    pub fn entries(&self) -> &[Entry] {
        &self.written.entries
    }

    #[must_use]
    pub fn path(&self) -> &Path {
        self.log.path()
    }
}

fn understood(path: &Path, lines: &Lines) -> Result<Written, JournalError> {
    let damaged =
        |Wrong { line, what, newer }| JournalError::Damaged { path: path.to_owned(), line, what, newer };
    Written::of(lines).map_err(damaged)
}

fn body(entry: &Entry) -> Result<String, JournalError> {
    serde_json::to_string(entry).map_err(|error| JournalError::Impossible { what: error.to_string() })
}
