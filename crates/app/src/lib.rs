//! Every command that a front end may give, declared once.
//!
//! A front end (the command line, the window) makes a [`Request`], hands it to [`App::run`] and
//! shows the [`Response`]. Both are enums without a wildcard to hide behind: a new command does not
//! compile until every front end shows its response. The stages of the pipeline are called from here and
//! nowhere else; the clock, the profiles and the file names are here too.

mod by_hand;
mod catalogue;
mod commands;
mod compare;
mod design;
mod desk;
mod drivers;
mod dump;
mod editor;
mod error;
mod export;
mod import;
mod live;
mod machine;
mod machine_settings;
mod operator;
mod output;
mod picture;
mod places;
mod plan;
mod ports;
mod profile_check;
mod profile_explain;
mod profile_new;
mod profile_springback;
mod program;
mod progress;
mod report;
mod run;
mod runs;
mod simulate;
mod stencil;

pub use by_hand::{JogRequest, JogResponse, Move, MovesFile, ReplayRequest};
pub use catalogue::{
    MachineEntry, MachinesRequest, MachinesResponse, MaterialEntry, MaterialsRequest, MaterialsResponse,
};
pub use commands::{COMMANDS, Request, Response, response_schemas};
pub use compare::{
    Change, CompareRequest, CompareResponse, MachineSide, Objections, OtherSide, WireDiagnostic, WireStep,
};
pub use design::{DesignInput, Input};
pub use desk::*;
pub use drivers::{
    DriverCheckRequest, DriverCheckResponse, DriverEntry, DriverFolders, DriverProblem, DriverState,
    DriverTrustRequest, DriverTrustResponse, DriversRequest, DriversResponse, RuleReport,
};
pub use dump::{DumpRequest, DumpResponse, DumpStage};
pub use editor::{
    DesignState, DesignView, EdgeView, EditRequest, Editor, EditorError, Fix, FixChange, FixPreview,
    LiveCheck, MergePlace, Moved, PastedVertex, Placed, Unsaved, VertexView, ViewChange, WireFigures,
};
pub use error::{AppError, ErrorKind};
pub use export::{ExportFormat, ExportRequest, ExportResponse};
pub use import::{ImportRequest, ImportResponse};
pub use live::{Decided, Decision, Doubt, HeadProblem, LiveProblem, News, PartOfStep};
pub use machine_settings::{MachineSettingsRequest, MachineSettingsResponse};
pub use operator::{
    Answer, ConnectRequest, HeadAsked, MachineState, Operator, OperatorError, OperatorEvent,
    OperatorListener, Order, OrderName, Phase, Question, QuestionKind, Unfinished, WireState,
};
pub use output::Output;
pub use places::Places;
pub use plan::{CheckRequest, CheckResponse, PlanChoices, PlanRequest, PlanResponse};
pub use ports::{PortEntry, PortsRequest, PortsResponse};
pub use profile_check::{FileVerdict, ProfileCheckRequest, ProfileCheckResponse};
pub use profile_explain::{
    AncestorReport, OverriddenReport, ProfileExplainRequest, ProfileExplainResponse, ValueReport,
};
pub use profile_new::{ProfileNewRequest, ProfileNewResponse, ProfilePlace};
pub use profile_springback::{SamplePlace, SpringbackReport, SpringbackSample};
pub use program::ProgramKind;
pub use progress::{NoProgress, Progress, Wait, Wish};
pub use report::{
    CompensatedReport, DiagnosticReport, NoteReport, PlanReport, ProgramReport, RouteReport, SeverityName,
    StepReport, WireReport, WireframeReport, shown_deg,
};
pub use run::{LeftBecause, RunHow, RunOutcome, RunProblem, RunRequest, RunResponse, StoppedIn, WireRun};
pub use runs::{
    Outcome, PartInWire, Record, RunEntry, RunsExportRequest, RunsExportResponse, RunsRequest, RunsResponse,
    RunsShowRequest, RunsShowResponse, ToldBy,
};
pub use simulate::{GapReport, SimulateRequest, SimulateResponse, SimulationModel, VertexReport};
pub use stencil::StencilFileError;

use std::path::PathBuf;

pub use wirebend_driver_host::api::{Capability, DoneBy, SettingCheck, Usb};
pub use wirebend_driver_host::{CHILD_COMMAND, Standstill, StopHandle, StopOutcome, StoppedBy, child_main};
pub use wirebend_files::read::{Format, Handedness, LengthUnit};
pub use wirebend_profile::Kind as ProfileKind;
use wirebend_profile::{Library, ProfileError};

/// The application without a face: the profiles that it knows, and all commands.
#[derive(Debug)]
pub struct App {
    library: Library,
    refused: Vec<ProfileError>,
    drivers: DriverFolders,
    /// Whether drivers are asked for the limits of their machines: where it was said where they are.
    asks_drivers: bool,
    /// The machines that are connected.
    boards: drivers::Boards,
    /// Options that every command to be typed next needs, too.
    options: Vec<String>,
    /// Where journals and records of wires are; without a place, no wire is made.
    runs: Option<PathBuf>,
}

impl App {
    /// The application with the shipped profiles and those in further folders. Files there that break
    /// a rule are left out; [`App::refused_profiles`] says why.
    ///
    /// # Errors
    /// [`AppError::Profile`] when a shipped profile is damaged.
    pub fn new(profile_folders: &[PathBuf]) -> Result<Self, AppError> {
        let mut library = Library::shipped()?;
        let mut refused = Vec::new();
        for folder in profile_folders {
            refused.extend(library.add_folder(folder).refused);
        }
        Ok(Self {
            library,
            refused,
            drivers: DriverFolders::default(),
            asks_drivers: false,
            boards: drivers::Boards::default(),
            options: Vec::new(),
            runs: None,
        })
    }

    /// The same with drivers from other places than the folders beside the program.
    #[must_use]
    pub fn with_drivers(self, drivers: DriverFolders) -> Self {
        Self { drivers, asks_drivers: true, ..self }
    }

    /// The same that knows the machines which are connected to another.
    #[must_use]
    pub(crate) fn with_boards_of(self, other: &Self) -> Self {
        Self { boards: other.boards.clone(), ..self }
    }

    /// The same with a folder for journals and records of the wires that are made.
    #[must_use]
    pub fn with_runs(self, folder: Option<PathBuf>) -> Self {
        Self { runs: folder, ..self }
    }

    /// The same whose advice is typed with these words: where profiles, drivers and journals are.
    #[must_use]
    pub fn with_options(self, options: Vec<String>) -> Self {
        Self { options, ..self }
    }

    /// Profiles in a person's folders that could not be used, and why.
    #[must_use]
    pub fn refused_profiles(&self) -> &[ProfileError] {
        &self.refused
    }
}
