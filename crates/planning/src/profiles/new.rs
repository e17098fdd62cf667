//! `profile new`: a profile that inherits from a known one, for a person to put their figures into.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_error::InputName;
use wirebend_files::document::DocumentError;
use wirebend_profile::{Child, Kind, ProfileError, is_slug};

use crate::output::Output;
use crate::{Installation, PlanningError, Progress};

/// What to write.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ProfileNewRequest {
    pub id: String,
    /// The id to inherit from.
    pub inherits: String,
    /// The kind of both, where several kinds have a profile with the parent's id.
    pub kind: Option<Kind>,
    /// A name for people; the new id if absent.
    pub name: Option<String>,
    /// Whether to write every value of the parent, to be changed; otherwise the heading alone.
    #[serde(default)]
    pub all: bool,
    /// Where it goes.
    pub place: ProfilePlace,
    /// Whether a file that is there may be replaced.
    #[serde(default)]
    pub force: bool,
}

/// Where a new profile goes.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ProfilePlace {
    /// Into a profile folder, below the folder of its kind, named by its id. What is missing is created.
    Folder(PathBuf),
    File(PathBuf),
    /// Back to the front end.
    Returned,
}

#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct ProfileNewResponse {
    pub id: String,
    pub kind: Kind,
    /// Its file; null where it is returned.
    pub file: Option<PathBuf>,
    /// The id of its parent.
    pub inherits: String,
    /// Its text, where it was not written to a file.
    #[serde(skip)]
    pub contents: Vec<u8>,
}

pub fn new(
    app: &Installation,
    request: &ProfileNewRequest,
    progress: &dyn Progress,
) -> Result<ProfileNewResponse, PlanningError> {
    progress.stage("writing a profile");
    let (id, inherits) = (&request.id, &request.inherits);
    check_id(id)?;
    check_name(request)?;
    let kind = app.kind_of(inherits, request.kind)?;
    let path = match &request.place {
        ProfilePlace::Folder(folder) => Some(folder.join(kind.folder()).join(format!("{id}.json"))),
        ProfilePlace::File(path) => Some(path.clone()),
        ProfilePlace::Returned => None,
    };
    app.check_free(kind, id, path.as_deref())?;
    let output = path.map(|path| Output { path, force: request.force });
    let is_own = matches!(request.place, ProfilePlace::Folder(_));
    let check = if is_own { Output::check_overwrites } else { Output::check };
    output.as_ref().map_or(Ok(()), check)?;

    let schema = output.as_ref().and_then(|output| schema_beside(&output.path, kind));
    let name = request.name.as_deref().unwrap_or(id);
    let all = request.all;
    let text = app.library.child_text(&Child { kind, id, inherits, name, schema: schema.as_deref(), all })?;
    let file =
        output.as_ref().map_or_else(|| format!("{id}.json"), |output| output.path.display().to_string());
    let checked = app.library.check(&file, &text).map_err(|errors| app.refusal(kind, inherits, errors))?;
    app.asked_of_drivers(&checked, &file, &text)?;

    if let Some(output) = output.as_ref().filter(|_| is_own) {
        make_folder(&output.path)?;
    }
    let written = output.map(|output| output.save(text.as_bytes())).transpose()?;
    let contents = if written.is_none() { text.into_bytes() } else { Vec::new() };
    Ok(ProfileNewResponse { id: id.clone(), kind, file: written, inherits: inherits.clone(), contents })
}

/// Refuses an id before it becomes part of a path.
pub(super) fn check_id(id: &str) -> Result<(), PlanningError> {
    if is_slug(id) {
        return Ok(());
    }
    Err(PlanningError::Value {
        input: Some(InputName::ProfileId),
        name: "the new id",
        value: format!("'{id}'"),
        expected: "lower-case letters, digits and single hyphens, such as my-bender",
    })
}

fn check_name(request: &ProfileNewRequest) -> Result<(), PlanningError> {
    if request.name.as_ref().is_some_and(|name| name.trim().is_empty()) {
        return Err(PlanningError::Value {
            input: Some(InputName::ProfileName),
            name: "the name",
            value: "empty".to_owned(),
            expected: "a name for people, or none to use the id",
        });
    }
    Ok(())
}

/// The path from a profile's file to its schema, where the schema lies as it does beside the shipped
/// profiles.
pub(super) fn schema_beside(file: &Path, kind: Kind) -> Option<String> {
    let schema = format!("../schema/{kind}.schema.json");
    let folder = file.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    // A folder that is yet to be created has no way up: `..` is worked out from its name.
    let made = folder
        .parent()
        .filter(|_| !folder.exists())
        .map(|root| root.join(format!("schema/{kind}.schema.json")));
    made.unwrap_or_else(|| folder.join(&schema)).is_file().then_some(schema)
}

pub(super) fn make_folder(file: &Path) -> Result<(), PlanningError> {
    let Some(folder) = file.parent() else { return Ok(()) };
    std::fs::create_dir_all(folder).map_err(|error| {
        PlanningError::Document(DocumentError::Save { path: folder.display().to_string(), error })
    })
}

impl Installation {
    /// Refuses an id that another file has. The file that is to be replaced may have it.
    pub(super) fn check_free(&self, kind: Kind, id: &str, path: Option<&Path>) -> Result<(), PlanningError> {
        let Some(taken) = self.library.list(kind).into_iter().find(|listing| listing.id == id) else {
            return Ok(());
        };
        let real = |path: &Path| path.canonicalize().ok();
        let is_same = path.is_some_and(|path| {
            !taken.shipped && real(path).is_some_and(|path| Some(path) == real(Path::new(&taken.file)))
        });
        if is_same {
            return Ok(());
        }
        Err(PlanningError::IdTaken { kind, id: id.to_owned(), file: taken.file })
    }

    /// Why a new profile cannot be used: first of all, what its parents leave open.
    fn refusal(&self, kind: Kind, parent: &str, errors: Vec<ProfileError>) -> PlanningError {
        let missing: Vec<String> = errors
            .iter()
            .filter_map(|error| match error {
                ProfileError::Missing { how, .. } => Some(how.clone()),
                _ => None,
            })
            .collect();
        let first = errors.into_iter().next();
        match first.filter(|_| missing.is_empty()) {
            Some(error) => PlanningError::Profile(error),
            None => PlanningError::OpenParent {
                kind,
                parent: parent.to_owned(),
                missing,
                complete: self.complete_children(kind, parent),
            },
        }
    }

    /// The ids of the complete profiles that inherit from one.
    fn complete_children(&self, kind: Kind, parent: &str) -> Vec<String> {
        let inherits = |id: &str| {
            let explained = self.library.explain(kind, id);
            explained.is_ok_and(|found| found.chain.iter().any(|ancestor| ancestor.id == parent))
        };
        let complete = self.library.list(kind).into_iter().filter(|listing| !listing.is_abstract);
        complete.map(|listing| listing.id).filter(|id| inherits(id)).collect()
    }
}
