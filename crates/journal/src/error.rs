//! What can be wrong with a log.

use std::io;
use std::path::{Path, PathBuf};

/// Why a log cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum LogError {
    /// There is one already.
    #[error("there is a file {} already", path.display())]
    Exists { path: PathBuf },
    /// Another process has it.
    #[error("{} is in use by another program", path.display())]
    InUse { path: PathBuf },
    /// It has not one whole line.
    #[error("{} has not one whole line", path.display())]
    Empty { path: PathBuf },
    /// A line was changed, or one is missing.
    #[error("line {line} of {} is damaged: {what}", path.display())]
    Damaged {
        path: PathBuf,
        /// Which line, from 1.
        line: usize,
        what: String,
    },
    /// Writing failed before: what is in the file is not sure any more.
    #[error("{} could not be written before", path.display())]
    Broken { path: PathBuf },
    /// The system refuses.
    #[error("{} cannot be {doing}: {cause}", path.display())]
    Io {
        path: PathBuf,
        /// What was tried.
        doing: &'static str,
        cause: io::Error,
    },
}

impl LogError {
    pub(crate) fn io(path: &Path, doing: &'static str, cause: io::Error) -> Self {
        Self::Io { path: path.to_owned(), doing, cause }
    }
}
