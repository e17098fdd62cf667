//! Rule: every crate takes the lints of the workspace, and those whose documentation is published ask for it.

use super::finding::Finding;
use super::members::Member;
use super::tree::TreeFile;

/// The crates that others build on: what they export is documented.
const PUBLISHED: &[&str] =
    &["crates/core", "crates/accuracy", "crates/sequence", "crates/profile", "crates/driver-api"];
const ASKS: &str = "#![deny(missing_docs)]";

/// Crates without `[lints] workspace = true`, and published ones that do not ask for documentation.
pub(super) fn check(members: &[Member], files: &[TreeFile]) -> Vec<Finding> {
    let mut findings = Vec::new();
    for member in members {
        let path = member.manifest();
        if setting(files, &path, "lints", "workspace").is_none_or(|(_, value)| value != "true") {
            let why = "a crate with its own lints drifts from the others";
            findings.push(Finding::new(&path, 1, "no [lints] workspace = true", why, "add these two lines"));
        }
        if PUBLISHED.contains(&member.room.as_str()) {
            findings.extend(undocumented(&format!("{}/src/lib.rs", member.room), files));
        }
    }
    findings
}

fn undocumented(library: &str, files: &[TreeFile]) -> Option<Finding> {
    let mut lines = files.iter().filter(|file| file.path == library).flat_map(TreeFile::lines);
    let why = "a public item without documentation cannot be used without reading its code";
    let asks = lines.any(|(_, line)| line.trim() == ASKS);
    (!asks).then(|| Finding::new(library, 1, "missing_docs is not denied", why, format!("add {ASKS}")))
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

    fn member(room: &str) -> Member {
        Member { room: room.to_owned(), dependencies: Vec::new(), targets: Vec::new() }
    }

    #[test]
    fn a_crate_that_takes_the_lints_is_fine() {
        let files = [file("crates/a/Cargo.toml", "[package]\n[lints]\nworkspace = true\n")];
        assert!(check(&[member("crates/a")], &files).is_empty());
    }

    #[test]
    fn a_crate_with_its_own_lints_is_found() {
        let other_table = "[package]\nedition.workspace = true\n[lints.rust]\nworkspace = true\n";
        let files = [file("crates/a/Cargo.toml", other_table)];
        assert_eq!(places(&check(&[member("crates/a")], &files)), ["crates/a/Cargo.toml:1"]);
    }

    #[test]
    fn what_is_published_asks_for_documentation() {
        let manifest = || file("crates/core/Cargo.toml", "[lints]\nworkspace = true\n");
        let with = |attribute: &str| {
            let library = file("crates/core/src/lib.rs", &format!("//! A.\n{attribute}\n"));
            places(&check(&[member("crates/core")], &[manifest(), library]))
        };
        assert!(with("#![deny(missing_docs)]").is_empty());
        assert_eq!(with("#![allow(missing_docs)]"), ["crates/core/src/lib.rs:1"]);
    }
}
