//! The core on this computer under gcc's sanitizers and with every branch counted, sent anything at all by the
//! program in `firmware/fuzz/`, which ends when a rule is broken.

use std::path::{Path, PathBuf};
use std::process::Command;

/// Branches of these files decide what a line is; every one of them has to be taken both ways.
const PARSER: [&str; 5] = ["rx", "frame", "parse", "reply", "crc"];
const OTHERS: [&str; 14] = [
    "bend", "commands", "entry", "homing", "inputs", "limits", "motion", "motors", "peg", "replies",
    "safety", "session", "settings", "stepper",
];

fn make(target: &str, out: &Path) -> String {
    let firmware = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../firmware");
    let mut make = Command::new("make");
    make.arg("--no-print-directory").arg("-C").arg(firmware).arg(format!("HOST_OUT={}", out.display()));
    make.arg("MIXTURES=2000").arg(target).env_remove("MAKEFLAGS").env_remove("MAKELEVEL");
    let done = make.output().unwrap();
    let errors = String::from_utf8_lossy(&done.stderr);
    assert!(done.status.success(), "make {target}: {errors}");
    String::from_utf8(done.stdout).unwrap()
}

#[test]
fn nothing_that_is_said_breaks_a_rule() {
    let out = tempfile::tempdir().unwrap();
    let said = make("replay", out.path());
    let count = said.lines().last().unwrap();
    println!("{count}: no rule broken, nothing for the sanitizers of addresses and undefined behaviour");
    assert!(count.contains("2000 mixtures"), "{said}");
}

/// How often each branch of a file was taken, from gcov's report.
fn branches(report: &PathBuf) -> Vec<(usize, u64)> {
    let mut line = 0;
    let mut branches = Vec::new();
    for row in std::fs::read_to_string(report).unwrap().lines() {
        if let Some(branch) = row.strip_prefix("branch ") {
            let taken = branch.split_whitespace().skip_while(|&word| word != "taken").nth(1);
            branches.push((line, taken.map_or(0, |taken| taken.parse().unwrap())));
        } else if let Some(number) = row.split(':').nth(1).and_then(|number| number.trim().parse().ok()) {
            line = number;
        }
    }
    branches
}

#[test]
fn every_branch_of_the_parser_is_taken() {
    let out = tempfile::tempdir().unwrap();
    make("coverage", out.path());
    let mut never = Vec::new();
    for file in PARSER.into_iter().chain(OTHERS) {
        let branches = branches(&out.path().join(format!("coverage/{file}.c.gcov")));
        let taken = branches.iter().filter(|(_, taken)| *taken > 0).count();
        println!("{file}.c: {taken} of {} branches taken", branches.len());
        assert!(branches.len() > 1, "{file}.c: no report");
        if PARSER.contains(&file) {
            never.extend(
                branches.iter().filter(|(_, taken)| *taken == 0).map(|(line, _)| format!("{file}.c:{line}")),
            );
        }
    }
    assert!(never.is_empty(), "never taken: {never:?}");
}
