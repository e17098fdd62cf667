//! What was open before.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_files::document::save_atomically;

use super::Desk;
use crate::output::file_name;

/// How many are kept.
const MOST: usize = 12;

/// A file that was open.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct RecentEntry {
    /// The file.
    pub path: PathBuf,
    /// Its name.
    pub name: String,
    /// Whether it is still there.
    pub there: bool,
}

/// The list as a file.
#[derive(Debug, Default, Serialize, Deserialize)]
struct Recent {
    files: Vec<PathBuf>,
}

impl Desk {
    fn recent_file(&self) -> Option<PathBuf> {
        self.places().state.as_ref().map(|state| state.join("recent.json"))
    }

    /// The files that were open, last first. A list that cannot be read is none: nothing depends on it.
    pub(super) fn recent(&self) -> Vec<RecentEntry> {
        let read = self.recent_file().and_then(|file| std::fs::read(file).ok());
        let list: Recent = read.and_then(|bytes| serde_json::from_slice(&bytes).ok()).unwrap_or_default();
        let entry = |path: PathBuf| RecentEntry { name: file_name(&path), there: path.is_file(), path };
        list.files.into_iter().map(entry).collect()
    }

    /// Puts a file at the head of the list.
    pub(super) fn remember(&self, path: &Path) {
        let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
        let others = self.recent().into_iter().map(|entry| entry.path).filter(|other| *other != path);
        self.write_recent(std::iter::once(path.clone()).chain(others).take(MOST).collect());
    }

    pub(super) fn forget_recent(&self) {
        self.write_recent(Vec::new());
    }

    fn write_recent(&self, files: Vec<PathBuf>) {
        let Some(file) = self.recent_file() else { return };
        let written = file
            .parent()
            .map_or(Ok(()), std::fs::create_dir_all)
            .map_err(|error| error.to_string())
            .and_then(|()| {
                let bytes =
                    serde_json::to_vec_pretty(&Recent { files }).map_err(|error| error.to_string())?;
                save_atomically(&file, &bytes).map_err(|error| error.to_string())
            });
        if let Err(error) = written {
            tracing::warn!("the list of recent files was not written: {error}");
        }
    }
}
