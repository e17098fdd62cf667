//! `profile set`: values of a profile of the person's own, each with its source.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, json};
use wirebend_error::InputName;
use wirebend_files::read::read_file;
use wirebend_profile::{Child, Kind, schema, written};

use super::new::{check_id, make_folder, schema_beside};
use crate::output::Output;
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
        let found = before.iter().find(|value| value.key == key);
        values.push(SetValue {
            key: key.to_owned(),
            before: found.map(|value| value.value.clone()).unwrap_or_default(),
            value: value.clone(),
        });
        let value = if is_figure(&schema, key) && !value.is_object() && !value.is_null() {
            sourced(&value, &request.source, request.measured)
        } else {
            value
        };
        profile.set(key, value)?;
    }
    profile.check(app)?;
    let kind = profile.kind;
    Ok(ProfileSetResponse { id: request.id.clone(), kind, file: profile.save()?, created, values })
}

/// A figure with its source.
pub(crate) fn sourced(value: &Value, source: &str, measured: bool) -> Value {
    json!({ "value": value, "source": source, "measured": measured })
}

/// Whether a schema has a figure with a source under a dotted key.
fn is_figure(schema: &Value, key: &str) -> bool {
    let mut at = schema;
    for part in key.split('.') {
        let Some(next) = resolved(schema, at).get("properties").and_then(|all| all.get(part)) else {
            return false;
        };
        at = next;
    }
    let properties = resolved(schema, at).get("properties");
    ["value", "source", "measured"].iter().all(|key| properties.is_some_and(|all| all.get(key).is_some()))
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

/// A profile of the person's own that is being written.
pub(crate) struct OwnProfile {
    pub kind: Kind,
    file: PathBuf,
    values: Map<String, Value>,
    force: bool,
}

impl OwnProfile {
    /// A new one in a folder of profiles, that inherits from a known one and changes nothing yet. `force` lets it replace
    /// one that is there.
    pub fn new(
        app: &Installation,
        kind: Kind,
        id: &str,
        inherits: &str,
        (folder, force): (&Path, bool),
    ) -> Result<Self, PlanningError> {
        check_id(id)?;
        let file = folder.join(kind.folder()).join(format!("{id}.json"));
        app.check_free(kind, id, Some(&file))?;
        Output { path: file.clone(), force }.check()?;
        let beside = schema_beside(&file, kind);
        let child = Child { kind, id, inherits, name: id, schema: beside.as_deref(), all: false };
        let text = app.library.child_text(&child)?;
        Ok(Self { kind, file, values: serde_json::from_str(&text)?, force })
    }

    /// One that is there.
    pub fn open(app: &Installation, kind: Kind, id: &str) -> Result<Self, PlanningError> {
        let chain = app.library.explain(kind, id)?.chain;
        let own = chain.into_iter().next().filter(|own| !own.shipped);
        let file = own.ok_or_else(|| PlanningError::ShippedProfile { id: id.to_owned() })?.file;
        let file = PathBuf::from(file);
        let values = serde_json::from_slice(&read_file(&file)?)?;
        Ok(Self { kind, file, values, force: true })
    }

    /// Sets a value under a dotted key; groups that are missing are made.
    pub fn set(&mut self, key: &str, value: Value) -> Result<(), PlanningError> {
        let mut parts: Vec<&str> = key.split('.').collect();
        let last = parts.pop().unwrap_or_default();
        let mut at = &mut self.values;
        for part in parts {
            let group = at.entry(part).or_insert_with(|| Value::Object(Map::new()));
            at = group.as_object_mut().ok_or_else(|| PlanningError::Value {
                input: Some(InputName::ProfileValues),
                name: "a key",
                value: format!("'{key}'"),
                expected: "a key of the profile, whose groups are apart by points",
            })?;
        }
        at.insert(last.to_owned(), value);
        Ok(())
    }

    fn text(&self) -> Result<String, PlanningError> {
        let text = serde_json::to_string_pretty(&self.values)? + "\n";
        Ok(written(self.kind, &text).unwrap_or(text))
    }

    /// Refuses what is no profile, by the rules and by the machine's driver.
    pub fn check(&self, app: &Installation) -> Result<(), PlanningError> {
        app.require_profile(&self.file.display().to_string(), &self.text()?)
    }

    /// Writes it.
    pub fn save(self) -> Result<PathBuf, PlanningError> {
        let text = self.text()?;
        make_folder(&self.file)?;
        Output { path: self.file, force: self.force }.save(text.as_bytes())
    }
}

impl Installation {
    /// This installation as it will be with one profile more.
    pub(crate) fn with_profile(&self, profile: &OwnProfile) -> Result<Self, PlanningError> {
        let library = self.library.with(&profile.file.display().to_string(), &profile.text()?)?;
        Ok(self.with_library(library))
    }
}
