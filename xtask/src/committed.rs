//! Files that are committed although a command makes them: written by the command, or compared by `--check`.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail};

/// A generated file as it should be on disk.
pub(crate) struct CommittedFile {
    /// Path below the workspace root.
    pub(crate) path: String,
    /// The whole content.
    pub(crate) text: String,
}

/// Writes every file, or with `check` writes none and fails naming each file that differs from what `command` makes.
pub(crate) fn settle(root: &Path, files: &[CommittedFile], check: bool, command: &str) -> Result<()> {
    let mut stale = Vec::new();
    for file in files {
        let path = root.join(&file.path);
        if fs::read_to_string(&path).is_ok_and(|on_disk| on_disk == file.text) {
            continue;
        }
        if !check {
            write(&path, &file.text)?;
        }
        stale.push(file.path.as_str());
    }
    if check && !stale.is_empty() {
        for path in &stale {
            eprintln!(
                "{path}:1: not what `{command}` makes; a newcomer would read something else than the code does; run `{command}`"
            );
        }
        bail!("{} of {} generated files are stale", stale.len(), files.len());
    }
    let verb = if check { "checked" } else { "made" };
    println!("{command}: {} files {verb}, {} changed", files.len(), stale.len());
    Ok(())
}

fn write(path: &Path, text: &str) -> Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).with_context(|| format!("cannot make {}", folder.display()))?;
    }
    fs::write(path, text).with_context(|| format!("cannot write {}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stale_file_fails_the_check_until_it_is_written() {
        let root = std::env::temp_dir().join(format!("xtask-committed-{}", std::process::id()));
        let files = [CommittedFile { path: "made/cube.obj".into(), text: "v 0 0 0\n".into() }];
        assert!(settle(&root, &files, true, "command").is_err(), "a missing file is stale");
        assert!(!root.join("made").exists(), "--check must not write");
        settle(&root, &files, false, "command").unwrap();
        settle(&root, &files, true, "command").unwrap();
        fs::write(root.join("made/cube.obj"), "v 1 0 0\n").unwrap();
        assert!(settle(&root, &files, true, "command").is_err(), "an edited file is stale");
        fs::remove_dir_all(&root).unwrap();
    }
}
