//! Everything that a window may ask, declared once.

use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;

use super::{Desk, Tell, Work};
use crate::{AppError, OperatorEvent, Progress, Refusal};

macro_rules! asks {
    ($($(#[$doc:meta])* $name:ident($request:ty) -> $response:ty = $run:expr, $word:literal;)*) => {
        /// Something to ask, with what it needs.
        #[derive(Debug, Clone, Deserialize, JsonSchema)]
        #[serde(tag = "ask", rename_all = "kebab-case")]
        pub enum Ask { $($(#[$doc])* $name($request),)* }

        /// The names of what can be asked.
        pub const ASKS: &[&str] = &[$($word,)*];

        impl Desk {
            fn answer(&self, ask: &Ask) -> Result<Box<RawValue>, AppError> {
                match ask {
                    $(Ask::$name(request) => {
                        let _span = tracing::info_span!($word).entered();
                        self.run($word, request, $run)
                    })*
                }
            }
        }

        /// The JSON Schemas of what can be asked, of the answers and of what is told unasked: objects with a key for each
        /// name, and names for the files.
        #[must_use]
        pub fn ask_schemas() -> [(&'static str, serde_json::Value); 3] {
            let settings = SchemaSettings::draft2020_12();
            let mut requests = settings.clone().for_deserialize().into_generator();
            let mut responses = settings.for_serialize().into_generator();
            let asked = vec![$(($word, requests.subschema_for::<$request>()),)*];
            let answered = vec![$(($word, responses.subschema_for::<$response>()),)*];
            let mut tells = SchemaSettings::draft2020_12().for_serialize().into_generator();
            let told = vec![
                ("refusal", tells.subschema_for::<Refusal>()),
                ("work", tells.subschema_for::<Work>()),
                ("operator", tells.subschema_for::<OperatorEvent>()),
            ];
            [
                ("asks.requests", object("Requests", &asked, &requests.take_definitions(true))),
                ("asks.responses", object("Responses", &answered, &responses.take_definitions(true))),
                ("asks.tells", object("Tells", &told, &tells.take_definitions(true))),
            ]
        }
    };
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

asks! {
    /// What a window needs when it opens.
    Start(super::Start) -> super::Started = Desk::start, "start";
    /// What this program is.
    About(super::AboutRequest) -> super::AboutResponse = Desk::about, "about";
    /// The examples.
    Examples(super::ExamplesRequest) -> super::ExamplesResponse = Desk::examples, "examples";
    /// Looks into a file before it is opened.
    Look(super::LookRequest) -> super::LookResponse = Desk::look, "look";
    /// Begins an empty design.
    New(super::NewDesign) -> super::DesignOpened = Desk::new_design, "new";
    /// Opens a file as the design.
    Open(super::OpenDesign) -> super::DesignOpened = Desk::open_design, "open";
    /// Opens an example.
    OpenExample(super::OpenExample) -> super::DesignOpened = Desk::open_example, "open-example";
    /// Takes up a design that was open when the program stopped.
    Restore(super::RestoreUnsaved) -> super::DesignOpened = Desk::restore, "restore";
    /// Throws away a design that was open when the program stopped.
    Discard(super::DiscardUnsaved) -> super::Started = Desk::discard, "discard";
    /// Empties the list of what was open before.
    ClearRecent(super::ClearRecent) -> super::Started = Desk::clear_recent, "clear-recent";
    /// Saves the design.
    Save(super::SaveDesign) -> super::DesignOpened = Desk::save, "save";
    /// Closes the design without saving.
    Close(super::CloseDesign) -> super::DesignOpened = Desk::close, "close";
    /// Puts the surface of a file into the design.
    PutStencil(super::PutStencil) -> super::EditMade = Desk::put_stencil, "put-stencil";
    /// Makes a change.
    Edit(super::EditDesign) -> super::EditMade = Desk::edit, "edit";
    /// Undoes the last change.
    Undo(super::Undo) -> super::EditMade = Desk::undo, "undo";
    /// Does again what was undone last.
    Redo(super::Redo) -> super::EditMade = Desk::redo, "redo";
    /// Checks the design on its machine.
    Check(super::CheckDesign) -> crate::LiveCheck = Desk::check, "check";
    /// What would mend what the checks say, each tried beforehand.
    Fixes(super::FixesRequest) -> super::FixesResponse = Desk::fixes, "fixes";
    /// The program of the design, as it is played.
    Program(super::ProgramRequest) -> super::ProgramResponse = Desk::program, "program";
    /// The design as the machine makes it.
    Made(super::MadeRequest) -> super::MadeResponse = Desk::made, "made";
    /// The design on other machines.
    Compare(super::CompareDesign) -> crate::CompareResponse = Desk::compare, "compare";
    /// What can be written for the machine.
    Exports(super::ExportsRequest) -> super::ExportsResponse = Desk::exports, "exports";
    /// Writes the design, or shows what would be written.
    Export(super::ExportDesign) -> super::ExportPreview = Desk::export, "export";
    /// Writes the wireframe for other programs.
    SaveWireframe(super::SaveWireframe) -> super::SavedWireframe = Desk::save_wireframe, "save-wireframe";
    /// Writes the job.
    SaveJob(super::SaveJob) -> super::SavedJob = Desk::save_job, "save-job";
    /// The machines.
    Machines(crate::MachinesRequest) -> crate::MachinesResponse =
        |desk, request, progress| crate::catalogue::machines(&desk.app(), request, progress), "machines";
    /// One machine.
    MachineView(super::MachineViewRequest) -> super::MachineViewResponse = Desk::machine_view, "machine-view";
    /// Writes a profile of the person's own that inherits from a machine.
    CopyMachine(super::CopyMachine) -> crate::ProfileNewResponse = Desk::copy_machine, "copy-machine";
    /// Changes the driver's settings in a profile of the person's own.
    ChangeSettings(super::ChangeSettings) -> super::SettingsChanged = Desk::change_settings, "change-settings";
    /// Every value of a profile, and which file and line set it.
    ExplainProfile(crate::ProfileExplainRequest) -> crate::ProfileExplainResponse =
        |desk, request, progress| crate::profile_explain::explain(&desk.app(), request, progress), "explain-profile";
    /// The materials.
    Materials(crate::MaterialsRequest) -> crate::MaterialsResponse =
        |desk, request, progress| crate::catalogue::materials(&desk.app(), request, progress), "materials";
    /// The drivers.
    Drivers(crate::DriversRequest) -> crate::DriversResponse =
        |desk, request, progress| crate::drivers::drivers(&desk.app(), request, progress), "drivers";
    /// Accepts a library of somebody else's as it is.
    TrustDriver(crate::DriverTrustRequest) -> crate::DriverTrustResponse =
        |desk, request, progress| crate::drivers::trust(&desk.app(), request, progress), "trust-driver";
    /// The ports that a machine can be at.
    Ports(crate::PortsRequest) -> crate::PortsResponse =
        |desk, request, progress| crate::ports::ports(&desk.app(), request, progress), "ports";
    /// Connects the machine.
    Connect(super::ConnectMachine) -> super::MachineNow = Desk::connect, "connect";
    /// Says what the machine is to do.
    Order(super::OrderMachine) -> super::MachineNow = Desk::order, "order";
    /// Answers what the machine's operator asks.
    Answer(super::AnswerMachine) -> super::MachineNow = Desk::answer_machine, "answer";
    /// How the machine stands.
    MachineState(super::MachineStateRequest) -> super::MachineNow = Desk::machine_state, "machine-state";
    /// The moves that were recorded.
    Recorded(super::RecordedRequest) -> super::Recorded = Desk::recorded, "recorded";
    /// Forgets the moves that were recorded.
    ClearRecording(super::ClearRecording) -> super::Recorded = Desk::clear_recording, "clear-recording";
    /// Writes the moves that were recorded.
    SaveRecording(super::SaveRecording) -> super::SavedRecording = Desk::save_recording, "save-recording";
    /// What was made.
    Runs(crate::RunsRequest) -> crate::RunsResponse =
        |desk, request, progress| crate::runs::list(&desk.app(), request, progress), "runs";
    /// What was made of a wire.
    RunsShow(crate::RunsShowRequest) -> crate::RunsShowResponse =
        |desk, request, progress| crate::runs::show(&desk.app(), request, progress), "runs-show";
}

impl Desk {
    /// Answers. Several may be asked at once, from several threads; those that work on the open design take turns.
    ///
    /// # Errors
    /// [`Refusal`]; the design is as it was.
    pub fn ask(&self, ask: &Ask) -> Result<Box<RawValue>, Refusal> {
        self.answer(ask).map_err(|error| Refusal::from(&error))
    }

    /// The same as text: JSON with the name under `ask` beside what it needs.
    ///
    /// # Errors
    /// [`Refusal`], also where the text is nothing that can be asked.
    pub fn ask_json(&self, text: &str) -> Result<Box<RawValue>, Refusal> {
        let ask: Ask = serde_json::from_str(text).map_err(|error| Refusal::not_asked_well(&error))?;
        self.ask(&ask)
    }

    /// The same as a value.
    ///
    /// # Errors
    /// As [`Desk::ask_json`].
    pub fn ask_value(&self, value: serde_json::Value) -> Result<Box<RawValue>, Refusal> {
        let ask: Ask = serde_json::from_value(value).map_err(|error| Refusal::not_asked_well(&error))?;
        self.ask(&ask)
    }

    fn run<Q, A: Serialize>(
        &self,
        word: &'static str,
        request: &Q,
        run: impl Fn(&Self, &Q, &dyn Progress) -> Result<A, AppError>,
    ) -> Result<Box<RawValue>, AppError> {
        let answer = run(self, request, &Heard { desk: self, word, stage: String::new().into() })?;
        Ok(serde_json::value::to_raw_value(&answer)?)
    }
}

/// Passes on how far long work is.
struct Heard<'a> {
    desk: &'a Desk,
    word: &'static str,
    stage: std::cell::RefCell<String>,
}

impl Heard<'_> {
    fn tell(&self, done: u64, of: u64) {
        let (ask, stage) = (self.word.to_owned(), self.stage.borrow().clone());
        self.desk.tell(&Tell::Work(Work { ask, stage, done, of }));
    }
}

impl Progress for Heard<'_> {
    fn stage(&self, name: &str) {
        // What is asked while a person drags is over before it could be shown.
        if self.word != "check" {
            name.clone_into(&mut self.stage.borrow_mut());
            self.tell(0, 0);
        }
    }

    fn advance(&self, done: u64, of: u64) {
        if self.word != "check" {
            self.tell(done, of);
        }
    }
}
