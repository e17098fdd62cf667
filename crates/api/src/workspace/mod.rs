//! What a window works with: the open design, what was open before, and the machines. Asked by name, answered with
//! plain values; what it sends unasked goes to a [`EventSink`].
//!
//! Everything that a window may ask is declared once, in [`Ask`]. Its answers are those of the commands where a command
//! does the same.

#![allow(clippy::unnecessary_wraps, clippy::unused_self, reason = "every request has a schema")]

mod about;
mod calibrations;
mod collisions;
mod design;
mod error;
mod examples;
mod exports;
mod frames;
mod latest;
mod look;
mod machines;
mod mesh;
mod operating;
mod predictions;
mod profiles;
mod program;
mod recent;
mod reporter;
mod run_file;
mod sequences;
mod shown;

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, RwLock};

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_files::document::DocumentError;

use crate::{ApiError, Editor, FoundSoFar, Installation, Operator, OperatorEvent, Places};
pub use about::{AboutRequest, AboutResponse};
pub use calibrations::ApplyCalibration;
pub use collisions::{
    AvoidCollisions, AvoidingStopped, CheckCollisions, CollisionsStopped, StopAvoiding, StopCollisions,
};
pub use design::{
    CheckDesign, ClearRecent, CloseDesign, DesignOpened, DiscardUnsaved, EditDesign, EditMade, FixAllRequest,
    FixAllResponse, FixesRequest, FixesResponse, NewDesign, OpenDesign, OpenExample, OutcomeRequest,
    OutcomeResponse, PutStencil, PutWireframe, Redo, RestoreUnsaved, SaveDesign, Start, Started, Undo,
};
pub use error::ApiErrorReport;
pub use examples::{ExampleEntry, ExamplesRequest, ExamplesResponse};
pub use exports::{
    ExportDesign, ExportPreview, ExportsRequest, ExportsResponse, FormatEntry, SaveJob, SaveWireframe,
    SavedJob, SavedWireframe,
};
pub use frames::{
    FrameChoices, FrameChoicesRequest, FrameDesign, FrameShown, FrameStopped, LoadCasesRequest, SaveFrame,
    SavedFrame, StopFrame, ToleranceDesign,
};
use latest::{Latest, LatestByCode};
pub use look::{LookRequest, LookResponse, Seen};
pub use machines::{
    ChangeSettings, CompareDesign, MachineViewRequest, MachineViewResponse, SettingValue, SettingsChanged,
};
pub use operating::{
    AnswerMachine, ByHandRequest, ByHandResponse, ClearRecording, ConnectMachine, MachineNow,
    MachineStateRequest, OrderMachine, Recorded, RecordedRequest, SaveRecording, SavedRecording,
};
pub use predictions::{PredictedDesign, PredictionStopped, StopPrediction};
pub use profiles::{
    CopyProfile, HeadRequest, ImportProfile, NewValue, ProfileView, ProfileViewRequest, RevertProfile,
    SetProfile,
};
pub use program::{MadeRequest, MadeResponse, MadeWire, ProgramRequest, ProgramResponse};
pub use recent::RecentEntry;
pub use run_file::{
    CheckRunFile, CloseRunFile, OpenRunFile, RunFileKind, RunFileNow, RunFileReport, RunFileRequest,
    RunFileWire,
};
pub use sequences::{SequenceDesign, SequenceStopped, StopSequence};
pub use shown::{LengthsShown, ShowLengths, ShownUnit};

/// The machine where none was chosen.
const FIRST_MACHINE: &str = "wirebend-kit";

/// What a workspace sends to its window without being asked.
#[derive(Debug, Clone, Serialize, JsonSchema)]
#[serde(tag = "event", content = "value", rename_all = "kebab-case")]
pub enum WindowEvent {
    /// How far long work is.
    Work(Work),
    /// Something happened at the connected machine.
    Operator(Box<OperatorEvent>),
}

/// Takes the events of a workspace. Called from any thread.
pub trait EventSink: Send + Sync {
    fn emit(&self, event: &WindowEvent);
}

/// How far long work is.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Work {
    /// What was asked for.
    pub ask: String,
    /// A word or two for a person.
    pub stage: String,
    /// So many things are done.
    pub done: u64,
    /// Of so many; 0 where that is not known.
    pub of: u64,
    /// What a search for programs without collisions has found; null where none goes on.
    pub found: Option<FoundSoFar>,
}

