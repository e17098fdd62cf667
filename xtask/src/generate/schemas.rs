//! JSON Schemas of profiles, documents, and of what `wirebend --json` prints and a window asks.

use std::collections::{BTreeMap, BTreeSet};

use anyhow::Result;
use serde_json::{Map, Value, json};

use crate::committed::CommittedFile;

/// The schema of what several others have in common.
const COMMON: &str = "common";
/// How a schema refers to a definition of its own.
const OWN: &str = "#/$defs/";

pub(super) fn files() -> Result<Vec<CommittedFile>> {
    let mut files = Vec::new();
    for (path, text) in wirebend_profile::schema_files() {
        files.push(CommittedFile { path: format!("machine-profiles/{path}"), text });
    }
    for (name, text) in wirebend_files::document::schemas() {
        files.push(CommittedFile { path: format!("crates/files/schema/{name}"), text });
    }
    let mut requests: Vec<(&str, Value)> = wirebend_api::response_schemas();
    requests.extend(wirebend_api::request_schemas());
    requests.push(("error", wirebend_cli::error_schema()));
    let common = take_common(&mut requests);
    requests.push((COMMON, common));
    for (name, schema) in requests {
        let text = serde_json::to_string_pretty(&schema)? + "\n";
        files.push(CommittedFile { path: format!("crates/api/schema/{name}.schema.json"), text });
    }
    for (message, schema) in wirebend_driver_api::message_schemas() {
        let text = serde_json::to_string_pretty(&schema)? + "\n";
        files.push(CommittedFile { path: format!("crates/driver-api/schema/{message}.schema.json"), text });
    }
    Ok(files)
}

/// Takes out the definitions that several schemas have in the same form, and makes a schema of them to which the others refer.
fn take_common(schemas: &mut [(&str, Value)]) -> Value {
    let mut forms: BTreeMap<String, Vec<Value>> = BTreeMap::new();
    for (_, schema) in schemas.iter() {
        for (name, definition) in schema["$defs"].as_object().into_iter().flatten() {
            forms.entry(name.clone()).or_default().push(definition.clone());
        }
    }
    // What is asked for in another form than it is answered stays in each schema.
    forms.retain(|_, forms| forms.len() > 1 && forms.iter().all(|form| form == &forms[0]));
    let mut common: Map<String, Value> =
        forms.into_iter().filter_map(|(name, mut forms)| Some((name, forms.pop()?))).collect();
    // What refers to such a definition stays as well.
    loop {
        let known: BTreeSet<String> = common.keys().cloned().collect();
        common.retain(|_, definition| references(definition).iter().all(|name| known.contains(name)));
        if common.len() == known.len() {
            break;
        }
    }
    for (_, schema) in schemas {
        if let Some(own) = schema.get_mut("$defs").and_then(Value::as_object_mut) {
            own.retain(|name, _| !common.contains_key(name));
        }
        refer_to(&common, schema);
    }
    json!({ "$schema": "https://json-schema.org/draft/2020-12/schema", "$defs": common })
}

/// The definitions to which a schema refers.
fn references(schema: &Value) -> BTreeSet<String> {
    let mut found: BTreeSet<String> = inner(schema).flat_map(references).collect();
    found.extend(schema["$ref"].as_str().and_then(|to| to.strip_prefix(OWN)).map(str::to_owned));
    found
}

/// Lets a schema refer to the common definitions where they are now.
fn refer_to(common: &Map<String, Value>, schema: &mut Value) {
    match schema {
        Value::Object(keys) => {
            let to = keys.get("$ref").and_then(Value::as_str).and_then(|to| to.strip_prefix(OWN));
            if let Some(name) = to.filter(|name| common.contains_key(*name)) {
                let to = format!("{COMMON}.schema.json{OWN}{name}");
                keys.insert("$ref".to_owned(), to.into());
            }
            keys.values_mut().for_each(|inner| refer_to(common, inner));
        }
        Value::Array(items) => items.iter_mut().for_each(|inner| refer_to(common, inner)),
        _ => {}
    }
}

/// The values in an object or a list.
fn inner(value: &Value) -> impl Iterator<Item = &Value> {
    let of_object = value.as_object().into_iter().flat_map(Map::values);
    of_object.chain(value.as_array().into_iter().flatten())
}
