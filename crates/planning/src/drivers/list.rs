//! `drivers`: which there are, what they can do, and which of them wait to be accepted.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_driver_host::api::{Capability, FormatDescription};
use wirebend_driver_host::{DiscoveredDriver, Driver, TrustStatus};
use wirebend_error::ErrorRemedy;

use crate::{Installation, PlanningError, Progress};

/// Asks for the drivers.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
pub struct DriversRequest {}

/// Whether a driver can be used.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum DriverState {
    /// It came with the program.
    Shipped,
    /// A person has accepted it as it is.
    Accepted,
    /// It was not accepted.
    Unknown,
    /// It was accepted, and is another one now.
    Changed,
    /// It is not loaded, or it failed when it was started.
    Refused,
}

#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct DriverEntry {
    pub file: PathBuf,
    /// Whether it can be used.
    pub state: DriverState,
    /// Its SHA-256, where it did not come with the program.
    pub sha256: Option<String>,
    /// Why it cannot be used.
    pub problem: Option<String>,
    /// What can be done about that.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub remedies: Vec<ErrorRemedy>,
    /// Its id; known of drivers that can be used, as is what follows.
    pub id: Option<String>,
    pub name: Option<String>,
    pub version: Option<String>,
    pub description: Option<String>,
    /// What it can do.
    pub capabilities: Vec<Capability>,
    /// What it writes.
    pub formats: Vec<FormatDescription>,
    /// The JSON Schema of its settings.
    pub settings_schema: Option<serde_json::Value>,
    /// Machines whose profiles name it.
    pub machines: Vec<String>,
}

#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct DriversResponse {
    /// In the order in which they are asked.
    pub drivers: Vec<DriverEntry>,
    /// What was named and is not there.
    pub missing: Vec<String>,
}

pub fn drivers(
    app: &Installation,
    _request: &DriversRequest,
    progress: &dyn Progress,
) -> Result<DriversResponse, PlanningError> {
    progress.stage("starting drivers");
    let (registry, launch) = (app.registry()?, app.drivers.launch()?);
    let all = registry.found.len() as u64;
    let mut drivers: Vec<DriverEntry> = Vec::new();
    for (index, found) in registry.found.iter().enumerate() {
        progress.advance(index as u64, all);
        let mut entry = DriverEntry::of(found);
        match Driver::start(found, &launch) {
            Ok(driver) => entry.describe(&driver, app)?,
            Err(error) => (entry.problem, entry.remedies) = (Some(error.to_string()), error.remedies()),
        }
        let taken = drivers.iter().find(|other| entry.id.is_some() && other.id == entry.id);
        if let Some(first) = taken {
            let what = format!("{} has the same id and comes first", first.file.display());
            (entry.state, entry.problem) = (DriverState::Refused, Some(what));
        } else if entry.id.is_none() && matches!(entry.state, DriverState::Shipped | DriverState::Accepted) {
            entry.state = DriverState::Refused;
        }
        drivers.push(entry);
    }
    progress.advance(all, all);
    Ok(DriversResponse { drivers, missing: registry.missing })
}

impl DriverEntry {
    fn of(found: &DiscoveredDriver) -> Self {
        let (state, hash) = match &found.verdict {
            TrustStatus::Shipped => (DriverState::Shipped, None),
            TrustStatus::Accepted(hash) => (DriverState::Accepted, Some(hash)),
            TrustStatus::Unknown(hash) => (DriverState::Unknown, Some(hash)),
            TrustStatus::Changed(hash) => (DriverState::Changed, Some(hash)),
            TrustStatus::Refused(_) => (DriverState::Refused, None),
        };
        Self {
            file: found.file.clone(),
            state,
            sha256: hash.map(ToString::to_string),
            problem: None,
            remedies: Vec::new(),
            id: None,
            name: None,
            version: None,
            description: None,
            capabilities: Vec::new(),
            formats: Vec::new(),
            settings_schema: None,
            machines: Vec::new(),
        }
    }

    fn describe(&mut self, driver: &Driver, app: &Installation) -> Result<(), PlanningError> {
        let described = driver.description().clone();
        for machine in app.machine_ids() {
            if app.library.machine(&machine)?.profile.driver.id.as_ref() == Some(&described.id) {
                self.machines.push(machine);
            }
        }
        self.id = Some(described.id);
        self.name = Some(described.name);
        self.version = Some(described.version);
        self.description = Some(described.description);
        self.capabilities = described.capabilities.into_iter().collect();
        self.formats = described.formats;
        self.settings_schema = Some(described.settings_schema);
        Ok(())
    }
}
