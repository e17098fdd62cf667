//! A profile as one file that another person can use, and such a file taken in. The file has with it what the profile names of the
//! person's own, such as the wire of a machine with its springback.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use wirebend_files::read::read_file;
use wirebend_profile::{Kind, ProfileError};

use super::own::OwnProfile;
use crate::output::Output;
use crate::{Installation, PlanningError, Progress};

/// The key under which such a file has the other profiles.
const WITH: &str = "profiles";

/// Which profile another person shall have.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ProfileExportRequest {
    pub id: String,
    /// The kind of profile, where several kinds have one of the id.
    pub kind: Option<Kind>,
    /// Its file; absent, the profile goes back to the front end.
    pub output: Option<Output>,
    /// Without the other profiles of the person's own that it names.
    #[serde(default)]
    pub alone: bool,
}

#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct ProfileExportResponse {
    pub id: String,
    pub kind: Kind,
    /// Its file; null where it is returned.
    pub file: Option<PathBuf>,
    /// Other profiles that are in the file.
    pub with: Vec<SharedProfile>,
    /// Its text, where it was not written to a file.
    #[serde(skip)]
    pub contents: Vec<u8>,
}

/// A profile that goes with another one.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct SharedProfile {
    pub kind: Kind,
    pub id: String,
}

/// A file that is to become a profile of the person's own.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ProfileImportRequest {
    pub file: PathBuf,
    /// Another id than that of the file.
    pub id: Option<String>,
    /// The folder with profiles of the person's own.
    pub folder: PathBuf,
}

#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct ProfileImportResponse {
    pub id: String,
    pub kind: Kind,
    /// Its name for people.
    pub name: String,
    /// Where it is now.
    pub file: PathBuf,
    /// Other profiles that came with it, under the ids that they have here.
    pub with: Vec<SharedProfile>,
}

/// `profile export`.
pub fn export_profile(
    app: &Installation,
    request: &ProfileExportRequest,
    progress: &dyn Progress,
) -> Result<ProfileExportResponse, PlanningError> {
    progress.stage("writing a profile");
    let kind = app.kind_of(&request.id, request.kind)?;
    let named = if request.alone { Vec::new() } else { app.library.own_named(kind, &request.id)? };
    let text = portable(app, kind, &request.id, &named)?;
    let (file, contents) = match &request.output {
        Some(output) => (Some(output.save(text.as_bytes())?), Vec::new()),
        None => (None, text.into_bytes()),
    };
    let with = named.into_iter().map(|(kind, id)| SharedProfile { kind, id }).collect();
    Ok(ProfileExportResponse { id: request.id.clone(), kind, file, with, contents })
}

/// `profile import`.
pub fn import_profile(
    app: &Installation,
    request: &ProfileImportRequest,
    progress: &dyn Progress,
) -> Result<ProfileImportResponse, PlanningError> {
    progress.stage("writing a profile");
    import(app, &request.file, request.id.as_deref(), &request.folder)
}

/// A profile with all that it has from other profiles of the person's own, and those that it names at its end.
fn portable(
    app: &Installation,
    kind: Kind,
    id: &str,
    named: &[(Kind, String)],
) -> Result<String, PlanningError> {
    let text = app.library.portable_text(kind, id)?;
    if named.is_empty() {
        return Ok(text);
    }
    let mut others = Vec::with_capacity(named.len());
    for (kind, id) in named {
        let other = app.library.portable_text(*kind, id)?;
        let lines: Vec<String> = other.lines().map(|line| format!("    {line}")).collect();
        others.push(lines.join("\n"));
    }
    // A figure stays on a line of its own, as in the profiles themselves.
    let body = text.trim_end().strip_suffix('}').unwrap_or(&text).trim_end();
    Ok(format!("{body},\n  \"{WITH}\": [\n{}\n  ]\n}}\n", others.join(",\n")))
}

