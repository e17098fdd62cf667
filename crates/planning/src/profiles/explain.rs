//! `profile explain`: every value of a profile, and which file and line set it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_profile::{ExplainedValue, Kind};

use super::springback::{self, SpringbackReport};
use super::torque::{self, BendTorqueReport};
use crate::{Installation, PlanningError, Progress};

#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ProfileExplainRequest {
    pub id: String,
    /// Its kind, where several kinds have a profile with this id.
    pub kind: Option<Kind>,
}

/// A profile, value by value.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ProfileExplainResponse {
    pub kind: Kind,
    pub id: String,
    pub name: String,
    /// Whether it only serves to be inherited from.
    #[serde(rename = "abstract")]
    pub is_abstract: bool,
    /// The profile itself, its parent, and so on.
    pub chain: Vec<AncestorReport>,
    /// Its values, in the order in which the shipped files have them.
    pub values: Vec<ValueReport>,
    /// The curve of a material's springback table; absent where there is no table.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub springback: Option<SpringbackReport>,
    /// What a machine's bend axis has beside what bends each wire; absent where it states none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bend_torque: Option<BendTorqueReport>,
}

/// A profile of a chain.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct AncestorReport {
    pub id: String,
    pub file: String,
    /// Whether it comes with the program.
    pub shipped: bool,
}

#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ValueReport {
    /// Dotted key; its last word ends with the unit of a figure.
    pub key: String,
    /// The value; null where a parent's value is taken away.
    pub value: serde_json::Value,
    /// The profile that set it.
    pub set_by: String,
    /// The file of that profile.
    pub file: String,
    /// The line in it, from 1.
    pub line: Option<usize>,
    /// Where a figure comes from; null for what is no figure.
    pub source: Option<String>,
    /// Whether a figure was measured; null for what is no figure.
    pub measured: Option<bool>,
    /// The parent's value that it replaces.
    pub instead_of: Option<OverriddenReport>,
}

/// A value of a parent.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct OverriddenReport {
    pub value: serde_json::Value,
    /// The profile that set it.
    pub set_by: String,
}

impl From<ExplainedValue> for ValueReport {
    fn from(value: ExplainedValue) -> Self {
        let instead_of = value.instead_of;
        Self {
            key: value.key,
            value: value.value,
            set_by: value.id,
            file: value.place.file,
            line: value.place.line,
            source: value.source,
            measured: value.measured,
            instead_of: instead_of.map(|old| OverriddenReport { value: old.value, set_by: old.id }),
        }
    }
}

pub fn explain(
    app: &Installation,
    request: &ProfileExplainRequest,
    _progress: &dyn Progress,
) -> Result<ProfileExplainResponse, PlanningError> {
    let kind = app.kind_of(&request.id, request.kind)?;
    let explained = app.library.explain(kind, &request.id)?;
    let ancestor = |ancestor: wirebend_profile::Ancestor| AncestorReport {
        id: ancestor.id,
        file: ancestor.file,
        shipped: ancestor.shipped,
    };
    // What only serves to be inherited from may lack what a curve needs.
    let springback = match kind {
        Kind::Material if !explained.is_abstract => {
            let material = app.library.material(&request.id)?;
            let stated = material.profile.springback.as_ref();
            stated.map(|stated| springback::report(&request.id, stated)).transpose()?.flatten()
        }
        _ => None,
    };
    let is_machine = kind == Kind::Machine && !explained.is_abstract;
    Ok(ProfileExplainResponse {
        springback,
        bend_torque: is_machine.then(|| torque::report(app, &request.id)).flatten(),
        kind,
        id: request.id.clone(),
        name: explained.name,
        is_abstract: explained.is_abstract,
        chain: explained.chain.into_iter().map(ancestor).collect(),
        values: explained.values.into_iter().map(ValueReport::from).collect(),
    })
}
