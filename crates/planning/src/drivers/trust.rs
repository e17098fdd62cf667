//! `driver trust`: a person accepts a library as it is.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_driver_host::{DiscoveredDriver, Driver, Fingerprint, HostError, Place, TrustStatus};

use crate::{DriverProblem, Installation, PlanningError, Progress};

/// Which library to accept. A user who accepts it has to name its hash, which this command shows when it is
/// not named: then nothing is accepted and nothing is run.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct DriverTrustRequest {
    pub library: PathBuf,
    /// Its SHA-256.
    pub sha256: Option<String>,
}

/// A library and whether it is accepted.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct DriverTrustResponse {
    /// The library, by its absolute path.
    pub library: PathBuf,
    /// Its SHA-256.
    pub sha256: String,
    /// Whether it is accepted now.
    pub accepted: bool,
    /// What it says that it is, once it is accepted.
    pub id: Option<String>,
    pub name: Option<String>,
    pub version: Option<String>,
}

pub fn trust(
    app: &Installation,
    request: &DriverTrustRequest,
    _progress: &dyn Progress,
) -> Result<DriverTrustResponse, PlanningError> {
    let library = absolute(&request.library)?;
    let mut store = app.drivers.store()?;
    if let TrustStatus::Refused(reason) = DiscoveredDriver::at(&library, Place::Named, &store).verdict {
        return Err(HostError::Unsafe { file: library, reason }.into());
    }
    let unread = |cause| DriverProblem::Library { file: library.clone(), cause };
    let hash = Fingerprint::of(&library).map_err(unread)?;
    let told = DriverTrustResponse {
        sha256: hash.to_string(),
        accepted: false,
        id: None,
        name: None,
        version: None,
        library: library.clone(),
    };
    let Some(named) = &request.sha256 else { return Ok(told) };
    let named: Fingerprint = named.parse().map_err(|_| PlanningError::Value {
        input: None,
        name: "the SHA-256",
        value: named.clone(),
        expected: "64 hexadecimal digits",
    })?;
    if named != hash {
        return Err(DriverProblem::OtherLibrary { file: library, found: hash.to_string() }.into());
    }
    if app.drivers.trusted.is_none() {
        return Err(DriverProblem::NowhereToTrust.into());
    }
    // What cannot be used is not worth a line in the list.
    let as_accepted =
        DiscoveredDriver { file: library.clone(), place: Place::Named, verdict: TrustStatus::Accepted(hash) };
    let description = Driver::start(&as_accepted, &app.drivers.launch()?)?.description().clone();
    store.accept(&library, hash).map_err(HostError::from)?;
    let (id, name, version) = (Some(description.id), Some(description.name), Some(description.version));
    Ok(DriverTrustResponse { accepted: true, id, name, version, ..told })
}

/// The path without links, as the list of accepted libraries has it.
pub(super) fn absolute(library: &Path) -> Result<PathBuf, DriverProblem> {
    library.canonicalize().map_err(|cause| DriverProblem::Library { file: library.to_owned(), cause })
}
