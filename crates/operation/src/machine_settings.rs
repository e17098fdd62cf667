//! `machine-settings`: what a machine has stored against what its profile says.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_driver_host::api::{Capability, SettingCheck};
use wirebend_driver_host::{PermitKind, SessionError};

use crate::FrontEnd;
use crate::live::{At, Connection, Unnamed, ask_permit, connect};
use crate::{LiveProblem, OperationError};
use wirebend_planning::Installation;
use wirebend_planning::report::NoteReport;
use wirebend_planning::signs::Signs;

/// What a person is asked before settings are written.
pub const QUESTION: &str = "May these settings be written to the machine, for good?";

/// Whose settings to compare, and whether to write them. Nothing moves; nothing is written unless a person says so:
/// here, or when they are asked.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct MachineSettingsRequest {
    pub machine: String,
    /// Where it is; absent, that is refused, with the ports that there are.
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
    pub machine: String,
    pub port: String,
    /// What it says that it is, with the version of its firmware.
    pub identity: String,
    /// What it says of its settings: those that differ, and where its driver reports them, the others too.
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

pub fn machine_settings(
    app: &Installation,
    request: &MachineSettingsRequest,
    progress: &dyn FrontEnd,
) -> Result<MachineSettingsResponse, OperationError> {
    let machine = app.library.machine(&request.machine)?;
    let signs = Signs::of(&machine.figures()?);
    let port = request.port.as_deref();
    // A simulated machine is set as its profile says: there is nothing to compare.
    let at = At {
        profile: &machine.profile,
        signs,
        port,
        unnamed: Unnamed::Refuse,
        reattached: None,
        axes_at_zero: false,
    };
    let mut connection = connect(app, &at, progress)?;
    let description = connection.session.driver().description();
    if request.write && !description.can(Capability::Settings) {
        let (driver, capability) = (description.id.clone(), Capability::Settings);
        return Err(LiveProblem::from(SessionError::Unsupported { driver, capability }).into());
    }
    if request.write {
        let (lines, kind) = (lines(&connection), PermitKind::Settings);
        let permit = ask_permit(&mut connection.session, progress, kind, lines, QUESTION, request.confirmed)?;
        connection.write_settings(permit)?;
    }
    let settings = std::mem::take(&mut connection.observer.settings);
    let writable = connection.session.driver().description().can(Capability::Settings);
    Ok(MachineSettingsResponse {
        machine: machine.profile.id.clone(),
        port: connection.port.clone(),
        identity: connection.session.identity().to_owned(),
        fits: !settings.iter().any(|setting| setting.matters),
        settings,
        writable,
        written: request.write,
        notes: std::mem::take(&mut connection.observer.warnings),
    })
}

/// What a person reads before settings are written.
pub fn lines(connection: &Connection) -> Vec<String> {
    let settings = &connection.observer.settings;
    let mut lines = vec![format!("the machine at {} ({})", connection.port, connection.session.identity())];
    let one = |s: &SettingCheck| format!("{}: {} becomes {}", s.name, s.machine, s.expected);
    lines.extend(settings.iter().filter(|s| s.machine != s.expected).map(one));
    if lines.len() == 1 {
        lines.push("every setting that it reports is that of the profile already".to_owned());
    }
    lines.push("it does not move, and has to be homed afterwards".to_owned());
    lines
}
