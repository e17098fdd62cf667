//! The JSON Schemas of the documents.

use serde_json::{Map, Value};

use super::job::JobFile;
use super::project::ProjectFile;

/// The schema files (draft 2020-12) as name and text. They are committed under `schema/`.
#[must_use]
pub fn schemas() -> Vec<(&'static str, String)> {
    let text = |schema: schemars::Schema| format!("{:#}\n", sorted(schema.to_value()));
    vec![
        ("wbjob.schema.json", text(schemars::schema_for!(JobFile))),
        ("wirebend.schema.json", text(schemars::schema_for!(ProjectFile))),
    ]
}

/// Keys in order, whichever features of `serde_json` other crates turn on.
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
