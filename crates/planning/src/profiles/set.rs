//! `profile set`: values of a profile of the person's own, each with its source.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use wirebend_error::InputName;
use wirebend_profile::{Kind, schema};

use super::bodies;
use super::own::OwnProfile;
use crate::{Installation, PlanningError, Progress};

/// Which values to set.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ProfileSetRequest {
    /// The profile; created where it is not there yet and its parent is given.
    pub id: String,
    /// The id to inherit from, for a profile that is not there yet.
    pub from: Option<String>,
    /// The kind of profile, where several kinds have one of the id.
    pub kind: Option<Kind>,
    /// Values as `key=value`, with dotted keys; a value is JSON, or text.
    pub values: Vec<String>,
    /// Where the values come from.
    pub source: String,
    /// Whether they were measured on the machine or the wire.
    #[serde(default)]
    pub measured: bool,
    /// The folder with profiles of the person's own, for one that is not there yet.
    pub folder: PathBuf,
}

#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct ProfileSetResponse {
    pub id: String,
    pub kind: Kind,
    /// Its file.
    pub file: PathBuf,
    /// Whether it is new.
    pub created: bool,
    pub values: Vec<SetValue>,
}

/// A value that was set.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct SetValue {
    /// Dotted key.
    pub key: String,
    /// What it was, also where a parent had it; null where nothing was.
    pub before: Value,
    /// What it is.
    pub value: Value,
}

pub fn set(
    app: &Installation,
    request: &ProfileSetRequest,
    progress: &dyn Progress,
) -> Result<ProfileSetResponse, PlanningError> {
    progress.stage("writing a profile");
    let wrong = |name, value: &str, expected| PlanningError::Value {
        input: Some(InputName::ProfileValues),
        name,
        value: format!("'{value}'"),
        expected,
    };
    if request.source.trim().is_empty() {
        return Err(wrong("the source", "", "where the values come from"));
    }
    let is_there = Kind::ALL
        .into_iter()
        .filter(|kind| request.kind.is_none_or(|wanted| wanted == *kind))
        .any(|kind| app.library.list(kind).iter().any(|listing| listing.id == request.id));
    let (mut profile, created) = match &request.from {
        Some(from) if !is_there => {
            let kind = app.kind_of(from, request.kind)?;
            (OwnProfile::new(app, kind, &request.id, from, (&request.folder, false))?, true)
        }
        _ => (OwnProfile::open(app, app.kind_of(&request.id, request.kind)?, &request.id)?, false),
    };
    let of = if created { request.from.as_deref().unwrap_or_default() } else { &request.id };
    let before = app.library.explain(profile.kind, of)?.values;
    let schema = schema(profile.kind);
    let mut values = Vec::new();
    for assignment in &request.values {
        let expected = "a key and a value, such as bend.orbit_offset_mm=11.6";
        let (key, text) = assignment.split_once('=').ok_or_else(|| wrong("a value", assignment, expected))?;
        let (key, text) = (key.trim(), text.trim());
        let value: Value = serde_json::from_str(text).unwrap_or_else(|_| json!(text));
        if value.is_string() && is_figure(&schema, key) && is_number(&schema, key) {
            let expected = "a number, with a point before its decimals; its unit is in the name of the key";
            return Err(wrong("a value", assignment, expected));
        }
        let found = before.iter().find(|value| value.key == key);
        let found = found.map(|value| value.value.clone()).unwrap_or_default();
        let source = (request.source.as_str(), request.measured);
        let was = if let Some(name) = key.strip_prefix("shapes.") {
            let parents = before.iter().find(|value| value.key == "shapes").map(|value| &value.value);
            bodies::set_body(&mut profile, parents, name, &value, source)?
        } else {
            profile.set(key, stated(&schema, key, value.clone(), source))?;
            found
        };
        values.push(SetValue { key: key.to_owned(), before: was, value });
    }
    profile.check(app)?;
    let kind = profile.kind;
    Ok(ProfileSetResponse { id: request.id.clone(), kind, file: profile.save()?, created, values })
}

/// An installation in which a profile of the person's own has these values, by dotted key: nothing is written.
pub fn tried(
    app: &Installation,
    kind: Kind,
    id: &str,
    values: &[(&str, &Value)],
) -> Result<Installation, PlanningError> {
    let mut profile = OwnProfile::open(app, kind, id)?;
    let schema = schema(kind);
    for (key, value) in values {
        profile.set(key, stated(&schema, key, (*value).clone(), ("not written yet", false)))?;
    }
    app.with_profile(&profile)
}

/// A value as a file has it: with its source, where it has none of its own.
fn stated(schema: &Value, key: &str, mut value: Value, (source, measured): (&str, bool)) -> Value {
    if is_figure(schema, key) && !value.is_object() && !value.is_null() {
        return sourced(&value, source, measured);
    }
    match (key, &mut value) {
        ("springback", Value::Object(loss)) if loss.contains_key("angle_deg") => {
            if let Some(angle) = loss.get_mut("angle_deg").filter(|angle| !angle.is_object()) {
                *angle = sourced(angle, source, measured);
            }
        }
        ("springback" | "head" | "workspace", Value::Object(whole)) => {
            bodies::with_source(whole, (source, measured));
        }
        ("shapes", Value::Array(shapes)) => {
            let shapes = shapes.iter_mut().filter_map(Value::as_object_mut);
            shapes.for_each(|shape| bodies::with_source(shape, (source, measured)));
        }
        _ => {}
    }
    value
}

/// Sets one value of a profile of the person's own as it is, without a source, or takes it out.
pub fn replace(
    app: &Installation,
    (kind, id): (Kind, &str),
    key: &str,
    value: Option<Value>,
) -> Result<PathBuf, PlanningError> {
    let mut profile = OwnProfile::open(app, kind, id)?;
    match value {
        Some(value) => profile.set(key, value)?,
        // What is not there need not be taken out.
        None => profile.remove(key).unwrap_or_default(),
    }
    profile.check(app)?;
    profile.save()
}

/// A figure with its source.
pub(crate) fn sourced(value: &Value, source: &str, measured: bool) -> Value {
    json!({ "value": value, "source": source, "measured": measured })
}

/// Whether a schema has a figure with a source under a dotted key.
fn is_figure(schema: &Value, key: &str) -> bool {
    let properties = properties_of(schema, key);
    ["value", "source", "measured"].iter().all(|key| properties.is_some_and(|all| all.get(key).is_some()))
}

/// Whether that is a number.
fn is_number(schema: &Value, key: &str) -> bool {
    let value = properties_of(schema, key).and_then(|all| all.get("value"));
    value.is_some_and(|value| resolved(schema, value).get("type") == Some(&json!("number")))
}

/// What may stand under a dotted key.
fn properties_of<'a>(schema: &'a Value, key: &str) -> Option<&'a Value> {
    let mut at = schema;
    for part in key.split('.') {
        at = resolved(schema, at).get("properties")?.get(part)?;
    }
    resolved(schema, at).get("properties")
}

/// What a part of a schema stands for: an optional value is one of two, a shared one is named.
fn resolved<'a>(schema: &'a Value, part: &'a Value) -> &'a Value {
    let mut at = part;
    loop {
        let any = at.get("anyOf").and_then(Value::as_array);
        let one = any.and_then(|all| all.iter().find(|one| one.get("$ref").is_some())).unwrap_or(at);
        let name = one.get("$ref").and_then(Value::as_str).and_then(|name| name.strip_prefix('#'));
        match name.and_then(|pointer| schema.pointer(pointer)) {
            Some(named) => at = named,
            None => return one,
        }
    }
}
