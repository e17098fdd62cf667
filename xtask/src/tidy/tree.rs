//! The files of the repository: everything that is not ignored by git, so also what is not committed yet.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use ignore::WalkBuilder;

/// A file and its text.
pub(super) struct TreeFile {
    /// Path below the workspace root, with `/`.
    pub(super) path: String,
    /// None when the file is not UTF-8 text.
    pub(super) text: Option<String>,
}

impl TreeFile {
    /// Lines with their numbers from 1; none for a binary file.
    pub(super) fn lines(&self) -> impl Iterator<Item = (usize, &str)> {
        let text = self.text.as_deref().unwrap_or_default();
        text.lines().enumerate().map(|(index, line)| (index + 1, line))
    }

    pub(super) fn has_extension(&self, extensions: &[&str]) -> bool {
        self.path.rsplit_once('.').is_some_and(|(_, extension)| extensions.contains(&extension))
    }

    /// Material that a test reads and that is not written by hand.
    pub(super) fn is_fixture(&self) -> bool {
        ["fixtures", "testdata", "golden", "snapshots"].iter().any(|folder| {
            self.path.starts_with(&format!("{folder}/")) || self.path.contains(&format!("/{folder}/"))
        })
    }
}

/// All files below `root` in the order of their paths.
pub(super) fn read(root: &Path) -> Result<Vec<TreeFile>> {
    let mut files = Vec::new();
    // Hidden files belong to the tree (`.ci/run`), git's own folder does not.
    let walk = WalkBuilder::new(root)
        .hidden(false)
        .git_global(false)
        .git_exclude(false)
        .require_git(false)
        .filter_entry(|entry| entry.file_name() != ".git")
        .build();
    for entry in walk {
        let entry = entry?;
        if !entry.file_type().is_some_and(|kind| kind.is_file()) {
            continue;
        }
        let path = entry.path().strip_prefix(root)?.to_string_lossy().replace('\\', "/");
        let bytes = fs::read(entry.path()).with_context(|| format!("cannot read {path}"))?;
        files.push(TreeFile { path, text: String::from_utf8(bytes).ok() });
    }
    files.sort_by(|a, b| a.path.cmp(&b.path));
    Ok(files)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hidden_files_are_read_and_ignored_folders_are_not() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        let files = read(root).unwrap();
        let has = |path: &str| files.iter().any(|file| file.path == path);
        assert!(has("xtask/src/tidy/tree.rs") && has(".cargo/config.toml"));
        assert!(!files.iter().any(|file| file.path.starts_with("target/") || file.path.starts_with(".git/")));
    }
}
