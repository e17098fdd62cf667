//! Rule: a crate knows the stages before it and none after. The table below is the architecture.

use super::finding::Finding;
use super::members::Member;
use super::tree::TreeFile;

const WHY: &str = "the flow of the house is one way, so that a stage can be read and tested alone";

/// Which rooms each room may depend on; `drivers/*` is any folder there, `*` is every room. Tests obey it too.
const MAY_KNOW: &[(&str, &[&str])] = &[
    ("crates/collide", &[]),
    ("crates/postman", &[]),
    ("crates/frame", &[]),
    ("crates/core", &["crates/collide", "crates/postman"]),
    ("crates/accuracy", &["crates/core", "crates/frame"]),
    ("crates/sequence", &["crates/core", "crates/collide", "crates/frame", "tests/brute"]),
    ("crates/error", &[]),
    ("crates/profile", &["crates/error"]),
    ("crates/files", &["crates/core", "crates/error", "crates/profile", "crates/frame"]),
    ("fuzz", &["crates/files"]),
    ("crates/driver-api", &[]),
    ("crates/journal", &[]),
    ("crates/driver-host", &["crates/driver-api", "crates/error", "crates/journal", "tests/built"]),
    ("drivers/*", &["crates/driver-api"]),
    (
        "crates/planning",
        &[
            "crates/core",
            "crates/accuracy",
            "crates/sequence",
            "crates/error",
            "crates/profile",
            "crates/files",
            "crates/frame",
            "crates/driver-host",
        ],
    ),
    (
        "crates/editor",
        &[
            "crates/core",
            "crates/error",
            "crates/profile",
            "crates/files",
            "crates/journal",
            "crates/planning",
            "tests/built",
        ],
    ),
    (
        "crates/operation",
        &[
            "crates/core",
            "crates/error",
            "crates/profile",
            "crates/files",
            "crates/journal",
            "crates/driver-host",
            "crates/planning",
            "tests/built",
        ],
    ),
    (
        "crates/api",
        &[
            "crates/core",
            "crates/error",
            "crates/profile",
            "crates/files",
            "crates/driver-host",
            "crates/planning",
            "crates/editor",
            "crates/operation",
            "tests/brute",
            "tests/built",
        ],
    ),
    // Its tests write journals as an earlier run would have left them.
    ("crates/cli", &["crates/api", "crates/journal", "tests/brute", "tests/built"]),
    ("src-tauri", &["crates/api"]),
    ("tests/loopback", &["crates/api"]),
    // What tests load or start, not link; only for tests and benchmarks.
    ("tests/built", &[]),
    // Sequences are confirmed by what knows neither the search, its check nor what solves frames.
    ("tests/brute", &[]),
    // Its tests join what is fitted and the physics that it is fitted to, which know nothing of each other.
    ("tests/calibration", &["crates/core", "crates/driver-api", "drivers/wirebend-kit"]),
    ("tests/firmware", &["drivers/wirebend-kit", "crates/driver-api", "tests/built"]),
    (
        "benches",
        &[
            "crates/collide",
            "crates/postman",
            "crates/frame",
            "crates/core",
            "crates/accuracy",
            "crates/sequence",
            "crates/profile",
            "crates/files",
            "crates/driver-host",
            "crates/planning",
            "crates/api",
            "drivers/template",
            "tests/brute",
            "tests/built",
        ],
    ),
    ("xtask", &["*"]),
];

/// One finding for each dependency that the table does not allow, and for each crate that it does not know.
pub(super) fn check(members: &[Member], files: &[TreeFile]) -> Vec<Finding> {
    members.iter().flat_map(|member| check_member(member, files)).collect()
}

fn check_member(member: &Member, files: &[TreeFile]) -> Vec<Finding> {
    let path = member.manifest();
    let Some((_, allowed)) = MAY_KNOW.iter().find(|(room, _)| matches(room, &member.room)) else {
        let what = format!("{} is not in the table of rooms", member.room);
        return vec![Finding::new(&path, 1, what, WHY, "add it to MAY_KNOW in xtask/src/tidy/rooms.rs")];
    };
    let mut findings = Vec::new();
    for dependency in &member.dependencies {
        let Some(room) = &dependency.room else { continue };
        // What measures is in no package.
        let is_shipped = dependency.ships && member.room != "benches";
        if is_shipped && room.starts_with("tests/") {
            findings.push(Finding::new(
                &path,
                member.line_of(&dependency.name, files),
                format!("{} ships {room}", member.room),
                "what helps tests has no place in the program",
                "move it to [dev-dependencies]",
            ));
        }
        if !allowed.iter().any(|pattern| matches(pattern, room)) {
            findings.push(Finding::new(
                &path,
                member.line_of(&dependency.name, files),
                format!("{} depends on {room}", member.room),
                WHY,
                format!("move the code that needs it to a later room; this one may know: {}", list(allowed)),
            ));
        }
    }
    findings
}

fn matches(pattern: &str, room: &str) -> bool {
    match pattern.strip_suffix('*') {
        Some(prefix) => room.starts_with(prefix),
        None => room == pattern,
    }
}

fn list(rooms: &[&str]) -> String {
    if rooms.is_empty() { "no other room".to_owned() } else { rooms.join(", ") }
}

#[cfg(test)]
mod tests {
    use super::super::members::Dependency;
    use super::super::sample::{file, places};
    use super::*;

    fn member(room: &str, on: &[(&str, bool)]) -> Member {
        let dependencies = on.iter().map(|&(room, ships)| Dependency {
            name: room.rsplit('/').next().unwrap_or(room).to_owned(),
            ships,
            room: Some(room.to_owned()),
        });
        Member { room: room.to_owned(), dependencies: dependencies.collect(), targets: Vec::new() }
    }

    #[test]
    fn the_flow_of_the_house_is_allowed() {
        let members = [
            member("crates/files", &[("crates/core", true), ("crates/profile", true)]),
            member("crates/cli", &[("crates/api", true)]),
            member("drivers/grbl", &[("crates/driver-api", true)]),
            member("xtask", &[("crates/api", true), ("crates/cli", true)]),
        ];
        assert!(check(&members, &[]).is_empty());
    }

    #[test]
    fn a_step_against_the_flow_is_found_on_its_line_even_in_dev_dependencies() {
        let manifest =
            file("crates/core/Cargo.toml", "[package]\n\n[dev-dependencies]\nfiles.workspace = true\n");
        let found = check(&[member("crates/core", &[("crates/files", false)])], &[manifest]);
        assert_eq!(places(&found), ["crates/core/Cargo.toml:4"]);
    }

    #[test]
    fn a_driver_must_not_see_the_app_nor_the_host() {
        let driver = member("drivers/pensa", &[("crates/api", true), ("crates/driver-host", true)]);
        assert_eq!(check(&[driver], &[]).len(), 2);
    }

    #[test]
    fn what_helps_tests_does_not_ship() {
        assert!(check(&[member("crates/api", &[("tests/built", false)])], &[]).is_empty());
        assert_eq!(check(&[member("crates/api", &[("tests/built", true)])], &[]).len(), 1);
    }

    #[test]
    fn an_unknown_crate_must_be_added() {
        let found = check(&[member("crates/extra", &[])], &[]);
        assert!(found[0].to_do.contains("add it"), "{}", found[0]);
    }
}
