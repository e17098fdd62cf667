//! A profile as one file that another person can use, and such a file taken in. The file has with it what the profile names of the
//! person's own, such as the wire of a machine with its springback.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;
use serde_json::{Map, Value};
use wirebend_files::read::read_file;
use wirebend_profile::{Kind, Listing, ProfileError};

use super::own::OwnProfile;
use crate::misnamed::PROFILE;
use crate::output::Output;
use crate::report::NoteReport;
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
    /// What a person should know.
    pub notes: Vec<NoteReport>,
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
    /// The name that it has in the file, where another profile here is called so.
    pub own_name: Option<String>,
    /// Whether it was there already, with nothing different: then nothing was written.
    pub known: bool,
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
    let notes = PROFILE.misnamed(request.output.as_ref()).into_iter().collect();
    Ok(ProfileExportResponse { id: request.id.clone(), kind, file, with, notes, contents })
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
/// What is there already is left as it is, and nothing is taken in twice.
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
    let parts = Parts::of(&text);
    let mut values = as_profile(app, &name, &parts.own)?;
    let kind = kind_of(&values)?;
    let mut app = app.with_library(app.library.clone());
    let (mut with, mut new) = (Vec::new(), Vec::new());
    for text in &parts.others {
        let mut other = as_profile(&app, &name, text)?;
        let (other_kind, own_id) = (kind_of(&other)?, text_of(&other, "id"));
        let shared = match app.place_of(other_kind, &own_id, &other)? {
            SharedPlace::Known(id) => id,
            SharedPlace::Free(id) => {
                app.rename(&mut other, other_kind, &id);
                let own = OwnProfile::taken_in(&app, other_kind, &id, other, folder)?;
                own.check(&app).map_err(|error| app.located(error, &name, text))?;
                app = app.with_profile(&own)?;
                new.push(own);
                id
            }
        };
        point_to(&mut values, other_kind, &own_id, &shared);
        with.push(SharedProfile { kind: other_kind, id: shared });
    }
    let own_id = text_of(&values, "id");
    if id.is_none()
        && let Some(listing) = app.same_as(kind, &own_id, &values)?
    {
        // What it brings may be new all the same.
        new.into_iter().try_for_each(|own| own.save().map(drop))?;
        let file = PathBuf::from(&listing.file);
        let (id, name) = (listing.id, listing.name);
        return Ok(ProfileImportResponse { id, kind, name, own_name: None, known: true, file, with });
    }
    let id = id.map_or(own_id, str::to_owned);
    app.check_free(kind, &id, None)?;
    let own_name = app.rename(&mut values, kind, &id);
    let own = OwnProfile::taken_in(&app, kind, &id, values, folder)?;
    own.check(&app).map_err(|error| app.located(error, &name, &parts.own))?;
    let app = app.with_profile(&own)?;
    let listed = app.library.list(kind).into_iter().find(|listing| listing.id == id);
    let name = listed.map_or_else(|| id.clone(), |listing| listing.name);
    // What it names is there before it.
    new.into_iter().try_for_each(|own| own.save().map(drop))?;
    Ok(ProfileImportResponse { id, kind, name, own_name, known: false, file: own.save()?, with })
}

/// The profiles of one file, each as a text in which everything is on the line that it has in the file.
pub(super) struct Parts {
    pub own: String,
    pub others: Vec<String>,
}

impl Parts {
    /// A text that is no JSON stays as it is, to be refused with its line.
    pub fn of(text: &str) -> Self {
        let text = text.trim_start_matches('\u{feff}');
        Self::apart(text).unwrap_or_else(|| Self { own: text.to_owned(), others: Vec::new() })
    }

    fn apart(text: &str) -> Option<Self> {
        let values: BTreeMap<String, &RawValue> = serde_json::from_str(text).ok()?;
        let list = values.get(WITH)?.get();
        let others: Vec<&RawValue> = serde_json::from_str(list).ok()?;
        // A raw value is a part of the text that it was read from.
        let at = |raw: &str| raw.as_ptr().addr() - text.as_ptr().addr();
        let (begin, end) = (at(list), at(list) + list.len());
        let key = text[..begin].rfind(&format!("\"{WITH}\""))?;
        let before = text[..key].trim_end();
        let after = text[end..].trim_start();
        let (from, to) = match (before.strip_suffix(','), after.strip_prefix(',')) {
            (Some(before), _) => (before.len(), end),
            (None, Some(after)) => (key, text.len() - after.len()),
            (None, None) => (key, end),
        };
        let own = [&text[..from], &blank(&text[from..to]), &text[to..]].concat();
        let others = others.into_iter().map(|raw| {
            let raw = raw.get();
            blank(&text[..at(raw)]) + raw
        });
        Some(Self { own, others: others.collect() })
    }
}

