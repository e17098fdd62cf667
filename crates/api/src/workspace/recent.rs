//! What was open before.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_files::document::save_atomically;

use super::{Workspace, make_folder_of};
use crate::Places;
use wirebend_planning::output::file_name;

/// How many are kept.
const MAX: usize = 12;

/// A file that was open.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct RecentEntry {
    pub path: PathBuf,
    pub name: String,
    /// Whether it is still there.
    pub there: bool,
}

/// The list as a file.
#[derive(Debug, Default, Serialize, Deserialize)]
struct Recent {
    #[serde(default)]
    files: Vec<PathBuf>,
    /// The machine that was chosen last.
    #[serde(default)]
    machine: Option<String>,
}

fn file_in(places: &Places) -> Option<PathBuf> {
    places.state.as_ref().map(|state| state.join("recent.json"))
}

/// A list that cannot be read is none: nothing depends on it.
fn read(places: &Places) -> Recent {
    let bytes = file_in(places).and_then(|file| std::fs::read(file).ok());
    bytes.and_then(|bytes| serde_json::from_slice(&bytes).ok()).unwrap_or_default()
}

/// The machine that was chosen last, at an earlier start maybe.
pub(super) fn last_machine(places: &Places) -> Option<String> {
    read(places).machine
}

impl Workspace {
    /// The files that were open, last first.
    pub(crate) fn recent(&self) -> Vec<RecentEntry> {
        let entry = |path: PathBuf| RecentEntry { name: file_name(&path), there: path.is_file(), path };
        read(self.places()).files.into_iter().map(entry).collect()
    }

    /// Puts a file at the head of the list.
    pub(crate) fn remember(&self, path: &Path) {
        let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
        let before = read(self.places());
        let others = before.files.into_iter().filter(|other| *other != path);
        let files = std::iter::once(path.clone()).chain(others).take(MAX).collect();
        self.write_recent(&Recent { files, ..before });
    }

    pub(crate) fn remember_machine(&self, machine: &str) {
        self.write_recent(&Recent { machine: Some(machine.to_owned()), ..read(self.places()) });
    }

    pub(crate) fn forget_recent(&self) {
        self.write_recent(&Recent { files: Vec::new(), ..read(self.places()) });
    }

    fn write_recent(&self, recent: &Recent) {
        let Some(file) = file_in(self.places()) else { return };
        let written = make_folder_of(&file)
            .and_then(|()| Ok(save_atomically(&file, &serde_json::to_vec_pretty(recent)?)?));
        if let Err(error) = written {
            tracing::warn!("the list of recent files was not written: {error}");
        }
    }
}
