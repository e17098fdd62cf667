//! The list of commands.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{App, AppError, Progress};

macro_rules! commands {
    ($($(#[$doc:meta])* $name:ident($request:ty) -> $response:ty = $run:path, $word:literal;)*) => {
        /// A command with what it needs.
        #[derive(Debug, Clone, Deserialize, JsonSchema)]
        #[serde(tag = "command", rename_all = "kebab-case")]
        pub enum Request { $($(#[$doc])* $name($request),)* }

        /// What a command found.
        #[derive(Debug, Clone, Serialize)]
        #[serde(untagged)]
        pub enum Response { $($(#[$doc])* $name(Box<$response>),)* }

        /// The names of the commands.
        pub const COMMANDS: &[&str] = &[$($word,)*];

        impl App {
            /// Runs a command.
            ///
            /// # Errors
            /// [`AppError`]; its kind tells a front end whose turn it is.
            pub fn run(&self, request: &Request, progress: &dyn Progress) -> Result<Response, AppError> {
                match request {
                    $(Request::$name(request) => {
                        let _span = tracing::info_span!($word).entered();
                        $run(self, request, progress).map(|response| Response::$name(Box::new(response)))
                    })*
                }
            }
        }

        /// For every command its name and the JSON Schema of what `--json` prints.
        #[must_use]
        pub fn response_schemas() -> Vec<(&'static str, serde_json::Value)> {
            vec![$(($word, schema_of::<$response>()),)*]
        }
    };
}

/// The JSON Schema of a value as it is written.
fn schema_of<T: JsonSchema>() -> serde_json::Value {
    let settings = schemars::generate::SchemaSettings::draft2020_12().for_serialize();
    settings.into_generator().into_root_schema_for::<T>().to_value()
}

commands! {
    /// Lists the machines.
    Machines(crate::MachinesRequest) -> crate::MachinesResponse = crate::catalogue::machines, "machines";
    /// Lists the materials.
    Materials(crate::MaterialsRequest) -> crate::MaterialsResponse = crate::catalogue::materials, "materials";
    /// Lists the drivers.
    Drivers(crate::DriversRequest) -> crate::DriversResponse = crate::drivers::drivers, "drivers";
    /// Says whether a library keeps the rules for drivers.
    DriverCheck(crate::DriverCheckRequest) -> crate::DriverCheckResponse = crate::drivers::check, "driver-check";
    /// Accepts a library of somebody else's as it is.
    DriverTrust(crate::DriverTrustRequest) -> crate::DriverTrustResponse = crate::drivers::trust, "driver-trust";
    /// Reads a file and makes a `.wirebend` document of it.
    Import(crate::ImportRequest) -> crate::ImportResponse = crate::import::import, "import";
    /// Says what a machine cannot make of a wireframe, and why.
    Check(crate::CheckRequest) -> crate::CheckResponse = crate::plan::check, "check";
    /// Takes a wireframe through the whole pipeline to a job.
    Plan(crate::PlanRequest) -> crate::PlanResponse = crate::plan::plan, "plan";
    /// Plans a wireframe for several machines and says what changes.
    Compare(crate::CompareRequest) -> crate::CompareResponse = crate::compare::compare, "compare";
    /// Writes what a machine, another program or a person reads.
    Export(crate::ExportRequest) -> crate::ExportResponse = crate::export::export, "export";
    /// Bends a job without a machine.
    Simulate(crate::SimulateRequest) -> crate::SimulateResponse = crate::simulate::simulate, "simulate";
    /// Makes a job on its machine.
    Run(crate::RunRequest) -> crate::RunResponse = crate::run::run, "run";
    /// Moves a machine by hand.
    Jog(crate::JogRequest) -> crate::JogResponse = crate::by_hand::jog, "jog";
    /// Makes recorded moves again.
    Replay(crate::ReplayRequest) -> crate::JogResponse = crate::by_hand::replay, "replay";
    /// Lists the ports that a machine can be at.
    Ports(crate::PortsRequest) -> crate::PortsResponse = crate::ports::ports, "ports";
    /// Compares a machine's settings with its profile, or writes them.
    MachineSettings(crate::MachineSettingsRequest) -> crate::MachineSettingsResponse = crate::machine_settings::machine_settings, "machine-settings";
    /// Lists what was made.
    Runs(crate::RunsRequest) -> crate::RunsResponse = crate::runs::list, "runs";
    /// Shows what was made of a wire.
    RunsShow(crate::RunsShowRequest) -> crate::RunsShowResponse = crate::runs::show, "runs-show";
    /// Writes what was made of a wire as a file.
    RunsExport(crate::RunsExportRequest) -> crate::RunsExportResponse = crate::runs::export, "runs-export";
    /// One stage's value.
    Dump(crate::DumpRequest) -> crate::DumpResponse = crate::dump::dump, "dump";
    /// Says whether profile files can be used.
    ProfileCheck(crate::ProfileCheckRequest) -> crate::ProfileCheckResponse = crate::profile_check::check, "profile-check";
    /// Writes a profile that inherits from a known one.
    ProfileNew(crate::ProfileNewRequest) -> crate::ProfileNewResponse = crate::profile_new::new, "profile-new";
    /// Says which file and line set each value of a profile.
    ProfileExplain(crate::ProfileExplainRequest) -> crate::ProfileExplainResponse = crate::profile_explain::explain, "profile-explain";
}
