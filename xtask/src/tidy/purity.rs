//! Rule: `core`, `accuracy` and `sequence` compute. They read no file, no clock, no environment, print nothing and know no JSON.

use super::finding::Finding;
use super::members::Member;
use super::rust_source::{code_only, line_at, without_tests, words};
use super::tree::TreeFile;
use super::{PURE_ROOMS, RULES, in_pure_room, is_pure};

const WHY: &str = "it is pure, so that the same input always gives the same wire";

/// The crates that a pure room may use: mathematics, graphs, random numbers from a given seed, and error types.
const MAY_USE: &[&str] = &[
    "faer",
    "nalgebra",
    "parry3d-f64",
    "petgraph",
    "rand",
    "rand_chacha",
    "rand_distr",
    // Computes on all processors; what comes of it does not depend on their number.
    "rayon",
    "rmpfit",
    "statrs",
    "thiserror",
];

/// Paths of the standard library that reach outside the program.
const OUTSIDE: &[&str] = &[
    "std::fs",
    "std::net",
    "std::process",
    "std::env",
    "std::io",
    "std::time::Instant",
    "std::time::SystemTime",
    "std::time::UNIX_EPOCH",
];

/// Names that may not be in a pure room however they are reached.
const FORBIDDEN_NAMES: &[&str] =
    &["println!", "print!", "eprintln!", "eprint!", "serde_json", "Instant::now", "SystemTime::now"];

/// What makes a length or an angle of any number.
const UNCHECKED: &[&str] = &["Length::computed", "Angle::computed"];

/// External crates that a pure room uses outside tests and that are not in the table.
pub(super) fn check_dependencies(members: &[Member], files: &[TreeFile]) -> Vec<Finding> {
    let is_there = |room: &&&str| members.iter().any(|member| member.room == **room);
    let gone = PURE_ROOMS.iter().filter(|room| !is_there(room)).map(|room| {
        let what = format!("names {room}, which is no crate");
        Finding::new(
            &format!("{RULES}mod.rs"),
            1,
            what,
            WHY,
            "name the crate that it has become in PURE_ROOMS",
        )
    });
    let mut findings: Vec<Finding> = gone.collect();
    for member in members.iter().filter(|member| PURE_ROOMS.contains(&member.room.as_str())) {
        let used = member.dependencies.iter().filter(|used| used.ships && used.room.is_none());
        for used in used.filter(|used| !MAY_USE.contains(&used.name.as_str())) {
            findings.push(Finding::new(
                &member.manifest(),
                member.line_of(&used.name, files),
                format!("{} depends on {}", member.room, used.name),
                WHY,
                format!(
                    "do it in a later room, or, when it only computes, add it to MAY_USE in {RULES}purity.rs"
                ),
            ));
        }
    }
    findings
}

/// Lengths and angles that are taken for computed where they may come from outside: there they are checked.
pub(super) fn check_units(files: &[TreeFile]) -> Vec<Finding> {
    let is_outside = |file: &&TreeFile| file.has_extension(&["rs"]) && in_pure_room(&file.path).is_none();
    let named = |file: &TreeFile| {
        let code = code_only(file.text.as_deref().unwrap_or_default());
        let uses = UNCHECKED.iter().flat_map(|name| words(&code, name).map(move |at| (at, *name)));
        let why = "a figure from outside that is no number would become zero unseen";
        let found = uses.map(|(at, name)| {
            Finding::new(
                &file.path,
                line_at(&code, at),
                format!("names {name}"),
                why,
                "use from_mm or from_deg",
            )
        });
        found.collect::<Vec<_>>()
    };
    files.iter().filter(is_outside).flat_map(named).collect()
}

/// Uses of the outside world in the code of a pure room that is not a test.
pub(super) fn check_sources(files: &[TreeFile]) -> Vec<Finding> {
    let is_code = |file: &&TreeFile| {
        let test = file.path.ends_with("/tests.rs") || file.path.contains("/tests/");
        is_pure(&file.path) && file.has_extension(&["rs"]) && !test
    };
    files.iter().filter(is_code).flat_map(check_source).collect()
}

fn check_source(file: &TreeFile) -> Vec<Finding> {
    let code = without_tests(&code_only(file.text.as_deref().unwrap_or_default()));
    let paths = std_paths(&code).into_iter().filter(|(_, path)| reaches_outside(path));
    let names = FORBIDDEN_NAMES.iter().flat_map(|name| words(&code, name).map(|at| (at, (*name).to_owned())));
    let finding = |(at, name): (usize, String)| {
        let to_do = "take the value as an argument, or move the code to the room that does this (files, app)";
        Finding::new(&file.path, line_at(&code, at), format!("a pure room names {name}"), WHY, to_do)
    };
    paths.chain(names).map(finding).collect()
}

fn reaches_outside(path: &str) -> bool {
    OUTSIDE.iter().any(|outside| {
        let rest = path.strip_prefix(outside);
        rest.is_some_and(|rest| rest.is_empty() || rest.starts_with("::"))
    })
}

