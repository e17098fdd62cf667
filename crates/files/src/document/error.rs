//! Why a document cannot be opened, made or saved.

use wirebend_core::mesh::StencilError;
use wirebend_core::wireframe::WireframeError;

/// Why a document cannot be opened, made or saved.
#[derive(Debug, thiserror::Error)]
pub enum DocumentError {
    /// Not the JSON that a document of this version is.
    #[error(
        "{file}, line {line}, column {column}: {message}; if the file was edited by hand, undo that, else take its last good copy"
    )]
    Json {
        /// The file.
        file: String,
        /// From 1.
        line: usize,
        /// From 1.
        column: usize,
        /// What is wrong.
        message: String,
    },
    /// Nothing is in it.
    #[error("{file}: the file is empty, expected {expected}; take its last good copy")]
    Empty {
        /// The file.
        file: String,
        /// What should be in it.
        expected: &'static str,
    },
    /// A document of another kind.
    #[error("{file}: this is a \"{found}\" file, expected \"{expected}\"; open it as what it is")]
    WrongFormat {
        /// The file.
        file: String,
        /// What it says it is.
        found: String,
        /// What it should be.
        expected: &'static str,
    },
    /// Made by a later version of the program.
    #[error(
        "{file}: its version {version} is newer than {known}, the newest known here; update the program to open it"
    )]
    Newer {
        /// The file.
        file: String,
        /// Its version.
        version: u64,
        /// The newest that can be read.
        known: u64,
    },
    /// A version that never was.
    #[error(
        "{file}: there is no version {version} of this format; the file is damaged, take its last good copy"
    )]
    NoSuchVersion {
        /// The file.
        file: String,
        /// What it says.
        version: u64,
    },
    /// A job that is not what was hashed.
    #[error(
        "{file}: the job was changed after it was made, its hash does not fit; plan the design again to get a new job"
    )]
    Changed {
        /// The file.
        file: String,
    },
    /// A vertex or an edge that cannot be.
    #[error("{file}: {error}; take the last good copy of the file")]
    Wireframe {
        /// The file.
        file: String,
        /// What is wrong.
        error: WireframeError,
    },
    /// Something points at a vertex or an edge that is not there.
    #[error(
        "{file}: \"{key}\" names {target}, which is not in the wireframe; take the last good copy of the file"
    )]
    Dangling {
        /// The file.
        file: String,
        /// The key.
        key: &'static str,
        /// What it names.
        target: String,
    },
    /// The embedded stencil cannot be unpacked.
    #[error("{file}: the embedded stencil is damaged: {message}; import the model again")]
    StencilDamaged {
        /// The file.
        file: String,
        /// What is wrong.
        message: String,
    },
    /// The embedded stencil is no mesh.
    #[error("{file}: {error}; import the model again")]
    Stencil {
        /// The file.
        file: String,
        /// What is wrong.
        error: StencilError,
    },
    /// A number of a job is NaN or infinite.
    #[error("a job cannot hold the number {value} ({key}); it must be finite")]
    NotFinite {
        /// Where.
        key: &'static str,
        /// The number.
        value: f64,
    },
    /// The stages of a wire of a job do not fit each other.
    #[error("wire {} of the job does not fit together: {what}; plan the design again to get a new job", .wire + 1)]
    Inconsistent {
        /// Index of the wire, from 0.
        wire: usize,
        /// What holds in every job.
        what: &'static str,
    },
    /// JSON could not be written.
    #[error("the document cannot be written: {0}")]
    Write(serde_json::Error),
    /// The operating system refused to save.
    #[error(
        "{path} cannot be saved: {error}; the file there, if any, is untouched. Check the folder and the space on the disk"
    )]
    Save {
        /// The file.
        path: String,
        /// What the system says.
        error: std::io::Error,
    },
}

impl DocumentError {
    /// A name for the kind of error that does not change with its wording.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Json { .. } => "document-json",
            Self::Empty { .. } => "document-empty",
            Self::WrongFormat { .. } => "document-wrong-format",
            Self::Newer { .. } => "document-newer",
            Self::NoSuchVersion { .. } => "document-no-such-version",
            Self::Changed { .. } => "document-changed",
            Self::Wireframe { .. } => "document-wireframe",
            Self::Dangling { .. } => "document-dangling",
            Self::StencilDamaged { .. } => "document-stencil-damaged",
            Self::Stencil { .. } => "document-stencil",
            Self::NotFinite { .. } => "document-not-finite",
            Self::Inconsistent { .. } => "document-inconsistent",
            Self::Write(_) => "document-write",
            Self::Save { .. } => "document-save",
        }
    }

    /// The line that is wrong, from 1, where there is one.
    #[must_use]
    pub fn line(&self) -> Option<usize> {
        if let Self::Json { line, .. } = self { Some(*line) } else { None }
    }
}
