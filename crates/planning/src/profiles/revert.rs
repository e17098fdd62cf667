//! `profile revert`: takes back single values of a profile of the person's own, or its last change as a whole.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_profile::Kind;

use super::history::LastChange;
use super::own::OwnProfile;
use super::set::SetValue;
use crate::{Installation, PlanningError, Progress};

/// What to take back.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ProfileRevertRequest {
    pub id: String,
    /// The kind of profile, where several kinds have one of the id.
    pub kind: Option<Kind>,
    /// Dotted keys that are to be as in the parent again; none: the last change of the profile, which another revert makes
    /// again.
    #[serde(default)]
    pub keys: Vec<String>,
}

#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct ProfileRevertResponse {
    pub id: String,
    pub kind: Kind,
    /// Its file.
    pub file: PathBuf,
    /// What differs now.
    pub values: Vec<SetValue>,
}

pub fn revert(
    app: &Installation,
    request: &ProfileRevertRequest,
    progress: &dyn Progress,
) -> Result<ProfileRevertResponse, PlanningError> {
    progress.stage("writing a profile");
    let kind = app.kind_of(&request.id, request.kind)?;
    let mut profile = OwnProfile::open(app, kind, &request.id)?;
    if request.keys.is_empty() {
        profile.replace(&LastChange::of(kind, &request.id, profile.file())?.before)?;
    } else {
        request.keys.iter().try_for_each(|key| profile.remove(key))?;
    }
    profile.check(app)?;
    let (before, after) = (app, &app.with_profile(&profile)?);
    let values = differences(before, after, kind, &request.id)?;
    Ok(ProfileRevertResponse { id: request.id.clone(), kind, file: profile.save()?, values })
}

/// What a profile has otherwise in another installation.
fn differences(
    before: &Installation,
    after: &Installation,
    kind: Kind,
    id: &str,
) -> Result<Vec<SetValue>, PlanningError> {
    let [old, new] = [before, after].map(|app| app.library.explain(kind, id).map(|found| found.values));
    let (old, new) = (old?, new?);
    let keys = new.iter().chain(old.iter().filter(|old| new.iter().all(|new| new.key != old.key)));
    let value = |values: &[wirebend_profile::ExplainedValue], key: &str| {
        values.iter().find(|value| value.key == key).map(|value| value.value.clone()).unwrap_or_default()
    };
    let changed = keys.filter_map(|one| {
        let (before, value) = (value(&old, &one.key), value(&new, &one.key));
        (before != value).then(|| SetValue { key: one.key.clone(), before, value })
    });
    Ok(changed.collect())
}
