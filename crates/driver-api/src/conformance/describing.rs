//! Rules about the description.

use serde_json::Value;

use super::subject::is_slug;
use super::{Conformance, Subject, described};
use crate::{Capability, Description};

/// The description, if it can be used at all.
pub(super) fn check(subject: &mut dyn Subject, found: &mut Conformance) -> Option<Description> {
    let first = described(subject);
    let second = described(subject);
    let same = match (&first, &second) {
        (Ok(first), Ok(second)) if first != second => Err("the second description differs".to_owned()),
        _ => Ok(()),
    };
    let description = first.clone().ok();
    if !found.note("describes itself without settings and without a machine", first.map(drop)) {
        return None;
    }
    found.note("describes itself the same way every time", same);
    let description = description?;
    found.note("has ids of lower-case letters, digits and hyphens", ids(&description));
    found.note("has a name, a version such as 1.2.0, and a description for people", words(&description));
    found.note("claims capabilities that go together", capabilities(&description));
    found.note("publishes a JSON Schema of its settings whose keys are documented", schema(&description));
    Some(description)
}

fn ids(description: &Description) -> Result<(), String> {
    let formats = description.formats.iter().map(|format| format.id.as_str());
    if let Some(bad) = formats.clone().chain([description.id.as_str()]).find(|id| !is_slug(id)) {
        return Err(format!("'{bad}' is not such an id"));
    }
    let mut seen: Vec<&str> = formats.collect();
    seen.sort_unstable();
    match seen.windows(2).find(|pair| pair[0] == pair[1]) {
        Some(pair) => Err(format!("the format '{}' is there twice", pair[0])),
        None => Ok(()),
    }
}

fn words(description: &Description) -> Result<(), String> {
    let Description { name, version, description: text, formats, .. } = description;
    let numbers: Vec<&str> = version.splitn(3, '.').collect();
    let number =
        |part: &&str| part.split(['-', '+']).next().is_some_and(|digits| digits.parse::<u64>().is_ok());
    if numbers.len() != 3 || !numbers.iter().all(number) {
        return Err(format!("'{version}' is not a version of three numbers"));
    }
    if name.trim().is_empty() || text.trim().is_empty() {
        return Err("the name or the description is empty".to_owned());
    }
    for format in formats {
        if format.name.trim().is_empty() || format.extensions.is_empty() {
            return Err(format!("the format '{}' needs a name and a file name extension", format.id));
        }
        if let Some(bad) = format.extensions.iter().find(|part| part.starts_with('.') || part.is_empty()) {
            return Err(format!(
                "the format '{}' has the extension '{bad}': write it without its dot",
                format.id
            ));
        }
    }
    Ok(())
}

fn capabilities(description: &Description) -> Result<(), String> {
    let can = |capability| description.can(capability);
    if can(Capability::Unknown) {
        return Err("a capability is not one of those of this version".to_owned());
    }
    if can(Capability::Export) == description.formats.is_empty() {
        return Err("'export' and a list of formats go together".to_owned());
    }
    if can(Capability::Pause) != can(Capability::Resume) {
        return Err("'pause' and 'resume' go together".to_owned());
    }
    let connected = [
        Capability::Jog,
        Capability::Home,
        Capability::Pause,
        Capability::Stop,
        Capability::Ports,
        Capability::Settings,
        Capability::DryRun,
        Capability::Speed,
        Capability::BeforeZero,
        Capability::Console,
        Capability::Cut,
    ];
    if connected.into_iter().any(can) && !can(Capability::Live) {
        let connected = "'jog', 'home', 'pause', 'stop', 'ports', 'settings', 'dry-run', 'speed', 'before-zero', 'console' and 'cut'";
        return Err(format!("{connected} need 'live'"));
    }
    if can(Capability::DryRun) && !can(Capability::Jog) {
        return Err("'dry-run' needs 'jog'".to_owned());
    }
    if description.capabilities.is_empty() { Err("it can do nothing at all".to_owned()) } else { Ok(()) }
}

fn schema(description: &Description) -> Result<(), String> {
    let schema = &description.settings_schema;
    if schema.get("type").and_then(Value::as_str) != Some("object") {
        return Err("the schema is not that of an object: \"type\": \"object\" is missing".to_owned());
    }
    if let Some(required) = schema.get("required").and_then(Value::as_array).filter(|keys| !keys.is_empty()) {
        return Err(format!("every key has a default, and yet these are required: {required:?}"));
    }
    if schema.get("additionalProperties") != Some(&Value::Bool(false)) {
        return Err("unknown keys are to be refused: \"additionalProperties\": false is missing".to_owned());
    }
    let keys = schema.get("properties").and_then(Value::as_object).into_iter().flatten();
    let silent = |(_, key): &(&String, &Value)| {
        key.get("description").and_then(Value::as_str).is_none_or(|text| text.trim().is_empty())
    };
    match keys.clone().find(silent) {
        Some((name, _)) => Err(format!("the key '{name}' has no description")),
        None => Ok(()),
    }
}
