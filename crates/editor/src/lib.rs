//! The open design: what a person works on, its history, and the journal by which it outlives the program.
//!
//! A front end draws [`Editor::view`], sends an [`EditRequest`] when a person has done something, and asks
//! [`Editor::check`] while they are dragging. Every change is on the disk before it is answered, or the answer says that
//! it is not.

#![allow(clippy::missing_errors_doc, clippy::must_use_candidate, reason = "not published")]

mod changing;
mod check;
mod collisions;
mod construction;
mod edit_journal;
mod error;
mod figures;
mod fixes;
mod history;
mod outcome;
mod plane;
mod request;
mod resolving;
mod view;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use wirebend_core::wireframe::Wireframe;
use wirebend_error::ProblemReport;
use wirebend_files::document::{Document, DocumentChange, StencilSource, save_atomically};

pub use check::{LiveCheck, Moved, WireFigures};
pub use collisions::CollisionCheck;
use edit_journal::EditJournal;
pub use edit_journal::Unsaved;
pub use error::EditorError;
pub use fixes::{AvoidedCollisions, Fix, FixAll, FixChange, FixPreview, HelpFix, SearchSettings};
use history::{Done, History};
pub use outcome::{EditOutcome, FilletPart};
pub use plane::{AxisName, OwnPlane, PlaneName};
pub use request::{
    ChosenWalk, ConstructionChange, EditRequest, MergePlace, PastedVertex, Placed, PolygonMeasure, RestPlace,
};
pub use view::{DesignState, DesignView, EdgeView, PauseView, VertexView, ViewChange};

use wirebend_planning::design::{DesignInput, FoundStencil, Opened};
use wirebend_planning::machine::Setup;
use wirebend_planning::output::file_name;
use wirebend_planning::report::NoteReport;
use wirebend_planning::{Installation, PlanChoices, Progress};

/// A machine, and the wire in it unless it is the machine's own.
type Names = (String, Option<String>);

/// What a new design is called.
const UNTITLED: &str = "untitled";

/// The open design.
#[derive(Debug)]
pub struct Editor {
    document: Document,
    history: History,
    /// The file that it was opened from or saved to.
    file: Option<PathBuf>,
    name: String,
    /// The state that the file has.
    saved: u64,
    /// The folder for the journal, if one was named.
    keep_in: Option<PathBuf>,
    edit_journal: Option<EditJournal>,
    /// Machine and material as the stages want them, and by which names they were asked for.
    setup: Option<(Names, Setup)>,
    /// Why changes are not kept safe any more.
    unkept: Option<ProblemReport>,
}

impl Editor {
    /// An empty design for a machine. Unsaved changes are kept in a folder, if one is given; where that cannot be written,
    /// [`DesignState::unkept`] says so.
    ///
    /// # Errors
    /// [`EditorError`] when there is no such machine.
    pub fn new(
        app: &Installation,
        machine: Option<&str>,
        keep_in: Option<&Path>,
    ) -> Result<Self, EditorError> {
        let mut document = Document::new(Wireframe::new());
        if let Some(machine) = machine {
            let setup = app.setup(machine, None)?;
            (document.machine, document.material) = changing::snapshots(&setup)?;
        }
        Ok(Self::begin(document, None, UNTITLED.to_owned(), keep_in))
    }

    /// Opens a design: a `.wirebend` document, or any file that can be read. What was merged, ignored or assumed is
    /// told.
    ///
    /// # Errors
    /// [`EditorError`] when it cannot be read.
    pub fn open(
        input: &DesignInput,
        keep_in: Option<&Path>,
        progress: &dyn Progress,
    ) -> Result<(Self, Vec<NoteReport>), EditorError> {
        let opened = input.open(progress)?;
        opened.require_designed()?;
        Ok(Self::begun_with(opened.with_stencils(input), input, None, keep_in))
    }

