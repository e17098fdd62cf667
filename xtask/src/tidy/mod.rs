//! `cargo xtask tidy`: the rules of the house that the compiler cannot check, one file a rule.
//!
//! Each rule is a function of values in memory; only `tree` and `members` read the disk. The rules name what they
//! forbid, so this folder itself is not searched for forbidden words.

mod c_units;
mod error_texts;
mod facts;
mod finding;
mod firmware_order;
mod glossary;
mod leftovers;
mod length;
mod lints;
mod local_text;
mod members;
mod modules;
mod purity;
mod rooms;
mod rust_source;
mod sources;
mod tree;
mod unsafe_code;
mod untested;

use std::path::Path;

use anyhow::{Result, bail};

/// Folders of the crates that do no I/O and make no sentences.
const PURE_ROOMS: &[&str] = &["crates/core", "crates/accuracy", "crates/sequence"];
/// This folder, which names what it forbids.
const RULES: &str = "xtask/src/tidy/";

/// The path of a file within its pure room; none where it is in no such room.
fn in_pure_room(path: &str) -> Option<&str> {
    PURE_ROOMS.iter().find_map(|room| path.strip_prefix(room)?.strip_prefix('/'))
}

/// Whether a file is among the sources of a pure room.
fn is_pure(path: &str) -> bool {
    in_pure_room(path).is_some_and(|rest| rest.starts_with("src/"))
}

/// Checks every rule on the workspace at `root` and prints what it finds; an error when anything must be changed.
pub(crate) fn run(root: &Path) -> Result<()> {
    let files = tree::read(root)?;
    let members = members::read(root)?;

    let mut findings = rooms::check(&members, &files);
    findings.extend(modules::check(&members, &files));
    findings.extend(purity::check_dependencies(&members, &files));
    findings.extend(purity::check_sources(&files));
    findings.extend(purity::check_units(&files));
    findings.extend(facts::check(&files));
    findings.extend(error_texts::check(&files));
    findings.extend(c_units::check(&files));
    findings.extend(firmware_order::check(&files));
    findings.extend(length::check(&files));
    findings.extend(leftovers::check(&files));
    findings.extend(unsafe_code::check(&files));
    findings.extend(lints::check(&members, &files));
    findings.extend(sources::check(&files));
    findings.extend(untested::check(&members, &files));
    findings.extend(local_text::check(&files));
    findings.extend(glossary::check(&files));
    findings.sort_by(|a, b| (a.only_report, &a.path, a.line).cmp(&(b.only_report, &b.path, b.line)));

    let failures = findings.iter().filter(|finding| !finding.only_report).count();
    for finding in &findings {
        println!("{finding}");
    }
    if failures > 0 {
        bail!("tidy: {failures} findings must be changed");
    }
    println!("tidy: {} files, {} crates, nothing to change", files.len(), members.len());
    Ok(())
}

/// What the tests of the rules share.
#[cfg(test)]
mod sample {
    use super::finding::Finding;
    use super::tree::TreeFile;

    pub(super) fn file(path: &str, text: &str) -> TreeFile {
        TreeFile { path: path.to_owned(), text: Some(text.to_owned()) }
    }

    /// `path:line` of each finding, in the order found.
    pub(super) fn places(findings: &[Finding]) -> Vec<String> {
        findings.iter().map(|finding| format!("{}:{}", finding.path, finding.line)).collect()
    }
}
