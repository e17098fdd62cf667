//! Stencils that a document has in files of their own.

use std::path::{Component, Path};
use std::sync::Arc;

use wirebend_core::mesh::Stencil;
use wirebend_files::document::{PlacedStencil, StencilId, StencilSource, sha256_hex};
use wirebend_files::read::{ReadOptions, read, read_file};

use crate::design::{DesignInput, Opened};
use crate::error::StencilFileError;
use crate::output::file_name;
use crate::report::NoteReport;

impl Opened {
    /// The design with its stencils. Without one of them it is the same design: what hinders is reported, and the document still names the
    /// file.
    #[must_use]
    pub fn with_stencils(mut self, input: &DesignInput) -> Self {
        for id in self.stencils_in_files() {
            if let Err(error) = self.fetch_stencil(id, input) {
                let advice = "put it beside the design and open that again, or open another stencil";
                self.note("stencil-missing", format!("the stencil is not shown: {error}; {advice}"));
            }
        }
        self
    }

    /// Reads the stencils into the document from the files where that has them: what a person traces on stays with the design wherever it is
    /// saved.
    pub fn fetch_stencils(&mut self, input: &DesignInput) -> Result<(), StencilFileError> {
        self.stencils_in_files().into_iter().try_for_each(|id| self.fetch_stencil(id, input))
    }

    fn stencils_in_files(&self) -> Vec<StencilId> {
        let surfaces = self.document.surfaces.iter();
        surfaces.filter(|(_, surface)| surface.embedded().is_none()).map(|(id, _)| *id).collect()
    }

    fn fetch_stencil(&mut self, id: StencilId, input: &DesignInput) -> Result<(), StencilFileError> {
        let Some(StencilSource::File { path, sha256 }) = self.document.surfaces.get(&id) else {
            return Ok(());
        };
        let (surface, as_it_was) = fetch(path, sha256, input)?;
        let name = file_name(Path::new(path));
        if as_it_was {
            self.note(
                "stencil-read",
                format!("the stencil is read from {name}: saving puts it into the design"),
            );
        } else {
            let advice = "look whether the wires still lie on it";
            self.note(
                "stencil-changed",
                format!("the stencil {name} has changed since the design was saved: {advice}"),
            );
        }
        self.document.surfaces.insert(id, StencilSource::Embedded(Arc::new(surface)));
        let unnamed = |stencil: &&mut PlacedStencil| stencil.id == id && stencil.look.name.is_empty();
        if let Some(stencil) = self.document.stencils.iter_mut().find(unnamed) {
            stencil.look.name = name;
        }
        Ok(())
    }

    fn note(&mut self, code: &'static str, message: String) {
        self.notes.push(NoteReport { code: code.into(), count: 1, message, remedies: Vec::new() });
    }
}

/// The surface, and whether its file is the one that the document means. A user who passes a design on says nothing about what others keep
/// elsewhere: only what is beside it is read.
fn fetch(path: &str, sha256: &str, input: &DesignInput) -> Result<(Stencil, bool), StencilFileError> {
    let folder = input.input.folder();
    let within = |part| matches!(part, Component::Normal(_) | Component::CurDir);
    if !Path::new(path).components().all(within) {
        return Err(StencilFileError::Outside { path: path.to_owned() });
    }
    let file = folder.ok_or_else(|| StencilFileError::NoFolder { path: path.to_owned() })?.join(path);
    let (name, bytes) = (file.display().to_string(), read_file(&file)?);
    let options = ReadOptions { folder: file.parent().map(Path::to_owned), ..ReadOptions::default() };
    let surface = read(&bytes, &name, None, &options)?.stencil;
    let surface = surface.ok_or(StencilFileError::NoSurface { file: name })?;
    Ok((surface, sha256_hex(&bytes) == sha256))
}
