//! Profiles of machines and wires as a person edits them: values with their sources, taken back one by one or by the last change,
//! copied, and passed on as files.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use wirebend_planning::profiles::head::HeadReport;
use wirebend_planning::profiles::history::has_last_change;
use wirebend_planning::profiles::revert::revert;
use wirebend_planning::profiles::{explain, new, set, share};
use wirebend_profile::{Kind, Shape};

use super::Workspace;
use crate::{
    ApiError, ProfileExplainRequest, ProfileExplainResponse, ProfileExportRequest, ProfileExportResponse,
    ProfileImportResponse, ProfileNewRequest, ProfileNewResponse, ProfilePlace, ProfileRevertRequest,
    ProfileSetRequest, Progress,
};

/// Writes a profile of the person's own that inherits from another.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct CopyProfile {
    pub kind: Kind,
    /// The one to inherit from.
    pub from: String,
    /// The id of the new one.
    pub id: String,
    pub name: String,
}

/// Asks for a profile with what its editor needs.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ProfileViewRequest {
    pub kind: Kind,
    pub id: String,
    /// The wire that the head of a machine is drawn with; absent: its own.
    pub material: Option<String>,
}

/// A profile with what its editor needs.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct ProfileView {
    pub profile: ProfileExplainResponse,
    /// Whether it comes with the program: then it cannot be changed, but copied.
    pub shipped: bool,
    pub file: String,
    /// Whether its last change can be taken back.
    pub has_last_change: bool,
    /// Of a machine its bend head; absent where its figures make none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub head: Option<HeadReport>,
    /// Of a machine its bodies.
    pub shapes: Vec<Shape>,
}

/// A value to set.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct NewValue {
    /// Dotted key.
    pub key: String,
    /// The plain value; of a figure without its source.
    pub value: Value,
}

/// Asks how the bend head of a machine of the person's own would be with values that are typed and not written yet.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct HeadRequest {
    pub id: String,
    pub values: Vec<NewValue>,
    /// As in [`ProfileViewRequest`].
    pub material: Option<String>,
}

/// Sets values of a profile of the person's own.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct SetProfile {
    pub kind: Kind,
    pub id: String,
    pub values: Vec<NewValue>,
    /// Where the values come from.
    pub source: String,
    /// Whether they were measured on the machine or the wire.
    pub measured: bool,
    /// As in [`ProfileViewRequest`].
    pub material: Option<String>,
}

/// Takes back values of a profile of the person's own.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct RevertProfile {
    pub kind: Kind,
    pub id: String,
    /// Dotted keys; none: the last change as a whole.
    pub keys: Vec<String>,
    /// As in [`ProfileViewRequest`].
    pub material: Option<String>,
}

/// Takes in a profile from a file.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ImportProfile {
    pub file: PathBuf,
    /// Another id than that of the file.
    pub id: Option<String>,
}

impl Workspace {
    pub(crate) fn copy_profile(
        &self,
        asked: &CopyProfile,
        progress: &dyn Progress,
    ) -> Result<ProfileNewResponse, ApiError> {
        let request = ProfileNewRequest {
            id: asked.id.clone(),
            inherits: asked.from.clone(),
            kind: Some(asked.kind),
            name: Some(asked.name.clone()),
            all: false,
            place: ProfilePlace::Folder(self.own_folder()?),
            force: false,
        };
        let made = new::new(&self.installation(), &request, progress)?;
        self.reload()?;
        Ok(made)
    }

    pub(crate) fn profile_view(
        &self,
        asked: &ProfileViewRequest,
        progress: &dyn Progress,
    ) -> Result<ProfileView, ApiError> {
        let app = self.installation();
        let request = ProfileExplainRequest { id: asked.id.clone(), kind: Some(asked.kind) };
        let profile = explain::explain(&app, &request, progress)?;
        let (shipped, file) =
            profile.chain.first().map(|own| (own.shipped, own.file.clone())).unwrap_or_default();
        let machine = (asked.kind == Kind::Machine && !profile.is_abstract).then_some(&asked.id);
        let shapes = machine.map(|id| app.library.machine(id)).transpose()?;
        Ok(ProfileView {
            has_last_change: !shipped && has_last_change(asked.kind, &asked.id, Path::new(&file)),
            head: machine.and_then(|id| app.head(id, asked.material.as_deref()).ok()),
            shapes: shapes.and_then(|machine| machine.profile.shapes).unwrap_or_default(),
            profile,
            shipped,
            file,
        })
    }

    pub(crate) fn head(&self, asked: &HeadRequest, _: &dyn Progress) -> Result<HeadReport, ApiError> {
        let values: Vec<(&str, &Value)> =
            asked.values.iter().map(|NewValue { key, value }| (key.as_str(), value)).collect();
        let tried = set::tried(&self.installation(), Kind::Machine, &asked.id, &values)?;
        Ok(tried.head(&asked.id, asked.material.as_deref())?)
    }

    pub(crate) fn set_profile(
        &self,
        asked: &SetProfile,
        progress: &dyn Progress,
    ) -> Result<ProfileView, ApiError> {
        let request = ProfileSetRequest {
            id: asked.id.clone(),
            from: None,
            kind: Some(asked.kind),
            values: asked.values.iter().map(|NewValue { key, value }| format!("{key}={value}")).collect(),
            source: asked.source.clone(),
            measured: asked.measured,
            folder: self.own_folder()?,
        };
        set::set(&self.installation(), &request, progress)?;
        self.reload()?;
        self.profile_view(&view_of(asked.kind, &asked.id, asked.material.as_ref()), progress)
    }

    pub(crate) fn revert_profile(
        &self,
        asked: &RevertProfile,
        progress: &dyn Progress,
    ) -> Result<ProfileView, ApiError> {
        let (id, keys) = (asked.id.clone(), asked.keys.clone());
        let request = ProfileRevertRequest { id, kind: Some(asked.kind), keys };
        revert(&self.installation(), &request, progress)?;
        self.reload()?;
        self.profile_view(&view_of(asked.kind, &asked.id, asked.material.as_ref()), progress)
    }

    pub(crate) fn export_profile(
        &self,
        asked: &ProfileExportRequest,
        progress: &dyn Progress,
    ) -> Result<ProfileExportResponse, ApiError> {
        Ok(share::export_profile(&self.installation(), asked, progress)?)
    }

    pub(crate) fn import_profile(
        &self,
        asked: &ImportProfile,
        _: &dyn Progress,
    ) -> Result<ProfileImportResponse, ApiError> {
        let folder = self.own_folder()?;
        let taken = share::import(&self.installation(), &asked.file, asked.id.as_deref(), &folder)?;
        self.reload()?;
        Ok(taken)
    }

    /// The folder with profiles of the person's own.
    pub(super) fn own_folder(&self) -> Result<PathBuf, ApiError> {
        self.places().own.clone().ok_or(ApiError::NoOwnFolder)
    }
}

fn view_of(kind: Kind, id: &str, material: Option<&String>) -> ProfileViewRequest {
    ProfileViewRequest { kind, id: id.to_owned(), material: material.cloned() }
}
