//! `driver check`: does a library keep the rules for drivers?

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_driver_host::api::conformance;
use wirebend_driver_host::{Examined, Fingerprint};

use crate::{DriverProblem, Installation, PlanningError, Progress};

/// What to check. The library is run, in a process of its own, whether it is trusted or not.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct DriverCheckRequest {
    pub library: PathBuf,
}

/// What became of the rules.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct DriverCheckResponse {
    pub library: PathBuf,
    /// Its SHA-256.
    pub sha256: String,
    /// Whether every rule is kept.
    pub kept: bool,
    /// The rules that were tried.
    pub rules: Vec<RuleReport>,
}

/// What became of one rule.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct RuleReport {
    /// The rule, as a sentence about the driver.
    pub rule: String,
    /// What is wrong; null when the rule is kept.
    pub broken: Option<String>,
}

pub fn check(
    app: &Installation,
    request: &DriverCheckRequest,
    progress: &dyn Progress,
) -> Result<DriverCheckResponse, PlanningError> {
    progress.stage("trying the rules");
    let library = super::trust::absolute(&request.library)?;
    let sha256 =
        Fingerprint::of(&library).map_err(|cause| DriverProblem::Library { file: library.clone(), cause })?;
    let mut examined = Examined::start(&library, &app.drivers.launch()?)?;
    let found = conformance::check(&mut examined);
    Ok(DriverCheckResponse {
        library,
        sha256: sha256.to_string(),
        kept: found.kept(),
        rules: found.findings.into_iter().map(|f| RuleReport { rule: f.rule, broken: f.broken }).collect(),
    })
}
