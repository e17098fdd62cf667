//! Rule: the repository reads the same on every machine: no paths of a user's disk, no package registries or mirrors.

use super::RULES;
use super::finding::Finding;
use super::tree::TreeFile;

/// Starts of absolute paths that exist on one machine only.
const LOCAL_FOLDERS: &[&str] = &["/home/", "/root/", "/tmp/", "/Users/", "C:\\Users\\"];
/// Hosts of package registries.
const REGISTRIES: &[&str] = &["crates.io", "npmjs.org", "npmjs.com", "pypi.org", "pythonhosted.org"];
/// Parts of the names of private registries and mirrors.
const MIRROR_WORDS: &[&str] = &["registry", "mirror", "artifactory", "nexus", "proxy"];
/// What package managers themselves write for their public registry.
const IN_LOCK_FILES: &[&str] =
    &["https://github.com/rust-lang/crates.io-index", "https://registry.npmjs.org/"];

/// Absolute paths and registry hosts in text files.
pub(super) fn check(files: &[TreeFile]) -> Vec<Finding> {
    let searched = files.iter().filter(|file| !file.path.starts_with(RULES) && !file.is_fixture());
    searched.flat_map(check_file).collect()
}

fn check_file(file: &TreeFile) -> Vec<Finding> {
    let is_lock = ["Cargo.lock", "package-lock.json"].iter().any(|name| file.path.ends_with(name));
    let mut findings = Vec::new();
    for (number, line) in file.lines() {
        let mut line = line.to_owned();
        if is_lock {
            for public in IN_LOCK_FILES {
                line = line.replace(public, "");
            }
        }
        if let Some(folder) = LOCAL_FOLDERS.iter().find(|folder| has_path(&line, folder)) {
            let why = "this folder does not exist on another machine";
            let to_do = "use a path below the workspace, or ask the system for its folder";
            findings.push(Finding::new(&file.path, number, format!("absolute path {folder}"), why, to_do));
        }
        if let Some(host) = registry_host(&line) {
            let why = "which registry is used is the choice of the machine that builds";
            let to_do = "name the package, not where it comes from";
            findings.push(Finding::new(&file.path, number, format!("registry host {host}"), why, to_do));
        }
    }
    findings
}

/// `folder` starts a path on this line: nothing that could be the part of a path or of a host stands before it.
fn has_path(line: &str, folder: &str) -> bool {
    line.match_indices(folder).any(|(at, _)| {
        let before = line[..at].chars().next_back();
        !before.is_some_and(|c| c.is_alphanumeric() || matches!(c, '.' | '-' | '_' | '~' | '/' | '}' | ')'))
    })
}

fn registry_host(line: &str) -> Option<String> {
    if let Some(known) = REGISTRIES.iter().find(|host| line.contains(**host)) {
        return Some((*known).to_owned());
    }
    let mut hosts = line
        .split("://")
        .skip(1)
        .map(|rest| rest.split(['/', '"', '\'', ' ', ')', '>']).next().unwrap_or(rest));
    hosts.find(|host| MIRROR_WORDS.iter().any(|word| host.contains(word))).map(str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::super::sample::{file, places};
    use super::*;

    #[test]
    fn paths_of_one_machine_are_found() {
        let text = "fine\nlet a = \"/tmp/x\";\nsee /home/someone/x\n";
        assert_eq!(
            places(&check(&[file("crates/api/src/a.rs", text)])),
            ["crates/api/src/a.rs:2", "crates/api/src/a.rs:3"]
        );
    }

    #[test]
    fn parts_of_longer_paths_and_fixtures_are_free() {
        let text = "target/tmp/x https://example.org/home/x $HOME/tmp/ ${X}/tmp/ ~/root/x";
        let fixture = file("tests/fixtures/a.txt", "/home/x");
        assert!(check(&[file("Makefile", text), fixture]).is_empty());
    }

    #[test]
    fn registries_and_mirrors_are_found() {
        let text =
            "from pypi.org\nurl = \"https://mirror.example.com/simple\"\nhttps://github.com/a/mirror\n";
        assert_eq!(places(&check(&[file("README.md", text)])), ["README.md:1", "README.md:2"]);
    }

    #[test]
    fn a_lock_file_may_name_the_public_registry_only() {
        let text = "source = \"registry+https://github.com/rust-lang/crates.io-index\"\nsource = \"registry+https://nexus.example.com/index\"\n";
        assert_eq!(places(&check(&[file("Cargo.lock", text)])), ["Cargo.lock:2"]);
    }
}
