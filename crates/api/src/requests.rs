//! The table of everything that can be asked. A row: what it is for, its name, what it needs, what it gives, the function, and its
//! name in JSON.

use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;
use wirebend_operation::calibrate::enter as calibrate_enter;
use wirebend_operation::{by_hand, console, machine_settings, ports, run, runs};
use wirebend_planning::{
    calibrate, catalogue, compare, drivers, dump, export, frame, generate, import, plan, profiles, sequence,
    wires,
};

use crate::workspace::{self, ApiErrorReport, Work, Workspace};
use crate::{
    ApiError, AvoidedCollisions, CalibrateApplyRequest, CalibrateApplyResponse, CalibrateCompareRequest,
    CalibrateCompareResponse, CalibrateEnterRequest, CalibrateEnterResponse, CalibrateFitRequest,
    CalibrateNewRequest, CalibrateNewResponse, CalibrationReport, CalibrationSheet, CalibrationSheetRequest,
    CheckRequest, CheckResponse, Collisions, CompareRequest, CompareResponse, ConsoleRequest,
    ConsoleResponse, DrawnSequence, DriverCheckRequest, DriverCheckResponse, DriverTrustRequest,
    DriverTrustResponse, DriversRequest, DriversResponse, DryRunRequest, DumpRequest, DumpResponse,
    ExportRequest, ExportResponse, FrameRequest, FrameResponse, FrontEnd, GenerateRequest, GenerateResponse,
    ImportRequest, ImportResponse, Installation, JogRequest, JogResponse, LiveCheck, LoadCases,
    MachineSettingsRequest, MachineSettingsResponse, MachinesRequest, MachinesResponse, MaterialsRequest,
    MaterialsResponse, OperatorEvent, PlanRequest, PlanResponse, PortsRequest, PortsResponse,
    PredictionRequest, ProfileCheckRequest, ProfileCheckResponse, ProfileExplainRequest,
    ProfileExplainResponse, ProfileExportRequest, ProfileExportResponse, ProfileImportRequest,
    ProfileImportResponse, ProfileNewRequest, ProfileNewResponse, ProfileRevertRequest,
    ProfileRevertResponse, ProfileSetRequest, ProfileSetResponse, ReplayRequest, RunRequest, RunResponse,
    RunsExportRequest, RunsExportResponse, RunsRequest, RunsResponse, RunsShowRequest, RunsShowResponse,
    SequenceRequest, SequenceResponse, SimulateRequest, SimulateResponse, ToleranceRequest,
    ToleranceResponse, WiresRequest, WiresResponse,
};

