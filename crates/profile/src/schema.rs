//! The JSON Schemas of the file formats.

use serde_json::{Map, Value};

use crate::{Kind, MachineProfile, MaterialProfile, NoiseProfile, StrutBuilderProfile};

/// The JSON Schema (draft 2020-12) of a kind of profile file. Strict: unknown keys are refused.
///
/// It describes one file; that a value may also come from a parent, and rules between values,
/// are beyond it.
#[must_use]
pub fn schema(kind: Kind) -> Value {
    let schema = match kind {
        Kind::Machine => schemars::schema_for!(MachineProfile),
        Kind::Material => schemars::schema_for!(MaterialProfile),
        Kind::Noise => schemars::schema_for!(NoiseProfile),
        Kind::StrutBuilder => schemars::schema_for!(StrutBuilderProfile),
    };
    let mut value = sorted(schema.to_value());
    if let Value::Object(root) = &mut value {
        root.insert("title".into(), format!("Wirebend {kind} profile").into());
    }
    value
}

/// The schema files: path inside `machine-profiles/`, and text.
///
/// The order of keys does not depend on features of `serde_json`.
#[must_use]
pub fn schema_files() -> Vec<(String, String)> {
    let text = |kind| format!("{:#}\n", sorted(schema(kind)));
    Kind::ALL.into_iter().map(|kind| (format!("schema/{kind}.schema.json"), text(kind))).collect()
}

fn sorted(value: Value) -> Value {
    match value {
        Value::Object(object) => {
            let mut entries: Vec<(String, Value)> = object.into_iter().collect();
            entries.sort_by(|a, b| a.0.cmp(&b.0));
            let entries = entries.into_iter().map(|(key, value)| (key, sorted(value)));
            Value::Object(entries.collect::<Map<_, _>>())
        }
        Value::Array(items) => Value::Array(items.into_iter().map(sorted).collect()),
        other => other,
    }
}
