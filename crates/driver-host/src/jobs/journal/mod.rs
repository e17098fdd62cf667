//! The journal of a wire: a file to which lines are only added, each on the disk before anything else happens.

mod entry;
mod line;
mod reading;
#[cfg(test)]
mod tests;

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Duration;

use super::account::Account;
pub use entry::{Entry, Heading, What};
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
    #[error("the journal {} is in use: another program makes this wire; close it first", path.display())]
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

/// A journal that is being written. It is locked: no other process has it at the same time. The lock ends with
/// the process, however that ends.
#[derive(Debug)]
pub struct Journal {
    file: File,
    path: PathBuf,
    written: Written,
    broken: bool,
}

impl Journal {
    /// Begins a journal. `at` is the time of day as people shall read it.
    ///
    /// # Errors
    /// [`JournalError::Exists`], [`JournalError::Io`].
    pub fn create(path: &Path, heading: Heading, at: String) -> Result<Self, JournalError> {
        let failed = |doing| move |cause| io_error(path, doing, cause);
        let made = OpenOptions::new().read(true).write(true).create_new(true).open(path);
        let file = made.map_err(|cause| match cause.kind() {
            io::ErrorKind::AlreadyExists => JournalError::Exists { path: path.to_owned() },
            _ => io_error(path, "made", cause),
        })?;
        lock(&file, path)?;
        let heading = Heading { version: entry::VERSION, ..heading };
        let first = Entry { at, what: What::Job(heading) };
        let account = counted_first(&first)?;
        let (line, chain) = line::Chain::default().line(&body(&first)?);
        let mut file = file;
        file.write_all(line.as_bytes()).and_then(|()| file.sync_all()).map_err(failed("written"))?;
        keep_name(path).map_err(failed("written"))?;
        let written = Written { entries: vec![first], account, torn: false, chain, length: line.len() };
        Ok(Self { file, path: path.to_owned(), written, broken: false })
    }

    /// Takes a journal up again. A last line that was not written to its end is taken away.
    ///
    /// # Errors
    /// [`JournalError`]; the file is as it was then.
    pub fn open(path: &Path) -> Result<Self, JournalError> {
        let failed = |doing| move |cause| io_error(path, doing, cause);
        let opened = OpenOptions::new().read(true).write(true).open(path);
        let mut file = opened.map_err(failed("opened"))?;
        lock(&file, path)?;
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).map_err(failed("read"))?;
        let written = understood(path, &bytes)?;
        let length = written.length as u64;
        if written.torn {
            file.set_len(length).and_then(|()| file.sync_all()).map_err(failed("written"))?;
        }
        file.seek(SeekFrom::Start(length)).map_err(failed("read"))?;
        Ok(Self { file, path: path.to_owned(), written, broken: false })
    }

    /// Reads a journal without taking it up: another process may be writing it.
    ///
    /// # Errors
    /// [`JournalError::Empty`], [`JournalError::Damaged`], [`JournalError::Io`].
    pub fn read(path: &Path) -> Result<Written, JournalError> {
        let bytes = fs::read(path).map_err(|cause| io_error(path, "read", cause))?;
        understood(path, &bytes)
    }

    /// Adds an entry. When this returns it is on the disk.
    ///
    /// # Errors
    /// [`JournalError::Impossible`] when it contradicts what is there: nothing is written. [`JournalError::Io`]
    /// when the disk is full or gone: from then on [`JournalError::Broken`].
    pub fn add(&mut self, entry: Entry) -> Result<(), JournalError> {
        if self.broken {
            return Err(JournalError::Broken { path: self.path.clone() });
        }
        let account = reading::counted(Some(self.written.account.clone()), &entry.what)
            .map_err(|what| JournalError::Impossible { what })?;
        let (line, chain) = self.written.chain.line(&body(&entry)?);
        let done = self.file.write_all(line.as_bytes()).and_then(|()| self.file.sync_data());
        done.map_err(|cause| {
            self.broken = true;
            io_error(&self.path, "written", cause)
        })?;
        self.written.account = account;
        self.written.chain = chain;
        self.written.length += line.len();
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
        &self.path
    }
}

impl Drop for Journal {
    /// Closing alone does not end the lock while a process that was started in the same moment has the file, too.
    fn drop(&mut self) {
        // What cannot be unlocked is unlocked when the process ends.
        let _ = self.file.unlock();
    }
}

/// A process that was just killed may have been starting another, which has its files until it runs.
const PATIENCE: [Duration; 5] = [Duration::from_millis(20); 5];

fn lock(file: &File, path: &Path) -> Result<(), JournalError> {
    let mut patience = PATIENCE.into_iter();
    loop {
        match file.try_lock() {
            Ok(()) => return Ok(()),
            Err(TryLockError::Error(cause)) => return Err(io_error(path, "locked", cause)),
            Err(TryLockError::WouldBlock) => match patience.next() {
                Some(moment) => thread::sleep(moment),
                None => return Err(JournalError::InUse { path: path.to_owned() }),
            },
        }
    }
}

fn understood(path: &Path, bytes: &[u8]) -> Result<Written, JournalError> {
    reading::read(bytes).map_err(|unreadable| match unreadable {
        None => JournalError::Empty { path: path.to_owned() },
        Some((line, what)) => JournalError::Damaged { path: path.to_owned(), line, what },
    })
}

fn counted_first(first: &Entry) -> Result<Account, JournalError> {
    reading::counted(None, &first.what).map_err(|what| JournalError::Impossible { what })
}

fn body(entry: &Entry) -> Result<String, JournalError> {
    serde_json::to_string(entry).map_err(|error| JournalError::Impossible { what: error.to_string() })
}

fn io_error(path: &Path, doing: &'static str, cause: io::Error) -> JournalError {
    JournalError::Io { path: path.to_owned(), doing, cause }
}

/// A file whose name is lost in a power cut is lost itself.
fn keep_name(path: &Path) -> io::Result<()> {
    #[cfg(unix)]
    if let Some(folder) = path.parent() {
        let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
        File::open(folder)?.sync_all()?;
    }
    #[cfg(not(unix))]
    let _ = path; // other systems do not let a folder be written out
    Ok(())
}