    /// The same for a machine and a material, where the file names none, and by another name than the file's, if one is
    /// given.
    ///
    /// # Errors
    /// As [`Editor::open`], and when there is no such machine or material.
    pub fn open_for(
        app: &Installation,
        input: &DesignInput,
        machine: Option<(&str, Option<&str>)>,
        called: Option<&str>,
        keep_in: Option<&Path>,
        progress: &dyn Progress,
    ) -> Result<(Self, Vec<NoteReport>), EditorError> {
        let choices = machine.map_or_else(PlanChoices::default, |(machine, material)| PlanChoices {
            machine: Some(machine.to_owned()),
            material: material.map(str::to_owned),
            ..PlanChoices::default()
        });
        let mut opened = input.open_with(app, &choices, progress)?.with_stencils(input);
        if machine.is_some() && opened.document.machine.is_none() {
            let setup = app.maker_of(&opened, &choices)?;
            opened = opened.turned_back(&setup)?;
            (opened.document.machine, opened.document.material) = changing::snapshots(&setup)?;
        }
        opened.require_designed()?;
        Ok(Self::begun_with(opened, input, called, keep_in))
    }

    fn begun_with(
        opened: Opened,
        input: &DesignInput,
        called: Option<&str>,
        keep_in: Option<&Path>,
    ) -> (Self, Vec<NoteReport>) {
        let own = opened.format == wirebend_files::read::Format::Wirebend;
        let path = match &input.input {
            wirebend_planning::Input::File(path) => Some(path.clone()),
            wirebend_planning::Input::Bytes { .. } => None,
        };
        let of_file = || path.as_deref().map_or(opened.name, file_name);
        let name = called.map_or_else(of_file, str::to_owned);
        // What was imported has no document of its own yet.
        (Self::begin(opened.document, path.filter(|_| own), name, keep_in), opened.notes)
    }

    /// Restores a design that was open when the program or the computer stopped.
    ///
    /// # Errors
    /// [`EditorError`] when its journal is damaged or in use.
    pub fn restore(journal: &Path) -> Result<Self, EditorError> {
        let (edit_journal, restored) = EditJournal::reopen(journal)?;
        let edit_journal::Restored { document, history, file, name, saved, .. } = restored;
        let (keep_in, edit_journal) = (edit_journal.folder().map(Path::to_owned), Some(edit_journal));
        Ok(Self { document, history, file, name, saved, keep_in, edit_journal, setup: None, unkept: None })
    }

    /// The designs in a folder that no file has, last changed first; and what could not be read of it.
    #[must_use]
    pub fn unsaved(folder: &Path) -> (Vec<Unsaved>, Vec<ProblemReport>) {
        edit_journal::unsaved(folder)
    }

    fn begin(document: Document, file: Option<PathBuf>, name: String, keep_in: Option<&Path>) -> Self {
        let (history, keep_in) = (History::default(), keep_in.map(Path::to_owned));
        let (setup, edit_journal, unkept) = (None, None, None);
        let mut editor =
            Self { document, history, file, name, saved: 0, keep_in, edit_journal, setup, unkept };
        editor.begin_keeping();
        editor
    }

    /// Begins the journal with the design as it is.
    fn begin_keeping(&mut self) {
        let Some(folder) = &self.keep_in else { return };
        let begun = EditJournal::begin(
            folder,
            &self.document,
            self.file.as_deref(),
            &self.name,
            self.history.is_empty(),
        );
        (self.edit_journal, self.unkept) = match begun {
            Ok(edit_journal) => (Some(edit_journal), None),
            // What cannot be kept safe can be worked on anyway.
            Err(error) => {
                tracing::error!("{error}");
                (None, Some(ProblemReport::from(&error)))
            }
        };
    }

    /// Makes a change, and reports what is to be drawn anew. A request that changes nothing is no change.
    ///
    /// # Errors
    /// [`EditorError`]; the design is as it was.
    pub fn edit(&mut self, app: &Installation, request: &EditRequest) -> Result<ViewChange, EditorError> {
        let Some(change) =
            changing::change(&self.document, app, request)?.filter(|change| !change.is_empty())
        else {
            return Ok(self.changed(&changing::unchanged(&self.document)));
        };
        self.make(request.label(), change)
    }

