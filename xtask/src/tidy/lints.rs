//! Rule: every crate takes the lints of the workspace, and these ask for documentation.

use super::finding::Finding;
use super::members::Member;
use super::tree::TreeFile;

const ROOT: &str = "Cargo.toml";

/// Crates without `[lints] workspace = true`, libraries that switch documentation off, a workspace that does not ask for it.
pub(super) fn check(members: &[Member], files: &[TreeFile]) -> Vec<Finding> {
    let mut findings = Vec::new();
    for member in members {
        let path = member.manifest();
        if setting(files, &path, "lints", "workspace").is_none_or(|(_, value)| value != "true") {
            let why = "a crate with its own lints drifts from the others";
            findings.push(Finding::new(&path, 1, "no [lints] workspace = true", why, "add these two lines"));
        }
        findings.extend(undocumented(&format!("{}/src/lib.rs", member.room), files));
    }
    let why = "a public item without documentation cannot be used without reading its code";
    match setting(files, ROOT, "workspace.lints.rust", "missing_docs") {
        Some((_, value)) if value.contains("deny") || value.contains("forbid") => {}
        Some((line, _)) => {
            findings.push(Finding::new(ROOT, line, "missing_docs is not denied", why, "set it to \"deny\""));
        }
        None => {
            let to_do = "add missing_docs = \"deny\" to [workspace.lints.rust]";
            findings.push(Finding::new(ROOT, 1, "missing_docs is not set", why, to_do));
        }
    }
    findings
}

fn undocumented(library: &str, files: &[TreeFile]) -> Vec<Finding> {
    let lines = files.iter().filter(|file| file.path == library).flat_map(TreeFile::lines);
    let off =
        lines.filter(|(_, line)| line.trim_start().starts_with("#![allow(") && line.contains("missing_docs"));
    let why = "every library crate documents what it exports";
    off.map(|(line, _)| Finding::new(library, line, "missing_docs is allowed", why, "remove the attribute"))
        .collect()
}

/// Line and value of `key` in `[table]` of the manifest at `path`, also when it is written `table.key = …`.
fn setting<'f>(files: &'f [TreeFile], path: &str, table: &str, key: &str) -> Option<(usize, &'f str)> {
    let mut inside = String::new();
    for (number, line) in files.iter().filter(|file| file.path == path).flat_map(TreeFile::lines) {
        let line = line.trim();
        if let Some(header) = line.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
            header.trim().clone_into(&mut inside);
        } else if let Some((name, value)) = line.split_once('=') {
            let name = name.trim();
            let dotted = inside.is_empty() && name == format!("{table}.{key}");
            if dotted || (inside == table && name == key) {
                return Some((number, value.trim()));
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::super::sample::{file, places};
    use super::*;

    const ROOT_TEXT: &str = "[workspace.lints.rust]\nmissing_docs = \"deny\"\n";

    fn member(room: &str) -> Member {
        Member { room: room.to_owned(), dependencies: Vec::new() }
    }

    #[test]
    fn a_crate_that_takes_the_lints_is_fine() {
        let files =
            [file(ROOT, ROOT_TEXT), file("crates/a/Cargo.toml", "[package]\n[lints]\nworkspace = true\n")];
        assert!(check(&[member("crates/a")], &files).is_empty());
    }

    #[test]
    fn a_crate_with_its_own_lints_is_found() {
        let other_table = "[package]\nedition.workspace = true\n[lints.rust]\nworkspace = true\n";
        let files = [file(ROOT, ROOT_TEXT), file("crates/a/Cargo.toml", other_table)];
        assert_eq!(places(&check(&[member("crates/a")], &files)), ["crates/a/Cargo.toml:1"]);
    }

    #[test]
    fn documentation_cannot_be_switched_off() {
        let files = [
            file(ROOT, "[workspace.lints.rust]\nunsafe_code = \"forbid\"\nmissing_docs = \"allow\"\n"),
            file("crates/a/Cargo.toml", "[lints]\nworkspace = true\n"),
            file("crates/a/src/lib.rs", "//! A.\n#![allow(missing_docs)]\n"),
        ];
        assert_eq!(places(&check(&[member("crates/a")], &files)), ["crates/a/src/lib.rs:2", "Cargo.toml:3"]);
    }
}
