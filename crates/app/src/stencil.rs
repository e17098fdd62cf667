//! The stencil of a document that has it in a file of its own.

use std::path::Path;

use wirebend_core::mesh::Stencil;
use wirebend_files::document::{StencilSource, sha256_hex};
use wirebend_files::read::{ReadError, ReadOptions, read, read_file};

use crate::design::{DesignInput, Input, Opened};
use crate::output::file_name;
use crate::report::NoteReport;

/// Why a stencil is not here.
#[derive(Debug, thiserror::Error)]
enum FetchError {
    #[error(transparent)]
    Read(#[from] ReadError),
    #[error("{file} has no surface")]
    NoSurface { file: String },
    #[error("{path} is beside a file, and this design comes from none")]
    NoFolder { path: String },
}

impl Opened {
    /// The design with its stencil, which is read from the file where the document has it: what a person traces on is seen, and
    /// stays with the design wherever that is saved. What hinders that is told, and the document goes on to name the file.
    pub fn with_stencil(mut self, input: &DesignInput) -> Self {
        let Some(StencilSource::File { path, sha256 }) = &self.document.stencil else { return self };
        let (code, message) = match fetch(path, sha256, input) {
            Ok((surface, as_it_was)) => {
                let note = if as_it_was {
                    (
                        "stencil-read",
                        format!("the stencil is read from {path}: saving puts it into the design"),
                    )
                } else {
                    let advice = "look whether the wires still lie on it";
                    (
                        "stencil-changed",
                        format!("the stencil {path} has changed since the design was saved: {advice}"),
                    )
                };
                let name = file_name(Path::new(path));
                self.document.stencil = Some(StencilSource::Embedded { surface, name });
                note
            }
            Err(error) => {
                let advice = "put the file back and open the design again, or open another stencil";
                ("stencil-missing", format!("the stencil is not shown: {error}; {advice}"))
            }
        };
        self.notes.push(NoteReport { code: code.into(), count: 1, message });
        self
    }
}

/// The surface, and whether its file is the one that the document means.
fn fetch(path: &str, sha256: &str, input: &DesignInput) -> Result<(Stencil, bool), FetchError> {
    let folder = match &input.input {
        Input::File(document) => document.parent(),
        Input::Bytes { .. } => None,
    };
    let file = folder.ok_or_else(|| FetchError::NoFolder { path: path.to_owned() })?.join(path);
    let (name, bytes) = (file.display().to_string(), read_file(&file)?);
    let surface = read(&bytes, &name, None, &ReadOptions::default())?.stencil;
    let surface = surface.ok_or(FetchError::NoSurface { file: name })?;
    Ok((surface, sha256_hex(&bytes) == sha256))
}
