//! Where results go.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_files::document::save_atomically;

use crate::PlanningError;

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
    /// [`PlanningError::Exists`] when the file is there and may not be replaced.
    pub fn check(&self) -> Result<(), PlanningError> {
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
}

/// The part of a path that a person gave as a name.
pub fn file_name(path: &Path) -> String {
    path.file_name().map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into_owned())
}
