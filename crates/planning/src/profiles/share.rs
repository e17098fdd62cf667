//! A profile as one file that another person can use, and such a file taken in.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use wirebend_files::read::read_file;
use wirebend_profile::{Kind, ProfileError};

use super::own::OwnProfile;
use crate::output::Output;
use crate::{Installation, PlanningError, Progress};

/// Which profile another person shall have.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ProfileExportRequest {
    pub id: String,
    /// The kind of profile, where several kinds have one of the id.
    pub kind: Option<Kind>,
    /// Its file; absent, the profile goes back to the front end.
    pub output: Option<Output>,
}

#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct ProfileExportResponse {
    pub id: String,
    pub kind: Kind,
    /// Its file; null where it is returned.
    pub file: Option<PathBuf>,
    /// Its text, where it was not written to a file.
    #[serde(skip)]
    pub contents: Vec<u8>,
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
    /// Where it is now.
    pub file: PathBuf,
}

/// `profile export`.
pub fn export_profile(
    app: &Installation,
    request: &ProfileExportRequest,
    progress: &dyn Progress,
) -> Result<ProfileExportResponse, PlanningError> {
    progress.stage("writing a profile");
    let kind = app.kind_of(&request.id, request.kind)?;
    let (file, contents) = match &request.output {
        Some(output) => (Some(export(app, kind, &request.id, output)?), Vec::new()),
        None => (None, app.library.portable_text(kind, &request.id)?.into_bytes()),
    };
    Ok(ProfileExportResponse { id: request.id.clone(), kind, file, contents })
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

/// Writes a profile with all that it has from other profiles of the person's own.
pub fn export(app: &Installation, kind: Kind, id: &str, output: &Output) -> Result<PathBuf, PlanningError> {
    output.save(app.library.portable_text(kind, id)?.as_bytes())
}

/// Takes a file in as a profile of the person's own, under its own id or another one. Refused as a new profile is, where the
/// id is taken or the file cannot be used.
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
    // What is no profile is refused with its line: from here on it has a kind and an id. What its file is called does not matter.
    match app.library.with(&name, &text) {
        Ok(_) | Err(ProfileError::IdNotFileName { .. }) => {}
        Err(error) => return Err(error.into()),
    }
    let mut values: Map<String, Value> = serde_json::from_str(text.trim_start_matches('\u{feff}'))?;
    let kind: Kind = serde_json::from_value(values.get("kind").cloned().unwrap_or_default())?;
    if let Some(id) = id {
        values.insert("id".to_owned(), id.into());
    }
    let id = values.get("id").and_then(Value::as_str).unwrap_or_default().to_owned();
    let own = OwnProfile::taken_in(app, kind, &id, values, folder)?;
    own.check(app)?;
    Ok(ProfileImportResponse { id, kind, file: own.save()? })
}
