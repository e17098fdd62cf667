//! `machine-settings`: what a machine has stored against what its profile says.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_driver_host::SessionError;
use wirebend_driver_host::api::{Capability, SettingCheck};

use crate::drivers::Signs;
use crate::live::{At, Connection, Unnamed, Yes};
use crate::report::NoteReport;
use crate::{App, AppError, LiveProblem, Progress};

/// What a person is asked before settings are written.
pub(crate) const QUESTION: &str = "May these settings be written to the machine, for good?";

/// Whose settings to compare, and whether to write them. Nothing moves; nothing is written unless a person says so:
/// here, or when they are asked.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct MachineSettingsRequest {
    /// The machine.
    pub machine: String,
    /// Where it is; absent, nothing is compared and the ports are told.
    pub port: Option<String>,
    /// Whether to write those of the profile to the machine, for good.
    #[serde(default)]
    pub write: bool,
    /// Whether the person has said already that they may be written.
    #[serde(default)]
    pub confirmed: bool,
}

/// How a machine is set.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct MachineSettingsResponse {
    /// The machine.
    pub machine: String,
    /// Where it was.
    pub port: String,
    /// What it says that it is, with the version of its firmware.
    pub identity: String,
    /// What it says of its settings: those that differ, and where its driver tells them, the others too.
    pub settings: Vec<SettingCheck>,
    /// Whether it is set so that wires come out as planned.
    pub fits: bool,
    /// Whether the machine's driver can write settings.
    pub writable: bool,
    /// Whether the settings were written this time.
    pub written: bool,
    /// What a person should know.
    pub notes: Vec<NoteReport>,
}

pub(crate) fn machine_settings(
    app: &App,
    request: &MachineSettingsRequest,
    progress: &dyn Progress,
) -> Result<MachineSettingsResponse, AppError> {
    let machine = app.library.machine(&request.machine)?;
    let signs = Signs::of(&machine.figures()?);
    let port = request.port.as_deref();
    // A simulated machine is set as its profile says: there is nothing to compare.
    let at = At {
        profile: &machine.profile,
        signs,
        port,
        unnamed: Unnamed::Refuse,
        token: None,
        journal: None,
        axes_at_zero: false,
    };
    let mut connection = app.connect(&at, progress)?;
    let description = connection.session.driver().description();
    if request.write && !description.can(Capability::Settings) {
        let (driver, capability) = (description.id.clone(), Capability::Settings);
        return Err(LiveProblem::from(SessionError::Unsupported { driver, capability }).into());
    }
    if request.write {
        let yes = Yes::ask(progress, lines(&connection), QUESTION, request.confirmed)?;
        connection.write_settings(&yes)?;
    }
    let settings = std::mem::take(&mut connection.hearing.settings);
    let writable = connection.session.driver().description().can(Capability::Settings);
    Ok(MachineSettingsResponse {
        machine: machine.profile.id.clone(),
        port: connection.port.clone(),
        identity: connection.session.identity().to_owned(),
        fits: !settings.iter().any(|setting| setting.matters),
        settings,
        writable,
        written: request.write,
        notes: std::mem::take(&mut connection.hearing.warnings),
    })
}

/// What a person reads before settings are written.
pub(crate) fn lines(connection: &Connection) -> Vec<String> {
    let settings = &connection.hearing.settings;
    let mut lines = vec![format!("the machine at {} ({})", connection.port, connection.session.identity())];
    let one = |s: &SettingCheck| format!("{}: {} becomes {}", s.name, s.machine, s.expected);
    lines.extend(settings.iter().filter(|s| s.machine != s.expected).map(one));
    if lines.len() == 1 {
        lines.push("every setting that it tells of is that of the profile already".to_owned());
    }
    lines.push("it does not move, and has to be homed afterwards".to_owned());
    lines
}
