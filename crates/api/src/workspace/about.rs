//! What this program is, and what it is made of.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Workspace;
use crate::{ApiError, Progress};

/// Asks what this program is.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct AboutRequest {}

/// What this program is.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct AboutResponse {
    pub version: String,
    /// Its licence, as an SPDX expression.
    pub licence: String,
    /// What it is for, in a sentence.
    pub description: String,
    /// The version of the interface to drivers.
    pub driver_interface: String,
    /// Where profiles and drivers of a person's own are looked for.
    pub own_folder: Option<String>,
    /// The packages of others that it is made of: name, version, licence.
    pub packages: Vec<[String; 3]>,
}

/// Written by `cargo xtask generate`.
const PACKAGES: &str = include_str!("packages.json");

impl Workspace {
    pub(crate) fn about(&self, _: &AboutRequest, _: &dyn Progress) -> Result<AboutResponse, ApiError> {
        use wirebend_driver_host::api::{ABI_MAJOR, ABI_MINOR};
        Ok(AboutResponse {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            licence: env!("CARGO_PKG_LICENSE").to_owned(),
            description: "From an idea to a bent wire: wireframes, checks, programs and machines.".to_owned(),
            driver_interface: format!("{ABI_MAJOR}.{ABI_MINOR}"),
            own_folder: self.places().own.as_ref().map(|own| own.display().to_string()),
            packages: serde_json::from_str(PACKAGES)?,
        })
    }
}