/// Takes a file in as a profile of the person's own, under its own id or another one. Refused as a new profile is, where the
/// id is taken or the file cannot be used. What comes with it is taken in too, under another id where its own is another profile's.
pub fn import(
    app: &Installation,
    file: &Path,
    id: Option<&str>,
    folder: &Path,
) -> Result<ProfileImportResponse, PlanningError> {
    let name = file.display().to_string();
    let text = String::from_utf8(read_file(file)?).map_err(|error| ProfileError::NotText {
        file: name.clone(),
        byte: error.utf8_error().valid_up_to(),
    })?;
    let (text, others) = apart(&text);
    let mut values = as_profile(app, &name, &text)?;
    if let Some(id) = id {
        values.insert("id".to_owned(), id.into());
    }
    let id = values.get("id").and_then(Value::as_str).unwrap_or_default().to_owned();
    let kind = kind_of(&values)?;
    // Refused before anything is written.
    app.check_free(kind, &id, None)?;
    let mut app = app.with_library(app.library.clone());
    let (mut with, mut new) = (Vec::new(), Vec::new());
    for other in &others {
        let other = as_profile(&app, &name, &other.to_string())?;
        let (other_kind, own_id) = (kind_of(&other)?, text_of(&other, "id"));
        let shared = match app.place_of(other_kind, &own_id, &other)? {
            SharedPlace::Known => own_id.clone(),
            SharedPlace::Free(id) => {
                let mut renamed = other;
                renamed.insert("id".to_owned(), id.as_str().into());
                let own = OwnProfile::taken_in(&app, other_kind, &id, renamed, folder)?;
                own.check(&app)?;
                app = app.with_profile(&own)?;
                new.push(own);
                id
            }
        };
        rename(&mut values, other_kind, &own_id, &shared);
        with.push(SharedProfile { kind: other_kind, id: shared });
    }
    let own = OwnProfile::taken_in(&app, kind, &id, values, folder)?;
    own.check(&app)?;
    let app = app.with_profile(&own)?;
    let listed = app.library.list(kind).into_iter().find(|listing| listing.id == id);
    let name = listed.map_or_else(|| id.clone(), |listing| listing.name);
    // What it names is there before it.
    new.into_iter().try_for_each(|own| own.save().map(drop))?;
    Ok(ProfileImportResponse { id, kind, name, file: own.save()?, with })
}

/// The text of the profile itself, and the others that are in the file. A text that is no JSON stays as it is, to be refused with its line.
fn apart(text: &str) -> (String, Vec<Value>) {
    let parsed = serde_json::from_str::<Map<String, Value>>(text.trim_start_matches('\u{feff}'));
    let Ok(mut values) = parsed else { return (text.to_owned(), Vec::new()) };
    match values.remove(WITH) {
        Some(Value::Array(others)) => (Value::from(values).to_string(), others),
        _ => (text.to_owned(), Vec::new()),
    }
}

/// The values of a text that is a profile. What its file is called does not matter.
fn as_profile(app: &Installation, name: &str, text: &str) -> Result<Map<String, Value>, PlanningError> {
    // What is no profile is refused with its line: from here on it has a kind and an id.
    match app.library.with(name, text) {
        Ok(_) | Err(ProfileError::IdNotFileName { .. }) => {}
        Err(error) => return Err(error.into()),
    }
    Ok(serde_json::from_str(text.trim_start_matches('\u{feff}'))?)
}

fn kind_of(values: &Map<String, Value>) -> Result<Kind, PlanningError> {
    Ok(serde_json::from_value(values.get("kind").cloned().unwrap_or_default())?)
}

fn text_of(values: &Map<String, Value>, key: &str) -> String {
    values.get(key).and_then(Value::as_str).unwrap_or_default().to_owned()
}

/// Has a profile name another one by the id that it has here.
fn rename(values: &mut Map<String, Value>, kind: Kind, from: &str, to: &str) {
    let key = if kind == Kind::Noise { "error" } else { "default_material" };
    let Some(named) = values.get_mut(key) else { return };
    let named = match named {
        Value::Object(stated) => stated.get_mut("value"),
        plain => Some(plain),
    };
    if let Some(named) = named.filter(|named| named.as_str() == Some(from)) {
        *named = to.into();
    }
}

/// Where a profile that comes with another one goes.
enum SharedPlace {
    /// The same profile is there already.
    Known,
    /// Under this id.
    Free(String),
}

impl Installation {
    /// Its own id where that is free, else the next number behind it.
    fn place_of(
        &self,
        kind: Kind,
        id: &str,
        values: &Map<String, Value>,
    ) -> Result<SharedPlace, PlanningError> {
        let taken: Vec<String> = self.library.list(kind).into_iter().map(|listing| listing.id).collect();
        if taken.iter().any(|taken| taken == id) {
            let there: Value = serde_json::from_str(&self.library.portable_text(kind, id)?)?;
            if there.as_object() == Some(values) {
                return Ok(SharedPlace::Known);
            }
        }
        let numbered = (2..).map(|number| format!("{id}-{number}"));
        let mut ids = std::iter::once(id.to_owned()).chain(numbered);
        Ok(SharedPlace::Free(ids.find(|id| !taken.contains(id)).unwrap_or_default()))
    }
}
