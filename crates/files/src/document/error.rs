//! Why a document cannot be opened, made or saved.

use wirebend_core::mesh::{PlacementError, StencilError};
use wirebend_core::wireframe::WireframeError;
use wirebend_error::{ErrorCode, ErrorRemedy};

use super::ids::StencilId;

/// Why a document cannot be opened, made or saved.
#[derive(Debug, thiserror::Error)]
pub enum DocumentError {
    /// Not the JSON that a document of this version is.
    #[error("{file}, line {line}, column {column}: {message}")]
    Json {
        file: String,
        /// From 1.
        line: usize,
        /// From 1.
        column: usize,
        message: String,
    },
    /// Nothing is in it.
    #[error("{file}: the file is empty, expected {expected}")]
    Empty {
        file: String,
        /// What should be in it.
        expected: &'static str,
    },
    /// A document of another kind.
    #[error("{file}: this is a \"{found}\" file, expected \"{expected}\"")]
    WrongFormat {
        file: String,
        found: String,
        /// What it should be.
        expected: &'static str,
    },
    /// Written by a later version of the program.
    #[error("{file}: its version {version} is newer than {known}, the newest known here")]
    Newer {
        file: String,
        version: u64,
        /// The newest that can be read.
        known: u64,
    },
    /// A version that never was.
    #[error("{file}: there is no version {version} of this format: the file is damaged")]
    NoSuchVersion { file: String, version: u64 },
    /// A job that is not what was hashed.
    #[error("{file}: the job was changed after it was made, its hash does not fit")]
    Changed { file: String },
    /// A vertex or an edge that cannot be.
    #[error("{file}: {error}")]
    Wireframe { file: String, error: WireframeError },
    /// Something points at a vertex or an edge that is not there.
    #[error("{file}: \"{key}\" names {target}, which is not in the wireframe")]
    Dangling {
        file: String,
        key: &'static str,
        /// What it names.
        target: String,
    },
    /// One wire that ends where it starts, and several wires.
    #[error("{file}: \"closed\" is for one wire, and \"wires\" is {wires}")]
    ClosedWires {
        file: String,
        /// How many there may be.
        wires: usize,
    },
    /// The embedded stencil cannot be unpacked.
    #[error("{file}: the embedded stencil is damaged: {message}")]
    StencilDamaged { file: String, message: String },
    /// The embedded stencil is no mesh.
    #[error("{file}: {error}")]
    Stencil { file: String, error: StencilError },
    /// A stencil lies nowhere.
    #[error("{file}: stencil {}: {error}", .stencil.0)]
    StencilPlacement { file: String, stencil: StencilId, error: PlacementError },
    /// Two stencils of one id.
    #[error("{file}: two stencils have the id {}", .stencil.0)]
    SameStencil { file: String, stencil: StencilId },
    /// A list of stencils, and one that is in no list.
    #[error("{file}: it has \"stencil\" and \"stencils\"; a document has one of these keys")]
    TwoStencilKeys { file: String },
    /// A number of a job is NaN or infinite.
    #[error("a job cannot hold the number {value} ({key}): it must be finite")]
    NotFinite { key: &'static str, value: f64 },
    /// The stages of a wire of a job do not fit each other.
    #[error("wire {} of the job does not fit together: {what}", .wire + 1)]
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
    #[error("{path} cannot be saved: {error}; the file there, if any, is untouched")]
    Save {
        path: String,
        /// What the system says.
        error: std::io::Error,
    },
}

impl DocumentError {
    /// A name for the kind of error that does not change with its wording.
    #[must_use]
    pub fn code(&self) -> ErrorCode {
        match self {
            Self::Json { .. } => ErrorCode::DocumentJson,
            Self::Empty { .. } => ErrorCode::DocumentEmpty,
            Self::WrongFormat { .. } => ErrorCode::DocumentWrongFormat,
            Self::Newer { .. } => ErrorCode::DocumentNewer,
            Self::NoSuchVersion { .. } => ErrorCode::DocumentNoSuchVersion,
            Self::Changed { .. } => ErrorCode::DocumentChanged,
            Self::Wireframe { .. } => ErrorCode::DocumentWireframe,
            Self::Dangling { .. } => ErrorCode::DocumentDangling,
            Self::ClosedWires { .. } => ErrorCode::DocumentClosedWires,
            Self::StencilDamaged { .. } => ErrorCode::DocumentStencilDamaged,
            Self::Stencil { .. } => ErrorCode::DocumentStencil,
            Self::StencilPlacement { .. } | Self::SameStencil { .. } | Self::TwoStencilKeys { .. } => {
                ErrorCode::DocumentStencils
            }
            Self::NotFinite { .. } => ErrorCode::DocumentNotFinite,
            Self::Inconsistent { .. } => ErrorCode::DocumentInconsistent,
            Self::Write(_) => ErrorCode::DocumentWrite,
            Self::Save { .. } => ErrorCode::DocumentSave,
        }
    }

    /// What can be done about it.
    #[must_use]
    pub fn remedies(&self) -> Vec<ErrorRemedy> {
        vec![match self {
            Self::Json { .. }
            | Self::Empty { .. }
            | Self::NoSuchVersion { .. }
            | Self::Wireframe { .. }
            | Self::Dangling { .. }
            | Self::ClosedWires { .. }
            | Self::StencilPlacement { .. }
            | Self::SameStencil { .. }
            | Self::TwoStencilKeys { .. } => ErrorRemedy::UseLastCopy,
            Self::WrongFormat { .. } => ErrorRemedy::OpenAsItIs,
            Self::Newer { .. } => ErrorRemedy::UpdateProgram,
            Self::Changed { .. } | Self::Inconsistent { .. } => ErrorRemedy::PlanAgain,
            Self::StencilDamaged { .. } | Self::Stencil { .. } => ErrorRemedy::ImportAgain,
            Self::Save { .. } => ErrorRemedy::CheckDisk,
            Self::NotFinite { .. } | Self::Write(_) => return Vec::new(),
        }]
    }

    /// The line that is wrong, from 1, where there is one.
    #[must_use]
    pub fn line(&self) -> Option<usize> {
        if let Self::Json { line, .. } = self { Some(*line) } else { None }
    }
}