/// Every path that starts with `std::`, with `{…}` groups written out, and the offset of its last name.
fn std_paths(code: &str) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    for at in words(code, "std::") {
        expand(code, at, "", &mut found);
    }
    found
}

/// Reads one path at `at` behind `prefix`; returns the offset after it.
fn expand(code: &str, at: usize, prefix: &str, found: &mut Vec<(usize, String)>) -> usize {
    let at = skip_space(code, at);
    if code[at..].starts_with('{') {
        let mut at = skip_space(code, at + 1);
        while at < code.len() && !code[at..].starts_with('}') {
            let end = expand(code, at, prefix, found);
            let separator = code[end..].chars().next().filter(|c| *c == ',' || end == at);
            at = skip_space(code, end + separator.map_or(0, char::len_utf8));
        }
        return (at + 1).min(code.len());
    }
    let is_name = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '*';
    let end = code[at..].find(|c| !is_name(c)).map_or(code.len(), |length| at + length);
    let path = format!("{prefix}{}", &code[at..end]);
    if code[end..].starts_with("::") {
        return expand(code, end + 2, &format!("{path}::"), found);
    }
    found.push((at, path));
    // `fs as files` is still fs.
    code[end..].find([',', '}', ';', '(', ')', '\n']).map_or(end, |length| end + length)
}

fn skip_space(code: &str, at: usize) -> usize {
    code[at..].find(|c: char| !c.is_whitespace()).map_or(code.len(), |length| at + length)
}

#[cfg(test)]
mod tests {
    use super::super::members::Dependency;
    use super::super::sample::{file, places};
    use super::*;

    fn found_in(source: &str) -> Vec<String> {
        check_sources(&[file("crates/core/src/x.rs", source)])
            .iter()
            .map(|finding| finding.what.clone())
            .collect()
    }

    #[test]
    fn a_group_of_imports_is_written_out() {
        let found = found_in(
            "use std::{collections::BTreeMap, fs, time::{Duration, Instant}};\nuse std::io::{self, Read};",
        );
        let expected = [
            "a pure room names std::fs",
            "a pure room names std::time::Instant",
            "a pure room names std::io::self",
            "a pure room names std::io::Read",
        ];
        assert_eq!(found, expected);
    }

    #[test]
    fn the_line_is_that_of_the_name() {
        let source = "//! x\nuse std::{\n    fmt,\n    env as e,\n};\nfn f() { let t = std::time::SystemTime::now(); }\n";
        let found = check_sources(&[file("crates/core/src/x.rs", source)]);
        assert_eq!(
            places(&found),
            ["crates/core/src/x.rs:4", "crates/core/src/x.rs:6", "crates/core/src/x.rs:6"]
        );
    }

    #[test]
    fn documentation_tests_and_harmless_names_are_free() {
        let source = "/// println!(\"{}\", std::fs::x)\nuse std::fmt;\nuse std::time::Duration;\nlet io = 3;\n#[cfg(test)]\nmod tests { use std::fs; fn f() { println!(); } }\n";
        assert_eq!(found_in(source), [""; 0]);
        assert!(check_sources(&[file("crates/files/src/x.rs", "use std::fs;")]).is_empty());
    }

    #[test]
    fn a_crate_that_does_io_is_refused_and_test_crates_are_free() {
        let on = |name: &str, ships| Dependency { name: name.to_owned(), ships, room: None };
        let member = |room: &&str| Member {
            room: (*room).to_owned(),
            dependencies: vec![on("nalgebra", true), on("serde_json", true), on("proptest", false)],
            targets: Vec::new(),
        };
        let manifest = |room: &&str| {
            file(&format!("{room}/Cargo.toml"), "[dependencies]\nnalgebra = \"1\"\nserde_json = \"1\"\n")
        };
        let members: Vec<Member> = PURE_ROOMS.iter().map(member).collect();
        let manifests: Vec<_> = PURE_ROOMS.iter().map(manifest).collect();
        let expected: Vec<String> = PURE_ROOMS.iter().map(|room| format!("{room}/Cargo.toml:3")).collect();
        assert_eq!(places(&check_dependencies(&members, &manifests)), expected);
        assert_eq!(places(&check_dependencies(&members[1..], &manifests))[0], "xtask/src/tidy/mod.rs:1");
    }

    #[test]
    fn a_number_that_is_not_checked_is_refused_outside_the_pure_rooms() {
        let found = |path| places(&check_units(&[file(path, "fn f() {\n    Length::computed(1.0);\n}\n")]));
        assert_eq!(found("crates/files/src/x.rs"), ["crates/files/src/x.rs:2"]);
        assert_eq!(found("crates/core-x/src/x.rs"), ["crates/core-x/src/x.rs:2"]);
        assert!(found("crates/accuracy/src/x.rs").is_empty());
    }
}
