//! A profile as it was when a document was saved.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The id of a machine or material, and the profile itself as it was, so that a document means the
/// same after the profile has changed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ProfileSnapshot {
    pub id: String,
    /// The resolved profile.
    pub snapshot: serde_json::Value,
}