/// What a window works with.
pub struct Workspace {
    places: Places,
    installation: RwLock<Arc<Installation>>,
    open: Mutex<Editor>,
    run_file: Mutex<Option<Arc<run_file::RunFile>>>,
    operator: Mutex<Option<Arc<Operator>>>,
    events: Arc<dyn EventSink>,
    collision_checks: Latest,
    clear_searches: Latest,
    fix_all_searches: LatestByCode,
    predictions: Latest,
    sequence_searches: Latest,
    frames: Latest,
}

impl Workspace {
    /// A workspace with an empty design on it.
    ///
    /// # Errors
    /// [`ApiError`] when a shipped profile is damaged.
    pub fn new(places: Places, events: Arc<dyn EventSink>) -> Result<Self, ApiError> {
        let app = places.installation()?;
        let open = empty(&app, &places, None)?;
        let (installation, operator) = (RwLock::new(Arc::new(app)), Mutex::new(None));
        Ok(Self {
            places,
            installation,
            open: Mutex::new(open),
            run_file: Mutex::new(None),
            operator,
            events,
            collision_checks: Latest::default(),
            clear_searches: Latest::default(),
            fix_all_searches: LatestByCode::default(),
            predictions: Latest::default(),
            sequence_searches: Latest::default(),
            frames: Latest::default(),
        })
    }

    /// The profiles and drivers as they were when they were last read.
    pub(crate) fn installation(&self) -> Arc<Installation> {
        Arc::clone(&self.installation.read().unwrap_or_else(PoisonError::into_inner))
    }

    /// Reads profiles and drivers again.
    pub(crate) fn reload(&self) -> Result<(), ApiError> {
        let app = Arc::new(self.places.installation()?.with_boards_of(&self.installation()));
        *self.installation.write().unwrap_or_else(PoisonError::into_inner) = app;
        // What it knows of its machine is of before.
        self.open().forget_setup();
        Ok(())
    }

    /// The open design. A change is made whole or not at all, so that nothing is left half done where a thread died.
    pub(crate) fn open(&self) -> MutexGuard<'_, Editor> {
        self.open.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The program ends: what moves is stopped, and the port closed. What no file has is offered at the next start.
    pub fn leave(&self) {
        self.collision_checks.begin();
        self.clear_searches.begin();
        self.fix_all_searches.stop();
        self.predictions.begin();
        self.sequence_searches.begin();
        self.frames.begin();
        self.let_go();
        self.open().leave();
    }

    pub(crate) fn emit(&self, event: &WindowEvent) {
        self.events.emit(event);
    }

    pub(crate) const fn places(&self) -> &Places {
        &self.places
    }

    fn keep_in(&self) -> Option<PathBuf> {
        keep_in(&self.places)
    }
}

/// Where changes that no file has are kept.
fn keep_in(places: &Places) -> Option<PathBuf> {
    places.state.as_ref().map(|state| state.join("unsaved"))
}

/// An empty design for a machine, or for the first one where there is none of that name.
fn empty(app: &Installation, places: &Places, machine: Option<String>) -> Result<Editor, ApiError> {
    let known = machine.filter(|machine| app.machine_ids().contains(machine));
    let machine = known.or_else(|| first_machine(app, places));
    let keep_in = keep_in(places);
    // A machine that cannot be used is seen where machines are chosen.
    let editor = Editor::new(app, machine.as_deref(), keep_in.as_deref())
        .or_else(|_| Editor::new(app, None, keep_in.as_deref()));
    Ok(editor?)
}

/// The machine of the first design: the one that was chosen last, else the one that this program has the firmware of.
fn first_machine(app: &Installation, places: &Places) -> Option<String> {
    let ids = app.machine_ids();
    let known = |id: String| ids.contains(&id).then_some(id);
    let last = recent::last_machine(places).and_then(known);
    last.or_else(|| known(FIRST_MACHINE.to_owned())).or_else(|| ids.first().cloned())
}

/// The name of a file without its folder.
fn name_of(file: &Path) -> String {
    file.file_name().map_or_else(|| file.display().to_string(), |name| name.to_string_lossy().into_owned())
}

/// Creates the folder of a file where it is missing.
fn make_folder_of(file: &Path) -> Result<(), ApiError> {
    let Some(folder) = file.parent() else { return Ok(()) };
    std::fs::create_dir_all(folder)
        .map_err(|error| DocumentError::Save { path: folder.display().to_string(), error }.into())
}