/// A text of spaces with the same lines.
fn blank(text: &str) -> String {
    text.chars().map(|letter| if letter == '\n' { letter } else { ' ' }).collect()
}

/// The values of a text that is a profile. What its file is called does not matter.
fn as_profile(app: &Installation, name: &str, text: &str) -> Result<Map<String, Value>, PlanningError> {
    // What is no profile is refused with its line: from here on it has a kind and an id.
    app.library.with_shared(name, text)?;
    Ok(serde_json::from_str(text)?)
}

fn kind_of(values: &Map<String, Value>) -> Result<Kind, PlanningError> {
    Ok(serde_json::from_value(values.get("kind").cloned().unwrap_or_default())?)
}

fn text_of(values: &Map<String, Value>, key: &str) -> String {
    values.get(key).and_then(Value::as_str).unwrap_or_default().to_owned()
}

/// Has a profile name another one by the id that it has here.
fn point_to(values: &mut Map<String, Value>, kind: Kind, from: &str, to: &str) {
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

/// A name without the number that tells it from others of the same name.
fn without_number(name: &str) -> &str {
    let numbered = name.strip_suffix(')').and_then(|name| name.rsplit_once(" ("));
    numbered.filter(|(_, number)| number.parse::<u32>().is_ok()).map_or(name, |(name, _)| name)
}

/// Where a profile that comes with another one goes.
enum SharedPlace {
    /// The same profile is there already, under this id.
    Known(String),
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
        if let Some(known) = self.same_as(kind, id, values)? {
            return Ok(SharedPlace::Known(known.id));
        }
        let taken: Vec<String> = self.library.list(kind).into_iter().map(|listing| listing.id).collect();
        let numbered = (2..).map(|number| format!("{id}-{number}"));
        let mut ids = std::iter::once(id.to_owned()).chain(numbered);
        Ok(SharedPlace::Free(ids.find(|id| !taken.contains(id)).unwrap_or_default()))
    }

    /// A profile that is the same but for the id and for the number behind its name, which it may have got when it was taken in.
    fn same_as(
        &self,
        kind: Kind,
        id: &str,
        values: &Map<String, Value>,
    ) -> Result<Option<Listing>, PlanningError> {
        let plain = |values: &Map<String, Value>| {
            let mut plain = values.clone();
            let name = text_of(values, "name");
            plain.insert("name".to_owned(), without_number(&name).into());
            plain.remove("id");
            plain.remove("$schema");
            plain
        };
        let wanted = plain(values);
        let mut listed = self.library.list(kind);
        // That of the same id is the likeliest.
        listed.sort_by_key(|listing| listing.id != id);
        for listing in listed {
            let there: Value = serde_json::from_str(&self.library.portable_text(kind, &listing.id)?)?;
            if there.as_object().is_some_and(|there| plain(there) == wanted) {
                return Ok(Some(listing));
            }
        }
        Ok(None)
    }

    /// Gives a profile its id here, and a number behind its name where another one is called so. Gives the name that it had, if it got
    /// another one.
    fn rename(&self, values: &mut Map<String, Value>, kind: Kind, id: &str) -> Option<String> {
        values.insert("id".to_owned(), id.into());
        let name = text_of(values, "name");
        let taken: Vec<String> = self.library.list(kind).into_iter().map(|listing| listing.name).collect();
        if name.is_empty() || !taken.contains(&name) {
            return None;
        }
        let plain = without_number(&name);
        // One more than there are names is enough to find a free one.
        let mut numbers = 2..taken.len() + 3;
        let free = numbers.find_map(|number| {
            let name = format!("{plain} ({number})");
            (!taken.contains(&name)).then_some(name)
        });
        values.insert("name".to_owned(), free.unwrap_or_default().into());
        Some(name)
    }

    /// An error of the copy that is not written, with its line in the file that the person has.
    fn located(&self, error: PlanningError, file: &str, text: &str) -> PlanningError {
        match self.library.check_shared(file, text) {
            Err(found) => {
                found.into_iter().map(PlanningError::from).find(|found| found.code() == error.code())
            }
            Ok(_) => None,
        }
        .unwrap_or(error)
    }
}
