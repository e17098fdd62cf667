//! Rule: what is compiled without its tests has none, since nothing would run them.

use super::finding::Finding;
use super::members::{Member, Target};
use super::tree::TreeFile;

const WHY: &str = "`test = false` spares a program of tests where there are none, and nobody runs these";
/// What only tests have.
const OF_TESTS: &[&str] = &["#[test]", "#[cfg(test)]", "proptest!"];

/// Tests in the sources of targets with `test = false`.
pub(super) fn check(members: &[Member], files: &[TreeFile]) -> Vec<Finding> {
    let mut findings = Vec::new();
    for member in members {
        for target in member.targets.iter().filter(|target| !target.tested) {
            let shared = member.targets.iter().any(|other| other.tested && other.folder() == target.folder());
            let is_its = |path: &str| path == target.source || (!shared && path.starts_with(target.folder()));
            for file in files.iter().filter(|file| is_its(&file.path)) {
                let mut lines = file.lines();
                let found = lines.find(|(_, line)| OF_TESTS.iter().any(|word| line.trim().starts_with(word)));
                if let Some((line, _)) = found {
                    let to_do = format!("take `test = false` out of {}", member.manifest());
                    findings.push(Finding::new(&file.path, line, "a test that is not compiled", WHY, to_do));
                }
            }
        }
    }
    findings
}

impl Target {
    /// The folder of its sources, with a slash at its end.
    fn folder(&self) -> &str {
        let end = self.source.rfind('/').map_or(0, |slash| slash + 1);
        &self.source[..end]
    }
}

#[cfg(test)]
mod tests {
    use super::super::sample::{file, places};
    use super::*;

    fn found(targets: &[(&str, bool)], path: &str) -> Vec<String> {
        let target = |&(source, tested): &(&str, bool)| Target { source: source.to_owned(), tested };
        let targets = targets.iter().map(target).collect();
        let member = Member { room: "crates/a".to_owned(), dependencies: Vec::new(), targets };
        places(&check(&[member], &[file(path, "fn a() {}\n\n#[cfg(test)]\nmod tests {}\n")]))
    }

    #[test]
    fn a_test_that_nobody_runs_is_found() {
        let (library, program) = ("crates/a/src/lib.rs", "crates/a/src/main.rs");
        let inner = "crates/a/src/inner/part.rs";
        assert_eq!(found(&[(library, false)], inner), ["crates/a/src/inner/part.rs:3"]);
        assert_eq!(found(&[(program, false), (library, true)], program), ["crates/a/src/main.rs:3"]);
    }

    #[test]
    fn tests_that_are_run_are_fine() {
        let (library, program) = ("crates/a/src/lib.rs", "crates/a/src/main.rs");
        let inner = "crates/a/src/inner/part.rs";
        assert!(found(&[(library, true)], inner).is_empty());
        assert!(found(&[(program, false), (library, true)], inner).is_empty());
        assert!(found(&[(library, false)], "crates/a/tests/all/main.rs").is_empty());
    }
}
