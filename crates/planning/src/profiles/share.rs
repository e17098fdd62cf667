//! A profile as one file that another person can use, and such a file taken in.

use std::path::{Path, PathBuf};

use serde_json::Value;
use wirebend_files::read::read_file;
use wirebend_profile::Kind;

use super::own::OwnProfile;
use crate::output::Output;
use crate::{Installation, PlanningError};

/// Writes a profile with all that it has from other profiles of the person's own.
pub fn export(app: &Installation, kind: Kind, id: &str, output: &Output) -> Result<PathBuf, PlanningError> {
    output.save(app.library.portable_text(kind, id)?.as_bytes())
}

/// Takes a file in as a profile of the person's own, under its own id or another one. Refused as a new profile is, where the
/// id is taken or the file cannot be used. Gives its kind and id.
pub fn import(
    app: &Installation,
    file: &Path,
    id: Option<&str>,
    folder: &Path,
) -> Result<(Kind, String), PlanningError> {
    let wrong = |name, found: &Value, expected| PlanningError::Value {
        input: None,
        name,
        value: found.to_string(),
        expected,
    };
    let mut profile: Value = serde_json::from_slice(&read_file(file)?)?;
    let Some(kind) = Kind::ALL.into_iter().find(|kind| profile["kind"] == kind.word()) else {
        return Err(wrong("the kind of the file", &profile["kind"], "a profile of a machine or a wire"));
    };
    if let Some(id) = id {
        profile["id"] = id.into();
    }
    let Some(id) = profile["id"].as_str().map(str::to_owned) else {
        return Err(wrong("the id of the file", &profile["id"], "the id of a profile"));
    };
    let Value::Object(values) = profile else {
        return Err(wrong("the file", &Value::Null, "a profile"));
    };
    let own = OwnProfile::taken_in(app, kind, &id, values, folder)?;
    own.check(app)?;
    own.save()?;
    Ok((kind, id))
}
