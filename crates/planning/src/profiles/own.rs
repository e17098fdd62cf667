//! A profile of the person's own, as it is changed and written.

use std::path::{Path, PathBuf};

use serde_json::{Map, Value};
use wirebend_error::InputName;
use wirebend_files::read::read_file;
use wirebend_profile::{Child, Kind, ProfileError, written};

use super::history::LastChange;
use super::new::{check_id, make_folder, schema_beside};
use crate::output::Output;
use crate::{Installation, PlanningError};

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
        Output { path: file.clone(), force }.check_overwrites()?;
        let beside = schema_beside(&file, kind);
        let child = Child { kind, id, inherits, name: id, schema: beside.as_deref(), all: false };
        let text = app.library.child_text(&child)?;
        Ok(Self { kind, file, values: serde_json::from_str(&text)?, force })
    }

    /// One that is never written: to see whether its values could be.
    pub fn draft(app: &Installation, kind: Kind, inherits: &str) -> Result<Self, PlanningError> {
        let id = "draft";
        let child = Child { kind, id, inherits, name: id, schema: None, all: false };
        let values = serde_json::from_str(&app.library.child_text(&child)?)?;
        let file = Path::new(kind.folder()).join(format!("{id}.json"));
        Ok(Self { kind, file, values, force: false })
    }

    /// The rules that its values break.
    pub fn faults(&self, app: &Installation) -> Result<Vec<ProfileError>, PlanningError> {
        let file = self.file.display().to_string();
        Ok(app.library.check(&file, &self.text()?).err().unwrap_or_default())
    }

    /// One with the values of another file, that takes its place in a folder of profiles.
    pub(super) fn taken_in(
        app: &Installation,
        kind: Kind,
        id: &str,
        mut values: Map<String, Value>,
        folder: &Path,
    ) -> Result<Self, PlanningError> {
        check_id(id)?;
        let file = folder.join(kind.folder()).join(format!("{id}.json"));
        app.check_free(kind, id, None)?;
        Output { path: file.clone(), force: false }.check_overwrites()?;
        // Where its schema lay is no place here.
        values.remove("$schema");
        Ok(Self { kind, file, values, force: false })
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

    /// Its file.
    pub fn file(&self) -> &Path {
        &self.file
    }

    /// What the file itself has under a key of the first level.
    pub fn own_value(&self, key: &str) -> Option<&Value> {
        self.values.get(key)
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

    /// Takes a value out, so that the parent's counts again; groups that are empty then go too.
    pub fn remove(&mut self, key: &str) -> Result<(), PlanningError> {
        let parts: Vec<&str> = key.split('.').collect();
        if take_out(&mut self.values, &parts) {
            return Ok(());
        }
        Err(PlanningError::Value {
            input: Some(InputName::ProfileKeys),
            name: "a key",
            value: format!("'{key}'"),
            expected: "a key that the profile itself sets",
        })
    }

    /// Has the text of a profile in the place of all that it has.
    pub(super) fn replace(&mut self, text: &str) -> Result<(), PlanningError> {
        self.values = serde_json::from_str(text)?;
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

    /// Writes it. Where a file is replaced, its text is kept, so that the change can be taken back.
    pub fn save(self) -> Result<PathBuf, PlanningError> {
        let text = self.text()?;
        make_folder(&self.file)?;
        let output = Output { path: self.file, force: self.force };
        output.check()?;
        LastChange::keep(self.kind, &output.path, &text)?;
        output.save(text.as_bytes())
    }
}

/// Takes a key out of a group of groups. Gives whether it was there.
fn take_out(group: &mut Map<String, Value>, parts: &[&str]) -> bool {
    let Some((first, rest)) = parts.split_first() else { return false };
    if rest.is_empty() {
        return group.remove(*first).is_some();
    }
    let Some(Value::Object(inner)) = group.get_mut(*first) else { return false };
    let found = take_out(inner, rest);
    if found && inner.is_empty() {
        group.remove(*first);
    }
    found
}

impl Installation {
    /// This installation as it will be with one profile more.
    pub(crate) fn with_profile(&self, profile: &OwnProfile) -> Result<Self, PlanningError> {
        let library = self.library.with(&profile.file.display().to_string(), &profile.text()?)?;
        Ok(self.with_library(library))
    }
}