macro_rules! requests {
    (
        command { $($(#[$c_doc:meta])* $c_name:ident($c_request:ty) -> $c_response:ty = $c_run:path, $c_word:literal;)* }
        both { $($(#[$b_doc:meta])* $b_name:ident($b_request:ty) -> $b_response:ty = $b_run:path, $b_word:literal;)* }
        window { $($(#[$w_doc:meta])* $w_name:ident($w_request:ty) -> $w_response:ty = $w_run:path, $w_word:literal;)* }
    ) => {
        /// What can be asked without anything being open: all that it works on is named in it.
        #[derive(Debug, Clone, Deserialize, JsonSchema)]
        #[serde(tag = "command", rename_all = "kebab-case")]
        pub enum Command {
            $($(#[$c_doc])* $c_name($c_request),)*
            $($(#[$b_doc])* $b_name($b_request),)*
        }

        /// What a command gives.
        #[derive(Debug, Clone, Serialize)]
        #[serde(untagged)]
        pub enum Response {
            $($(#[$c_doc])* $c_name(Box<$c_response>),)*
            $($(#[$b_doc])* $b_name(Box<$b_response>),)*
        }

        /// What a window can ask of its workspace.
        #[derive(Debug, Clone, Deserialize, JsonSchema)]
        #[serde(tag = "ask", rename_all = "kebab-case")]
        pub enum Request {
            $($(#[$w_doc])* $w_name($w_request),)*
            $($(#[$b_doc])* $b_name($b_request),)*
        }

        /// The names of the commands.
        pub const COMMANDS: &[&str] = &[$($c_word,)* $($b_word,)*];

        /// The names of what a window can ask.
        pub const REQUESTS: &[&str] = &[$($w_word,)* $($b_word,)*];

        impl Command {
            /// Runs it. The kind of an error gives the exit status.
            pub fn run(
                &self,
                installation: &Installation,
                front_end: &dyn FrontEnd,
            ) -> Result<Response, ApiError> {
                match self {
                    $(Self::$c_name(request) => {
                        let _span = tracing::info_span!($c_word).entered();
                        Ok(Response::$c_name(Box::new($c_run(installation, request, front_end)?)))
                    })*
                    $(Self::$b_name(request) => {
                        let _span = tracing::info_span!($b_word).entered();
                        Ok(Response::$b_name(Box::new($b_run(installation, request, front_end)?)))
                    })*
                }
            }
        }

        impl Request {
            pub(crate) fn answer(&self, workspace: &Workspace) -> Result<Box<RawValue>, ApiError> {
                match self {
                    $(Self::$w_name(request) => {
                        let _span = tracing::info_span!($w_word).entered();
                        json(&$w_run(workspace, request, &workspace.reporter($w_word))?)
                    })*
                    $(Self::$b_name(request) => {
                        let _span = tracing::info_span!($b_word).entered();
                        json(&$b_run(&workspace.installation(), request, &workspace.reporter($b_word))?)
                    })*
                }
            }
        }

        /// For every command its name and the JSON Schema of what `--json` prints.
        #[must_use]
        pub fn response_schemas() -> Vec<(&'static str, serde_json::Value)> {
            vec![$(($c_word, schema_of::<$c_response>()),)* $(($b_word, schema_of::<$b_response>()),)*]
        }

        /// The JSON Schemas of what a window can ask, of the answers and of the events: objects with a key for each
        /// name, and names for the files.
        #[must_use]
        pub fn request_schemas() -> [(&'static str, serde_json::Value); 3] {
            let settings = SchemaSettings::draft2020_12();
            let mut requests = settings.clone().for_deserialize().into_generator();
            let mut responses = settings.for_serialize().into_generator();
            let asked = vec![
                $(($w_word, requests.subschema_for::<$w_request>()),)*
                $(($b_word, requests.subschema_for::<$b_request>()),)*
            ];
            let answered = vec![
                $(($w_word, responses.subschema_for::<$w_response>()),)*
                $(($b_word, responses.subschema_for::<$b_response>()),)*
            ];
            let mut events = SchemaSettings::draft2020_12().for_serialize().into_generator();
            let told = vec![
                ("refusal", events.subschema_for::<ApiErrorReport>()),
                ("work", events.subschema_for::<Work>()),
                ("operator", events.subschema_for::<OperatorEvent>()),
            ];
            [
                ("asks.requests", object("Requests", &asked, &requests.take_definitions(true))),
                ("asks.responses", object("Responses", &answered, &responses.take_definitions(true))),
                ("asks.events", object("Events", &told, &events.take_definitions(true))),
            ]
        }
    };
}

requests! {
    command {
        /// Says whether a library keeps the rules for drivers.
        DriverCheck(DriverCheckRequest) -> DriverCheckResponse = drivers::check, "driver-check";
        /// Reads a file and makes a `.wirebend` document of it.
        Import(ImportRequest) -> ImportResponse = import::import, "import";
        /// Makes a design from a few figures.
        Generate(GenerateRequest) -> GenerateResponse = generate::generate, "generate";
        /// Says what a machine cannot make of a wireframe, and why.
        Check(CheckRequest) -> CheckResponse = plan::check, "check";
        /// Takes a wireframe through the whole pipeline to a job.
        Plan(PlanRequest) -> PlanResponse = plan::plan, "plan";
        /// Plans a wireframe for several machines and says what changes.
        Compare(CompareRequest) -> CompareResponse = compare::compare, "compare";
        /// Plans a wireframe for more and more wires and says what each saves.
        Wires(WiresRequest) -> WiresResponse = wires::wires, "wires";
        /// Writes what a machine, another program or a person reads.
        Export(ExportRequest) -> ExportResponse = export::export, "export";
        /// Computes a design as a frame: what its struts carry, how it vibrates, and how accurate it is once its joints are closed.
        Frame(FrameRequest) -> FrameResponse = frame::frame, "frame";
        /// Says how good a machine must be for what is required of the closed frame.
        Tolerance(ToleranceRequest) -> ToleranceResponse = frame::tolerance, "tolerance";
        /// Finds the order in which a machine builds the struts of a frame, or checks one.
        Sequence(SequenceRequest) -> SequenceResponse = sequence::sequence, "sequence";
        /// Simulates a job.
        Simulate(SimulateRequest) -> SimulateResponse = wirebend_operation::simulate::simulate, "simulate";
        /// Bends the wires of a job on its machine.
        Run(RunRequest) -> RunResponse = run::run, "run";
        /// Moves a machine by hand.
        Jog(JogRequest) -> JogResponse = by_hand::jog, "jog";
        /// Replays recorded moves.
        Replay(ReplayRequest) -> JogResponse = by_hand::replay, "replay";
        DryRun(DryRunRequest) -> JogResponse = by_hand::dry_run, "dry-run";
        /// Compares a machine's settings with its profile, or writes them.
        MachineSettings(MachineSettingsRequest) -> MachineSettingsResponse = machine_settings::machine_settings, "machine-settings";
        /// Passes lines on to a machine that a person has typed.
        Console(ConsoleRequest) -> ConsoleResponse = console::console, "console";
        /// Writes the record of a run to a file.
        RunsExport(RunsExportRequest) -> RunsExportResponse = runs::export, "runs-export";
        /// Shows the value of one stage.
        Dump(DumpRequest) -> DumpResponse = dump::dump, "dump";
        /// Says whether profile files can be used.
        ProfileCheck(ProfileCheckRequest) -> ProfileCheckResponse = profiles::check::check, "profile-check";
        /// Writes a profile that inherits from a known one.
        ProfileNew(ProfileNewRequest) -> ProfileNewResponse = profiles::new::new, "profile-new";
        /// Sets values of a profile of the person's own.
        ProfileSet(ProfileSetRequest) -> ProfileSetResponse = profiles::set::set, "profile-set";
        /// Takes back values of a profile of the person's own, or its last change.
        ProfileRevert(ProfileRevertRequest) -> ProfileRevertResponse = profiles::revert::revert, "profile-revert";
        /// Writes a profile as one file that others can use.
        ProfileExport(ProfileExportRequest) -> ProfileExportResponse = profiles::share::export_profile, "profile-export";
        /// Takes in a profile from a file.
        ProfileImport(ProfileImportRequest) -> ProfileImportResponse = profiles::share::import_profile, "profile-import";
        /// Writes a version of the machine and of the wire with what a sheet tells.
        CalibrateApply(CalibrateApplyRequest) -> CalibrateApplyResponse = calibrate::apply, "calibrate-apply";
    }
    both {
        /// Lists the machines.
        Machines(MachinesRequest) -> MachinesResponse = catalogue::machines, "machines";
        /// Lists the materials.
        Materials(MaterialsRequest) -> MaterialsResponse = catalogue::materials, "materials";
        /// Lists the drivers.
        Drivers(DriversRequest) -> DriversResponse = drivers::drivers, "drivers";
        /// Trusts a driver library, as it is now.
        DriverTrust(DriverTrustRequest) -> DriverTrustResponse = drivers::trust, "driver-trust";
        /// Lists the ports that a machine can be at.
        Ports(PortsRequest) -> PortsResponse = ports::ports, "ports";
        /// Lists the runs.
        Runs(RunsRequest) -> RunsResponse = runs::list, "runs";
        /// Shows the record of a run.
        RunsShow(RunsShowRequest) -> RunsShowResponse = runs::show, "runs-show";
        /// Says which file and line set each value of a profile.
        ProfileExplain(ProfileExplainRequest) -> ProfileExplainResponse = profiles::explain::explain, "profile-explain";
        /// Writes coupons as jobs and a sheet for what is measured of them.
        CalibrateNew(CalibrateNewRequest) -> CalibrateNewResponse = calibrate::new, "calibrate-new";
        /// Enters readings into a sheet.
        CalibrateEnter(CalibrateEnterRequest) -> CalibrateEnterResponse = calibrate_enter, "calibrate-enter";
        /// Says what a sheet tells of the machine and the wire.
        CalibrateFit(CalibrateFitRequest) -> CalibrationReport = calibrate::fit, "calibrate-fit";
        /// Compares two versions of a machine and its wire.
        CalibrateCompare(CalibrateCompareRequest) -> CalibrateCompareResponse = calibrate::compare, "calibrate-compare";
    }
    window {
        /// What a window needs when it opens.
        Start(workspace::Start) -> workspace::Started = Workspace::start, "start";
        /// What this program is.
        About(workspace::AboutRequest) -> workspace::AboutResponse = Workspace::about, "about";
        /// Chooses the unit of the lengths in messages.
        ShowLengths(workspace::ShowLengths) -> workspace::LengthsShown = Workspace::show_lengths, "show-lengths";
        /// The examples.
        Examples(workspace::ExamplesRequest) -> workspace::ExamplesResponse = Workspace::examples, "examples";
        /// Looks into a file before it is opened.
        Look(workspace::LookRequest) -> workspace::LookResponse = Workspace::look, "look";
        /// Begins an empty design.
        New(workspace::NewDesign) -> workspace::DesignOpened = Workspace::new_design, "new";
        /// Opens a file as the design.
        Open(workspace::OpenDesign) -> workspace::DesignOpened = Workspace::open_design, "open";
        /// Opens an example.
        OpenExample(workspace::OpenExample) -> workspace::DesignOpened = Workspace::open_example, "open-example";
        /// Opens a job, a program or a recording to be run; the design stays behind it.
        OpenRunFile(workspace::OpenRunFile) -> workspace::RunFileNow = Workspace::open_run_file, "open-run-file";
        /// Checks what is open to be run with the profiles as they are now.
        CheckRunFile(workspace::CheckRunFile) -> workspace::RunFileNow = Workspace::check_run_file, "check-run-file";
        /// Closes it: the design is shown and run again.
        CloseRunFile(workspace::CloseRunFile) -> workspace::RunFileNow = Workspace::close_run_file, "close-run-file";
        /// Which file is open to be run.
        RunFile(workspace::RunFileRequest) -> workspace::RunFileNow = Workspace::ask_run_file, "run-file";
        /// Restores a design that was open when the program stopped.
        Restore(workspace::RestoreUnsaved) -> workspace::DesignOpened = Workspace::restore, "restore";
        /// Throws away a design that was open when the program stopped.
        Discard(workspace::DiscardUnsaved) -> workspace::Started = Workspace::discard, "discard";
        /// Empties the list of what was open before.
        ClearRecent(workspace::ClearRecent) -> workspace::Started = Workspace::clear_recent, "clear-recent";
        /// Saves the design.
        Save(workspace::SaveDesign) -> workspace::DesignOpened = Workspace::save, "save";
        /// Closes the design without saving.
        Close(workspace::CloseDesign) -> workspace::DesignOpened = Workspace::close, "close";
        /// Puts the surface of a file into the design.
        PutStencil(workspace::PutStencil) -> workspace::EditMade = Workspace::put_stencil, "put-stencil";
        /// Adds the wireframe of a file to the design.
        PutWireframe(workspace::PutWireframe) -> workspace::EditMade = Workspace::put_wireframe, "put-wireframe";
        /// Makes a change.
        Edit(workspace::EditDesign) -> workspace::EditMade = Workspace::edit, "edit";
        /// What a fillet or a shape would make, without making it.
        Outcome(workspace::OutcomeRequest) -> workspace::OutcomeResponse = Workspace::outcome, "outcome";
        /// Undoes the last change.
        Undo(workspace::Undo) -> workspace::EditMade = Workspace::undo, "undo";
        /// Does again what was undone last.
        Redo(workspace::Redo) -> workspace::EditMade = Workspace::redo, "redo";
        /// Checks the design on its machine.
        Check(workspace::CheckDesign) -> LiveCheck = Workspace::check, "check";
        /// Looks where the wires of the design meet the machine or themselves.
        Collisions(workspace::CheckCollisions) -> Collisions = Workspace::collisions, "collisions";
        /// Stops looking for that.
        StopCollisions(workspace::StopCollisions) -> workspace::CollisionsStopped = Workspace::stop_collisions, "stop-collisions";
        /// Searches for wires that hit nothing.
        AvoidCollisions(workspace::AvoidCollisions) -> AvoidedCollisions = Workspace::avoid_collisions, "avoid-collisions";
        /// Ends that search with the best that it has.
        StopAvoiding(workspace::StopAvoiding) -> workspace::AvoidingStopped = Workspace::stop_avoiding, "stop-avoiding";
        /// Predicts how far off the machine will make the design.
        Predict(PredictionRequest) -> workspace::PredictedDesign = Workspace::predict, "predict";
        /// Stops predicting.
        StopPrediction(workspace::StopPrediction) -> workspace::PredictionStopped = Workspace::stop_prediction, "stop-prediction";
        /// What would fix what the checks say, each tried beforehand.
        Fixes(workspace::FixesRequest) -> workspace::FixesResponse = Workspace::fixes, "fixes";
        /// What would fix all that the checks say of a kind, as one change.
        FixAll(workspace::FixAllRequest) -> workspace::FixAllResponse = Workspace::fix_all, "fix-all";
        /// The program of the design, as it is played.
        Program(workspace::ProgramRequest) -> workspace::ProgramResponse = Workspace::program, "program";
        /// The design as the machine bends it.
        Made(workspace::MadeRequest) -> workspace::MadeResponse = Workspace::made, "made";
        /// What there is to choose from for frames.
        FrameChoices(workspace::FrameChoicesRequest) -> workspace::FrameChoices = Workspace::frame_choices, "frame-choices";
        /// Computes the design as a frame.
        Frame(workspace::FrameDesign) -> workspace::FrameShown = Workspace::frame, "frame";
        /// Stops computing that.
        StopFrame(workspace::StopFrame) -> workspace::FrameStopped = Workspace::stop_frame, "stop-frame";
        /// Writes what the frame carries for other programs.
        SaveFrame(workspace::SaveFrame) -> workspace::SavedFrame = Workspace::save_frame, "save-frame";
        /// The load cases of a file.
        LoadCases(workspace::LoadCasesRequest) -> LoadCases = Workspace::load_cases, "load-cases";
        /// Says how good a machine must be for the design.
        Tolerance(workspace::ToleranceDesign) -> ToleranceResponse = Workspace::tolerance, "tolerance";
        /// Looks for an order in which the struts of the design are built, or checks one.
        Sequence(workspace::SequenceDesign) -> DrawnSequence = Workspace::sequence, "sequence";
        /// Stops looking for that.
        StopSequence(workspace::StopSequence) -> workspace::SequenceStopped = Workspace::stop_sequence, "stop-sequence";
        /// The design on other machines.
        Compare(workspace::CompareDesign) -> CompareResponse = Workspace::compare, "compare";
        /// What can be written for the machine.
        Exports(workspace::ExportsRequest) -> workspace::ExportsResponse = Workspace::exports, "exports";
        /// Writes the design, or shows what would be written.
        Export(workspace::ExportDesign) -> workspace::ExportPreview = Workspace::export, "export";
        /// Writes the wireframe for other programs.
        SaveWireframe(workspace::SaveWireframe) -> workspace::SavedWireframe = Workspace::save_wireframe, "save-wireframe";
        /// Writes the job.
        SaveJob(workspace::SaveJob) -> workspace::SavedJob = Workspace::save_job, "save-job";
        /// One machine.
        MachineView(workspace::MachineViewRequest) -> workspace::MachineViewResponse = Workspace::machine_view, "machine-view";
        /// Writes a profile of the person's own that inherits from another.
        CopyProfile(workspace::CopyProfile) -> ProfileNewResponse = Workspace::copy_profile, "copy-profile";
        /// A profile with what its editor needs.
        ProfileView(workspace::ProfileViewRequest) -> workspace::ProfileView = Workspace::profile_view, "profile-view";
        /// How a bend head would be with values that are typed and not written yet.
        DrawHead(workspace::HeadRequest) -> wirebend_planning::profiles::head::HeadReport = Workspace::head, "draw-head";
        /// Sets values of a profile of the person's own.
        SetProfile(workspace::SetProfile) -> workspace::ProfileView = Workspace::set_profile, "set-profile";
        /// Takes back values of a profile of the person's own, or its last change.
        RevertProfile(workspace::RevertProfile) -> workspace::ProfileView = Workspace::revert_profile, "revert-profile";
        /// Writes a profile to a file that others can use.
        ExportProfile(ProfileExportRequest) -> ProfileExportResponse = Workspace::export_profile, "export-profile";
        /// Takes in a profile from a file.
        ImportProfile(workspace::ImportProfile) -> ProfileImportResponse = Workspace::import_profile, "import-profile";
        /// Changes the driver's settings in a profile of the person's own.
        ChangeSettings(workspace::ChangeSettings) -> workspace::SettingsChanged = Workspace::change_settings, "change-settings";
        /// A sheet of a calibration with what has been read so far.
        CalibrateSheet(CalibrationSheetRequest) -> CalibrationSheet = Workspace::calibration_sheet, "calibrate-sheet";
        /// Writes profiles of what a sheet tells, and uses them.
        ApplyCalibration(workspace::ApplyCalibration) -> CalibrateApplyResponse = Workspace::apply_calibration, "apply-calibration";
        /// Connects the machine.
        Connect(workspace::ConnectMachine) -> workspace::MachineNow = Workspace::connect, "connect";
        /// Says what the machine is to do.
        Order(workspace::OrderMachine) -> workspace::MachineNow = Workspace::order, "order";
        /// Answers what the machine's operator asks.
        Answer(workspace::AnswerMachine) -> workspace::MachineNow = Workspace::answer_machine, "answer";
        /// How the machine stands.
        MachineState(workspace::MachineStateRequest) -> workspace::MachineNow = Workspace::machine_state, "machine-state";
        /// The wire that moves by hand have bent.
        ByHand(workspace::ByHandRequest) -> workspace::ByHandResponse = Workspace::by_hand, "by-hand";
        /// The moves that were recorded.
        Recorded(workspace::RecordedRequest) -> workspace::Recorded = Workspace::recorded, "recorded";
        /// Forgets the moves that were recorded.
        ClearRecording(workspace::ClearRecording) -> workspace::Recorded = Workspace::clear_recording, "clear-recording";
        /// Writes the moves that were recorded.
        SaveRecording(workspace::SaveRecording) -> workspace::SavedRecording = Workspace::save_recording, "save-recording";
    }
}

/// The JSON Schema of a value as it is written.
fn schema_of<T: JsonSchema>() -> serde_json::Value {
    let settings = SchemaSettings::draft2020_12().for_serialize();
    settings.into_generator().into_root_schema_for::<T>().to_value()
}

fn object(
    title: &str,
    keys: &[(&str, schemars::Schema)],
    definitions: &serde_json::Map<String, serde_json::Value>,
) -> serde_json::Value {
    let names: Vec<&str> = keys.iter().map(|(name, _)| *name).collect();
    let properties: serde_json::Map<String, serde_json::Value> =
        keys.iter().map(|(name, schema)| ((*name).to_owned(), schema.clone().to_value())).collect();
    serde_json::json!({
        "title": title,
        "type": "object",
        "properties": properties,
        "required": names,
        "additionalProperties": false,
        "$defs": definitions,
    })
}

fn json<T: Serialize>(value: &T) -> Result<Box<RawValue>, ApiError> {
    Ok(serde_json::value::to_raw_value(value)?)
}
