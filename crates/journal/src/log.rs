//! The file.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Duration;

use crate::chain::Chain;
use crate::error::LogError;
use crate::reading::Lines;

/// A process that was just killed may have been starting another, which has its files until it runs.
const PATIENCE: [Duration; 5] = [Duration::from_millis(20); 5];

/// A log that is being written. It is locked: no other process has it at the same time. The lock ends with the
/// process, however that ends.
#[derive(Debug)]
pub struct Log {
    pub(crate) file: File,
    path: PathBuf,
    chain: Chain,
    length: u64,
    broken: bool,
}

impl Log {
    /// Begins a log with its first entry: JSON without an end of line.
    ///
    /// # Errors
    /// [`LogError::Exists`], [`LogError::Io`].
    pub fn create(path: &Path, first: &str) -> Result<Self, LogError> {
        let made = OpenOptions::new().read(true).write(true).create_new(true).open(path);
        let file = made.map_err(|cause| match cause.kind() {
            io::ErrorKind::AlreadyExists => LogError::Exists { path: path.to_owned() },
            _ => LogError::io(path, "made", cause),
        })?;
        lock(&file, path)?;
        let mut log = Self { file, path: path.to_owned(), chain: Chain::default(), length: 0, broken: false };
        log.write(first, File::sync_all)?;
        keep_name(path).map_err(|cause| LogError::io(path, "written", cause))?;
        Ok(log)
    }

    /// Opens a log again to append to it. A last line that was not written to its end is taken away.
    ///
    /// # Errors
    /// [`LogError`]; the file is as it was then.
    pub fn open(path: &Path) -> Result<(Self, Lines), LogError> {
        let failed = |doing| move |cause| LogError::io(path, doing, cause);
        let opened = OpenOptions::new().read(true).write(true).open(path);
        let mut file = opened.map_err(failed("opened"))?;
        lock(&file, path)?;
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).map_err(failed("read"))?;
        let lines = understood(path, &bytes)?;
        let length = lines.length as u64;
        if lines.torn {
            file.set_len(length).and_then(|()| file.sync_all()).map_err(failed("written"))?;
        }
        file.seek(SeekFrom::Start(length)).map_err(failed("read"))?;
        let log = Self { file, path: path.to_owned(), chain: lines.chain.clone(), length, broken: false };
        Ok((log, lines))
    }

    /// Reads a log without opening it for writing: another process may be writing it.
    ///
    /// # Errors
    /// [`LogError::Empty`], [`LogError::Damaged`], [`LogError::Io`].
    pub fn read(path: &Path) -> Result<Lines, LogError> {
        let bytes = fs::read(path).map_err(|cause| LogError::io(path, "read", cause))?;
        understood(path, &bytes)
    }

    /// Whether it is open for writing, in this process or another.
    #[must_use]
    pub fn is_in_use(path: &Path) -> bool {
        let Ok(file) = File::open(path) else { return false };
        // A reader locks writers out only for as long as it reads.
        matches!(file.try_lock_shared(), Err(TryLockError::WouldBlock))
    }

    /// Adds an entry: JSON without an end of line. When this returns it is on the disk.
    ///
    /// # Errors
    /// [`LogError::Io`] when the disk is full or gone: from then on [`LogError::Broken`].
    pub fn add(&mut self, entry: &str) -> Result<(), LogError> {
        if self.broken {
            return Err(LogError::Broken { path: self.path.clone() });
        }
        self.write(entry, File::sync_data)
    }

    fn write(&mut self, entry: &str, sync: fn(&File) -> io::Result<()>) -> Result<(), LogError> {
        debug_assert!(!entry.contains('\n'), "an entry is one line");
        let (line, chain) = self.chain.line(entry);
        self.file.write_all(line.as_bytes()).and_then(|()| sync(&self.file)).map_err(|cause| {
            self.broken = true;
            LogError::io(&self.path, "written", cause)
        })?;
        self.chain = chain;
        self.length += line.len() as u64;
        Ok(())
    }

    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// How many bytes it has.
    #[must_use]
    pub const fn length(&self) -> u64 {
        self.length
    }
}

impl Drop for Log {
    /// Closing alone does not end the lock while a process that was started in the same moment has the file, too.
    fn drop(&mut self) {
        // What cannot be unlocked is unlocked when the process ends.
        let _ = self.file.unlock();
    }
}

fn lock(file: &File, path: &Path) -> Result<(), LogError> {
    let mut patience = PATIENCE.into_iter();
    loop {
        match file.try_lock() {
            Ok(()) => return Ok(()),
            Err(TryLockError::Error(cause)) => return Err(LogError::io(path, "locked", cause)),
            Err(TryLockError::WouldBlock) => match patience.next() {
                Some(moment) => thread::sleep(moment),
                None => return Err(LogError::InUse { path: path.to_owned() }),
            },
        }
    }
}

fn understood(path: &Path, bytes: &[u8]) -> Result<Lines, LogError> {
    Lines::of(bytes).map_err(|unreadable| match unreadable {
        None => LogError::Empty { path: path.to_owned() },
        Some((line, what)) => LogError::Damaged { path: path.to_owned(), line, what },
    })
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
