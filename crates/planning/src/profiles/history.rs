//! What a file of a profile was before its last change, so that it can be taken back.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use wirebend_files::document::save_atomically;
use wirebend_files::read::read_file;
use wirebend_profile::Kind;

use super::new::make_folder;
use crate::PlanningError;

/// The last change of a profile's file, beside the folders of profiles.
#[derive(Serialize, Deserialize)]
pub(super) struct LastChange {
    /// The text of before.
    pub before: String,
    /// The text that took its place. Where the file has another one, somebody else has changed it.
    after: String,
}

impl LastChange {
    /// Where it is kept; none for a file that lies elsewhere than profiles do.
    fn path(kind: Kind, file: &Path) -> Option<PathBuf> {
        let folder = file.parent().filter(|folder| folder.ends_with(kind.folder()))?;
        Some(folder.parent()?.join("history").join(kind.folder()).join(file.file_name()?))
    }

    /// Keeps the text that a file has now, before another one takes its place.
    pub(super) fn keep(kind: Kind, file: &Path, after: &str) -> Result<(), PlanningError> {
        let Some(path) = Self::path(kind, file) else { return Ok(()) };
        if !file.exists() {
            return Ok(());
        }
        let before = String::from_utf8_lossy(&read_file(file)?).into_owned();
        make_folder(&path)?;
        let change = Self { before, after: after.to_owned() };
        Ok(save_atomically(&path, &serde_json::to_vec_pretty(&change)?)?)
    }

    /// That of a profile.
    pub(super) fn of(kind: Kind, id: &str, file: &Path) -> Result<Self, PlanningError> {
        let nothing =
            |elsewhere| PlanningError::NothingToRevert { id: id.to_owned(), changed_elsewhere: elsewhere };
        let path = Self::path(kind, file).filter(|path| path.is_file()).ok_or_else(|| nothing(false))?;
        let change: Self = serde_json::from_slice(&read_file(&path)?)?;
        let now = read_file(file)?;
        if now == change.after.as_bytes() { Ok(change) } else { Err(nothing(true)) }
    }
}

/// Whether the last change of a profile can be taken back.
#[must_use]
pub fn has_last_change(kind: Kind, id: &str, file: &Path) -> bool {
    LastChange::of(kind, id, file).is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_change_is_kept_beside_the_folder_of_its_kind() {
        let path = |file: &str| LastChange::path(Kind::Machine, Path::new(file));
        assert_eq!(path("/own/machines/a.json").unwrap(), Path::new("/own/history/machines/a.json"));
        assert_eq!(path("/own/materials/a.json"), None);
    }
}
