//! Why something cannot be done to the open design.

use std::io;
use std::path::PathBuf;

use wirebend_core::wireframe::EditError;
use wirebend_files::document::{DocumentError, StaleChange};
use wirebend_journal::LogError;

/// Why something cannot be done to the open design, which is as it was.
#[derive(Debug, thiserror::Error)]
pub enum EditorError {
    /// The edit makes no sense here.
    #[error(transparent)]
    Edit(#[from] EditError),
    /// A mirror without a direction.
    #[error("the normal of the plane has no direction: give one that is not 0 0 0")]
    Normal,
    /// A tolerance that is none.
    #[error("{0} mm is no tolerance: give a length of 0 or more")]
    Tolerance(f64),
    /// A shortest edge that is none.
    #[error("{0} mm is no length of an edge: give the shortest that an arc may be made of, or 0")]
    LeastEdge(f64),
    /// A step that is no angle.
    #[error("{0}° is no step along an arc: give an angle of more than 0° and at most 180°")]
    ArcStep(f64),
    /// A matrix that is no transform.
    #[error("this matrix is no transform: its numbers have to be finite, and its last row 0 0 0 1")]
    Matrix,
    /// An edge that is to be laid twice is not there.
    #[error("there is no edge {0} to lay twice")]
    NoEdge(u32),
    /// The wire is to begin where nothing is.
    #[error("there is no vertex {0} for the wire to begin at")]
    NoVertex(u32),
    /// A change does not fit the design any more.
    #[error("the design has changed meanwhile: {0}")]
    Stale(#[from] StaleChange),
    /// It cannot be opened or written.
    #[error(transparent)]
    Document(#[from] DocumentError),
    /// The journal that keeps unsaved changes.
    #[error("unsaved changes cannot be kept safe: {0}; save the design")]
    Log(#[from] LogError),
    /// A folder or a file of such journals.
    #[error("unsaved changes cannot be kept safe: {}: {cause}", folder.display())]
    Folder {
        /// Which.
        folder: PathBuf,
        /// Why.
        cause: io::Error,
    },
    /// A journal makes no sense.
    #[error("line {line} of {} cannot be understood: {what}; the design cannot be restored from it", path.display())]
    Damaged {
        /// The journal.
        path: PathBuf,
        /// Which line, from 1.
        line: usize,
        /// What is wrong.
        what: String,
    },
    /// A journal of a later program.
    #[error("{} is of version {version}, this program knows {known}: update it to restore the design", path.display())]
    Newer {
        /// The journal.
        path: PathBuf,
        /// Its version.
        version: u32,
        /// The latest that is known.
        known: u32,
    },
    /// A change cannot be written down.
    #[error("the change cannot be written down: {0}")]
    Unwritten(String),
}

impl EditorError {
    /// A name that stays the same while the wording may change.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::Edit(_)
            | Self::Normal
            | Self::Tolerance(_)
            | Self::LeastEdge(_)
            | Self::ArcStep(_)
            | Self::Matrix => "edit",
            Self::NoEdge(_) => "no-edge",
            Self::NoVertex(_) => "no-vertex",
            Self::Stale(_) => "stale",
            Self::Document(_) => "document",
            Self::Log(_) | Self::Folder { .. } | Self::Unwritten(_) => "not-kept",
            Self::Damaged { .. } => "journal-damaged",
            Self::Newer { .. } => "journal-newer",
        }
    }
}
