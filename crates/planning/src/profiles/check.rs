//! `profile check`: whether profile files can be used, before they are put where they count.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use wirebend_driver_host::HostError;
use wirebend_error::ProblemReport;
use wirebend_profile::{Checked, Library, Place, ProfileError, check_file};

use super::share::Parts;
use crate::{ExportFormat, Installation, PlanningError, Progress};

#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ProfileCheckRequest {
    pub files: Vec<PathBuf>,
}

/// What a file is, or why it is refused.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct FileVerdict {
    pub file: PathBuf,
    /// Whether it can be used.
    pub ok: bool,
    /// `machine`, `material` or `noise`.
    pub kind: Option<&'static str>,
    pub id: Option<String>,
    /// What it inherits from, nearest first; itself not included.
    pub inherits: Vec<String>,
    /// Why it is refused: each with file, line and what was expected.
    pub errors: Vec<String>,
    /// The same with codes, and what can be done about it.
    pub problems: Vec<ProblemReport>,
    /// What could not be checked, and why.
    pub notes: Vec<String>,
}

/// What became of the files.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct ProfileCheckResponse {
    /// Whether all can be used.
    pub ok: bool,
    /// In the order asked for.
    pub files: Vec<FileVerdict>,
}

impl Installation {
    /// Refuses the text of a profile that cannot be used, with the first of its faults.
    pub fn require_profile(&self, file: &str, text: &str) -> Result<(), PlanningError> {
        match self.library.check(file, text) {
            Ok(checked) => Ok(self.asked_of_drivers(&checked, file, text).map(drop)?),
            Err(errors) => errors.into_iter().next().map_or(Ok(()), |error| Err(error.into())),
        }
    }

    /// Asks of a machine's profile what only drivers know: whether a driver writes its formats, and whether its
    /// driver takes its settings, with those that it inherits. Gives what could not be asked, and why.
    pub fn asked_of_drivers(
        &self,
        checked: &Checked,
        file: &str,
        text: &str,
    ) -> Result<Vec<String>, ProfileError> {
        let Some(machine) = &checked.machine else { return Ok(Vec::new()) };
        let profile = &machine.profile;
        let rule = |key: &str, word: &str, found: String, expected: String| {
            let place = Place { file: file.to_owned(), line: line_of(text, word) };
            ProfileError::Rule { place, key: key.into(), found, expected }
        };
        let mut notes = Vec::new();
        let id = profile.driver.id.as_deref().unwrap_or_default();
        let started = self.driver(id);
        // It is not known what a driver would write that is not here.
        let writes = started.is_ok().then_some(id);
        match started {
            Ok(driver) => {
                let settings = Value::Object(profile.driver.settings.clone().unwrap_or_default());
                match driver.open(&settings) {
                    Ok(_) => {}
                    Err(HostError::Refused { error, .. }) => {
                        let expected = format!("settings that the driver '{id}' takes: {error}");
                        return Err(rule("driver.settings", "settings", settings.to_string(), expected));
                    }
                    Err(error) => notes.push(format!("its driver.settings were not checked: {error}")),
                }
            }
            Err(error) => notes.push(format!("its driver.settings were not checked: {error}")),
        }
        let own = |key: &str| machine.origin(key).is_some_and(|origin| origin.id == checked.id);
        // What a parent has set is the parent's affair, unless it was for another driver.
        let asked = |key: &str| own(key) || own("driver.id");
        let listed = profile.export.formats.iter().flatten().filter(|_| asked("export.formats"));
        let native = profile.export.native.iter().filter(|_| asked("export.native"));
        let named = listed.map(|id| ("export.formats", id)).chain(native.map(|id| ("export.native", id)));
        let foreign: Vec<_> = named.filter(|(_, id)| ExportFormat::from_id(id).is_none()).collect();
        if foreign.is_empty() {
            return Ok(notes);
        }
        let known = match self.formats(writes) {
            Ok(known) => known,
            Err(error) => {
                notes.push(format!("its formats were not checked: {error}"));
                return Ok(notes);
            }
        };
        match foreign.into_iter().find(|(_, id)| !known.contains(id)) {
            Some(("export.native", format)) if !notes.is_empty() => {
                notes.push(format!("its export.native '{format}' was not checked"));
                Ok(notes)
            }
            Some((key, format)) => {
                let expected = format!("formats that can be written for this machine: {}", known.join(", "));
                Err(rule(key, format, format!("\"{format}\""), expected))
            }
            None => Ok(notes),
        }
    }

    /// Everything that is asked of a profile's file.
    fn examined(&self, file: &Path) -> Result<(Checked, Vec<String>), Vec<ProfileError>> {
        let text = std::fs::read_to_string(file).unwrap_or_default();
        let parts = Parts::of(&text);
        if !parts.others.is_empty() {
            return self.examined_shared(&file.display().to_string(), &parts);
        }
        let checked = check_file(file)?;
        let notes = self.asked_of_drivers(&checked, &file.display().to_string(), &text);
        let notes = notes.map_err(|error| vec![error])?;
        Ok((checked, notes))
    }

    /// Of a file with several profiles: all of them, each on the lines that it has there.
    fn examined_shared(
        &self,
        file: &str,
        parts: &Parts,
    ) -> Result<(Checked, Vec<String>), Vec<ProfileError>> {
        let mut library = Library::shipped().map_err(|error| vec![error])?;
        let mut errors = Vec::new();
        for text in &parts.others {
            match library.check_shared(file, text) {
                Ok(_) => library = library.with_shared(file, text).map_err(|error| vec![error])?,
                Err(found) => errors.extend(found),
            }
        }
        match library.check_shared(file, &parts.own) {
            Ok(checked) if errors.is_empty() => {
                let notes = self.asked_of_drivers(&checked, file, &parts.own).map_err(|error| vec![error])?;
                Ok((checked, notes))
            }
            Err(found) if errors.is_empty() => Err(found),
            // Where another profile of the file is refused, the machine that names it is, too: that would be said twice.
            _ => Err(errors),
        }
    }
}

/// The line on which a quoted word stands, from 1.
fn line_of(text: &str, word: &str) -> Option<usize> {
    let quoted = format!("\"{word}\"");
    text.lines().position(|line| line.contains(&quoted)).map(|line| line + 1)
}

#[allow(clippy::unnecessary_wraps)] // every command has the same shape
pub fn check(
    app: &Installation,
    request: &ProfileCheckRequest,
    progress: &dyn Progress,
) -> Result<ProfileCheckResponse, PlanningError> {
    progress.stage("checking profiles");
    let verdict = |file: &PathBuf| match app.examined(file) {
        Ok((checked, notes)) => FileVerdict {
            ok: true,
            kind: Some(checked.kind.word()),
            inherits: checked.chain.into_iter().filter(|id| *id != checked.id).collect(),
            id: Some(checked.id),
            errors: Vec::new(),
            problems: Vec::new(),
            notes,
            file: file.clone(),
        },
        Err(errors) => FileVerdict {
            ok: false,
            kind: None,
            id: None,
            inherits: Vec::new(),
            errors: errors.iter().map(ToString::to_string).collect(),
            problems: errors.iter().map(ProblemReport::from).collect(),
            notes: Vec::new(),
            file: file.clone(),
        },
    };
    let files: Vec<FileVerdict> = request.files.iter().map(verdict).collect();
    Ok(ProfileCheckResponse { ok: files.iter().all(|file| file.ok), files })
}
