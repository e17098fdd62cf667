//! JSON Schemas of profiles, documents, and of what `wirebend --json` prints and a window asks.

use anyhow::Result;

use crate::committed::CommittedFile;

pub(super) fn files() -> Result<Vec<CommittedFile>> {
    let mut files = Vec::new();
    for (path, text) in wirebend_profile::schema_files() {
        files.push(CommittedFile { path: format!("machine-profiles/{path}"), text });
    }
    for (name, text) in wirebend_files::document::schemas() {
        files.push(CommittedFile { path: format!("crates/files/schema/{name}"), text });
    }
    for (command, schema) in wirebend_app::response_schemas() {
        files.push(schema_file(command, &schema)?);
    }
    for (name, schema) in wirebend_app::ask_schemas() {
        files.push(schema_file(name, &schema)?);
    }
    for (message, schema) in wirebend_driver_api::message_schemas() {
        let text = serde_json::to_string_pretty(&schema)? + "\n";
        files.push(CommittedFile { path: format!("crates/driver-api/schema/{message}.schema.json"), text });
    }
    files.push(schema_file("error", &wirebend_cli::error_schema())?);
    Ok(files)
}

fn schema_file(name: &str, schema: &serde_json::Value) -> Result<CommittedFile> {
    let text = serde_json::to_string_pretty(schema)? + "\n";
    Ok(CommittedFile { path: format!("crates/app/schema/{name}.schema.json"), text })
}
