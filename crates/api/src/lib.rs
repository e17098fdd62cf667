//! Everything that a front end may ask, declared once; the workspace that a window works with.
//!
//! A front end (the command line, the window) creates a [`Command`], runs it, and shows the [`Response`]; or it asks a [`Workspace`] with a [`Request`]. They are enums
//! without a wildcard to hide behind: a new command does not compile until every front end shows its response. A front end
//! knows this crate alone.

#![allow(clippy::missing_errors_doc, clippy::must_use_candidate, reason = "not published")]

mod asking;
mod error;
mod places;
mod requests;
mod workspace;

pub use error::ApiError;
pub use places::Places;
pub use requests::{COMMANDS, Command, REQUESTS, Request, Response, request_schemas, response_schemas};
pub use workspace::*;

pub use wirebend_editor::{
    AvoidedCollisions, ChosenWalk, DesignState, DesignView, EdgeView, EditOutcome, EditRequest, Editor,
    EditorError, FilletPart, Fix, FixAll, FixChange, FixPreview, HelpFix, LiveCheck, MergePlace, Moved,
    PastedVertex, Placed, SearchSettings, Unsaved, VertexView, ViewChange, WireFigures,
};
pub use wirebend_operation::by_hand::{DryRunRequest, JogRequest, JogResponse, ReplayRequest};
pub use wirebend_operation::calibrate::CalibrateEnterRequest;
pub use wirebend_operation::console::{ConsoleEntry, ConsoleRequest, ConsoleResponse};
pub use wirebend_operation::machine_settings::{MachineSettingsRequest, MachineSettingsResponse};
pub use wirebend_operation::ports::{PortEntry, PortsRequest, PortsResponse};
pub use wirebend_operation::runs::{
    RunEntry, RunsExportRequest, RunsExportResponse, RunsRequest, RunsResponse, RunsShowRequest,
    RunsShowResponse,
};
pub use wirebend_operation::{
    Answer, Answers, Cancellation, ConnectRequest, Decided, Decision, Doubt, FrontEnd, HeadAsked,
    HeadProblem, LeftBecause, LiveProblem, MachineEvent, MachineState, Move, MovesFile, Observer,
    OperationError, Operator, OperatorError, OperatorEvent, OperatorListener, Order, OrderName, Outcome,
    PartInWire, Phase, Piece, PiecesReport, Prompt, Question, QuestionKind, Record, Repeat, RunHow,
    RunOutcome, RunRequest, RunResponse, StoppedIn, ToldBy, Unfinished, Wait, WireRun, WireState, Wish,
};
pub use wirebend_planning::calibrate::{
    CalibrateApplyRequest, CalibrateApplyResponse, CalibrateCompareRequest, CalibrateCompareResponse,
    CalibrateEnterResponse, CalibrateFitRequest, CalibrateNewRequest, CalibrateNewResponse,
    CalibrationReport, CalibrationRow, CalibrationSheet, CalibrationSheetRequest, ComparedValue, KindName,
    KindReport, LeftOutReport, MisfitReport, ParameterReport, ReadingReport, ShapeName, VersionMisfit,
};
pub use wirebend_planning::catalogue::{
    MachineEntry, MachinesRequest, MachinesResponse, MaterialEntry, MaterialsRequest, MaterialsResponse,
    NoiseEntry, StrutBuilderEntry,
};
pub use wirebend_planning::choices::PlanChoices;
pub use wirebend_planning::collisions::{Collisions, ContactReport};
pub use wirebend_planning::compare::{
    Change, CollisionCount, CompareRequest, CompareResponse, Findings, MachineSide, OtherSide,
    WireDiagnostic, WireStep,
};
pub use wirebend_planning::curves::{CurvesReport, MachineEdges, ShortestEdge};
pub use wirebend_planning::design::{DesignInput, Input};
pub use wirebend_planning::drivers::{
    DriverCheckRequest, DriverCheckResponse, DriverEntry, DriverState, DriverTrustRequest,
    DriverTrustResponse, DriversRequest, DriversResponse, RuleReport,
};
pub use wirebend_planning::dump::{DumpRequest, DumpResponse};
pub use wirebend_planning::error::{DriverProblem, ErrorKind, PlanningError, StencilFileError};
pub use wirebend_planning::export::{ExportFormat, ExportRequest, ExportResponse};
pub use wirebend_planning::frame::{
    AchievedReport, BowChoice, BowedReport, ClosedShapes, ClosingChoice, ClosingFigures, ClosingName,
    ClosingReport, ClosingRuns, ContinuumChoice, FacesChoice, FrameFigures, FrameFiles, FrameRequest,
    FrameResponse, FrameShapes, FrameSupports, LoadCaseEntry, LoadCases, LoadsChoice, MemberReport,
    ModeKindName, ModeReport, ReactionReport, RequirementName, RequirementsChoice, ResourcesReport,
    StaticReport, ToleranceRequest, ToleranceResponse, ToleranceSubject, TrussFrequency, VaryName,
    VertexForce,
};
pub use wirebend_planning::generate::{GenerateRequest, GenerateResponse, GeneratedShape};
pub use wirebend_planning::import::{ImportRequest, ImportResponse};
pub use wirebend_planning::installation::{DriverFolders, Installation};
pub use wirebend_planning::job::SimulatedAs;
pub use wirebend_planning::output::Output;
pub use wirebend_planning::pauses::{LeftOutPause, StepPause};
pub use wirebend_planning::plan::{CheckRequest, CheckResponse, PlanRequest, PlanResponse};
pub use wirebend_planning::profiles::check::{FileVerdict, ProfileCheckRequest, ProfileCheckResponse};
pub use wirebend_planning::profiles::explain::{
    AncestorReport, OverriddenReport, ProfileExplainRequest, ProfileExplainResponse, ValueReport,
};
pub use wirebend_planning::profiles::new::{ProfileNewRequest, ProfileNewResponse, ProfilePlace};
pub use wirebend_planning::profiles::revert::{ProfileRevertRequest, ProfileRevertResponse};
pub use wirebend_planning::profiles::set::{ProfileSetRequest, ProfileSetResponse, SetValue};
pub use wirebend_planning::profiles::share::{
    ProfileExportRequest, ProfileExportResponse, ProfileImportRequest, ProfileImportResponse, SharedProfile,
};
pub use wirebend_planning::profiles::springback::{SamplePlace, SpringbackReport, SpringbackSample};
pub use wirebend_planning::profiles::torque::{BendTorqueReport, WireTorqueReport};
pub use wirebend_planning::program::ProgramKind;
pub use wirebend_planning::progress::{BestSoFar, FoundSoFar, NoProgress, Progress};
pub use wirebend_planning::report::{
    CompensatedReport, DiagnosticCode, DiagnosticReport, JobStep, NoteReport, PartOfStep, PlanReport,
    ProgramReport, RemedyReport, RouteReport, SHOWN_AS_ZERO, SearchReport, SearchWeights, SeverityName,
    WireReport, WireframeReport, shown_deg,
};
pub use wirebend_planning::sequence::{
    CostName, DrawnSequence, GroupBy, HeadMove, ObstacleReport, ObstacleRuleName, OrderedStep, PartialReport,
    SequenceFormat, SequenceJoint, SequenceRequest, SequenceResponse, SequenceStepReport, StepTypeName,
    StrategyName,
};
pub use wirebend_planning::simulate::{
    ErrorSourceName, GapReport, Prediction, PredictionRequest, ResolutionReport, SimulateRequest,
    SimulateResponse, SimulatedCollisions, SimulatedContact, SimulatedTolerance, SimulationModel,
    SourceShare, SourceTolerance, StepShare, VertexReport,
};
pub use wirebend_planning::stage::StageName;
pub use wirebend_planning::wires::{LeftOutReason, LeftOutWires, WiresRequest, WiresResponse, WiresRow};

pub use wirebend_driver_host::api::{Capability, DoneBy, SettingCheck, Usb};
pub use wirebend_driver_host::{
    CHILD_COMMAND, Snapshot, Standstill, StopHandle, StopOutcome, StoppedBy, WireProgress, child_main,
};
pub use wirebend_error::{ErrorCode, ErrorRemedy, InputName, ProblemReport, RunTarget};
pub use wirebend_files::number;
pub use wirebend_files::read::{Format, Handedness, LengthUnit};
pub use wirebend_profile::Kind as ProfileKind;
