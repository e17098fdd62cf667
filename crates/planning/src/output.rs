//! Where results go.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_files::document::{DocumentError, save_atomically};

use crate::PlanningError;
use crate::report::NoteReport;

/// A file to write a result to.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Output {
    pub path: PathBuf,
    /// Whether a file that is there may be replaced.
    #[serde(default)]
    pub force: bool,
}

impl Output {
    /// Whether its name says that it is a model for another program.
    pub fn is_obj(&self) -> bool {
        self.path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("obj"))
    }

    /// Refuses before any work is done what would be refused in the end.
    ///
    /// # Errors
    /// [`PlanningError::Exists`] when the file is there and may not be replaced; [`DocumentError::Save`] when a folder is there, or none for
    /// it.
    pub fn check(&self) -> Result<(), PlanningError> {
        let folder = self.path.parent().filter(|folder| !folder.as_os_str().is_empty());
        let wrong = if self.path.is_dir() {
            Some("it is a folder".to_owned())
        } else {
            let missing = folder.filter(|folder| !folder.is_dir());
            missing.map(|folder| format!("there is no folder {}", folder.display()))
        };
        if let Some(wrong) = wrong {
            let (path, error) = (self.path.display().to_string(), std::io::Error::other(wrong));
            return Err(DocumentError::Save { path, error }.into());
        }
        self.check_overwrites()
    }

    /// The same of a file whose folder is made for it.
    ///
    /// # Errors
    /// [`PlanningError::Exists`] when the file is there and may not be replaced.
    pub fn check_overwrites(&self) -> Result<(), PlanningError> {
        if !self.force && self.path.exists() {
            return Err(PlanningError::Exists(self.path.clone()));
        }
        Ok(())
    }

    /// Writes the file, whole or not at all.
    pub fn save(&self, contents: &[u8]) -> Result<PathBuf, PlanningError> {
        self.check()?;
        save_atomically(&self.path, contents)?;
        tracing::info!(path = %self.path.display(), bytes = contents.len(), "written");
        Ok(self.path.clone())
    }

    /// The same of what cannot be made once more, such as what a machine has done: where the file cannot be written, a note says so beside
    /// all else that is known.
    pub fn save_or_note(&self, contents: &[u8]) -> Result<PathBuf, NoteReport> {
        self.save(contents).map_err(|error| NoteReport {
            code: "not-saved".into(),
            count: 1,
            message: error.to_string(),
            remedies: Vec::new(),
        })
    }
}

/// The part of a path that a person gave as a name.
pub fn file_name(path: &Path) -> String {
    path.file_name().map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A search of an hour for a folder that is not there would be lost.
    #[test]
    fn where_no_file_can_be_is_refused_before_any_work() {
        let folder = tempfile::tempdir().unwrap();
        let output = |name: &str| Output { path: folder.path().join(name), force: true };
        let said = |name: &str| output(name).check().unwrap_err().to_string();
        assert!(said("").contains("it is a folder"), "{}", said(""));
        let (missing, expected) = (said("no/a.json"), "there is no folder");
        assert!(missing.contains(expected), "{missing}");
        output("a.json").check().unwrap();
        Output { path: "a.json".into(), force: true }.check().unwrap();
    }
}