    fn make(&mut self, label: String, change: DocumentChange) -> Result<ViewChange, EditorError> {
        let done = Done { label, change };
        self.history.make(&mut self.document, done.clone())?;
        self.keep(|edit_journal| edit_journal.done(&done));
        Ok(self.changed(&done.change))
    }

    /// Undoes the last change; none where there is nothing to undo.
    ///
    /// # Errors
    /// [`EditorError::Stale`], which a history of its own does not bring about.
    pub fn undo(&mut self) -> Result<Option<ViewChange>, EditorError> {
        let label = self.history.undo_label().unwrap_or_default().to_owned();
        let Some(change) = self.history.undo(&mut self.document)? else { return Ok(None) };
        let done = Done { label, change };
        self.keep(|edit_journal| edit_journal.undone(&done));
        Ok(Some(self.changed(&done.change)))
    }

    /// Does again what was undone last; none where nothing was.
    ///
    /// # Errors
    /// [`EditorError::Stale`], which a history of its own does not bring about.
    pub fn redo(&mut self) -> Result<Option<ViewChange>, EditorError> {
        let label = self.history.redo_label().unwrap_or_default().to_owned();
        let Some(change) = self.history.redo(&mut self.document)? else { return Ok(None) };
        let done = Done { label, change };
        self.keep(|edit_journal| edit_journal.redone(&done));
        Ok(Some(self.changed(&done.change)))
    }

    /// Writes the `.wirebend` document, whole or not at all: to a file, or to the one that it has. Where changes were not
    /// kept safe any more, they are from here on, if that can be done again.
    ///
    /// # Errors
    /// [`EditorError::NoFile`] where it has none and none is named, [`EditorError::Document`] when it cannot be written.
    pub fn save(&mut self, file: Option<&Path>) -> Result<PathBuf, EditorError> {
        let path = file.map(Path::to_owned).or_else(|| self.file.clone()).ok_or(EditorError::NoFile)?;
        save_atomically(&path, &self.document.to_bytes()?)?;
        (self.name, self.saved, self.file) = (file_name(&path), self.history.state(), Some(path.clone()));
        if self.unkept.is_none() {
            self.keep(|edit_journal| edit_journal.saved(&path));
        }
        if self.unkept.is_some() {
            // All that the old one has the file has, too.
            self.end_keeping();
            self.begin_keeping();
        }
        Ok(path)
    }

    /// Puts a surface into the design to trace on, beside those that it has.
    ///
    /// # Errors
    /// [`EditorError::Stale`], which a history of its own does not bring about.
    pub fn put_stencil(&mut self, stencil: FoundStencil) -> Result<ViewChange, EditorError> {
        let surface = StencilSource::Embedded(Arc::new(stencil.surface));
        self.make("add stencil".to_owned(), self.document.with_stencil(stencil.name, surface))
    }

    /// Profiles have changed: machine and material are looked up anew.
    pub fn forget_setup(&mut self) {
        self.setup = None;
    }

    /// Closes the design. What is not saved is gone: a front end asks before. A journal that cannot be deleted is offered
    /// again, which is reported in the log.
    pub fn close(mut self) {
        self.end_keeping();
    }

    /// The program ends: there is nothing to be offered of a design that is as its file.
    pub fn leave(&mut self) {
        if !self.is_changed() {
            self.end_keeping();
        }
    }

    fn end_keeping(&mut self) {
        if let Some(Err(error)) = self.edit_journal.take().map(EditJournal::end) {
            tracing::warn!("{error}");
        }
    }

    /// Whether there is something that the file has not.
    #[must_use]
    pub fn is_changed(&self) -> bool {
        self.history.state() != self.saved
    }

    /// The design.
    #[must_use]
    pub const fn document(&self) -> &Document {
        &self.document
    }

    /// What cannot be written down has been done anyway: [`DesignState::unkept`] warns a person to save.
    fn keep(&mut self, add: impl FnOnce(&mut EditJournal) -> Result<(), EditorError>) {
        if let Some(Err(error)) = self.edit_journal.as_mut().map(add) {
            tracing::error!("{error}");
            self.unkept = Some(ProblemReport::from(&error));
        }
    }
}
