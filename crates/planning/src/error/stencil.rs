//! Why the stencil of a design is not here.

use wirebend_files::read::ReadError;

/// Why the stencil that a design has in a file of its own is not here.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StencilFileError {
    /// The file cannot be read.
    #[error(transparent)]
    Read(#[from] ReadError),
    /// It has no faces.
    #[error("{file} has no surface")]
    NoSurface { file: String },
    /// The design comes from no folder.
    #[error("{path} is beside a file, and this design comes from none")]
    NoFolder {
        /// As the design says.
        path: String,
    },
    /// It is not beside the design.
    #[error("{path} leads out of the folder of the design, and a design reads nothing there")]
    Outside {
        /// As the design says.
        path: String,
    },
}
