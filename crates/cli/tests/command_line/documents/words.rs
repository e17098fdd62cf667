//! Blocks of `sh`: commands that install, need a display or a machine, or take minutes. They are not run; their words are looked up.

use std::path::Path;

use crate::documents::markdown::code_spans;
use crate::documents::{assert_none, documents, root};

/// Commands of the system, whose words are not ours to check.
const OF_THE_SYSTEM: [&str; 16] = [
    "sudo",
    "apt-get",
    "cd",
    "cp",
    "rm",
    "git",
    "export",
    "avrdude",
    "python3",
    "cc",
    "gcc",
    "cl",
    "sha256sum",
    "mkdir",
    "rustup",
    "npm",
];

#[test]
fn every_command_that_is_not_run_has_words_that_exist() {
    let mut wrong = Vec::new();
    for document in documents() {
        for block in document.blocks.iter().filter(|block| block.language == "sh") {
            for (k, line) in block.lines.iter().enumerate() {
                let command = line.split(" # ").next().unwrap_or(line).trim();
                if let Some(what) = unknown(command) {
                    wrong.push(format!("{}: {what}", document.at(block.line + 1 + k)));
                }
            }
        }
    }
    assert_none(&wrong);
}

#[test]
fn every_make_target_in_the_text_exists() {
    let mut wrong = Vec::new();
    for document in documents() {
        for (line, text) in document.prose() {
            let targets = code_spans(text).into_iter().filter(|span| span.starts_with("make "));
            wrong.extend(targets.filter_map(unknown).map(|what| format!("{}: {what}", document.at(line))));
        }
    }
    assert_none(&wrong);
}

/// Why a command could not be given; `None` where it could.
fn unknown(command: &str) -> Option<String> {
    let mut words = command.split_whitespace().map(|word| word.trim_matches('"')).peekable();
    // Variables for the command alone come before it.
    while words
        .next_if(|word| word.split('=').next().is_some_and(is_variable) && word.contains('='))
        .is_some()
    {}
    let program = words.next()?;
    let words: Vec<&str> = words.collect();
    match program {
        comment if comment.starts_with('#') => None,
        "make" => make(&words),
        "cargo" => cargo(&words),
        "wirebend" => wirebend(&words),
        known if OF_THE_SYSTEM.contains(&known) => None,
        _ => Some(format!("`{program}` is not known to this test")),
    }
}

fn is_variable(word: &str) -> bool {
    !word.is_empty() && word.chars().all(|c| c.is_ascii_uppercase() || c == '_')
}

/// The targets have to be in the Makefile, and variables be used there.
fn make(words: &[&str]) -> Option<String> {
    let folder = words.iter().position(|word| *word == "-C").and_then(|at| words.get(at + 1));
    let file = root().join(folder.copied().unwrap_or_default()).join("Makefile");
    let makefile = std::fs::read_to_string(&file).ok()?;
    words.iter().filter(|word| **word != "-C" && Some(*word) != folder).find_map(|word| {
        let is_there = match word.split_once('=') {
            Some((variable, _)) => {
                makefile.contains(&format!("{variable} ")) || makefile.contains(&format!("({variable}"))
            }
            None => rules(&makefile).any(|target| target == *word),
        };
        (!is_there).then(|| format!("{} has no {word}", file.display()))
    })
}

/// The targets of a Makefile.
fn rules(makefile: &str) -> impl Iterator<Item = &str> {
    let rules = makefile
        .lines()
        .filter(|line| !line.starts_with(['\t', '#', '.']))
        .filter(|line| !line.contains(":="));
    rules.filter_map(|line| line.split_once(':')).flat_map(|(targets, _)| targets.split_whitespace())
}

/// Packages have to be members of the workspace or of the document's own making, and test targets files.
fn cargo(words: &[&str]) -> Option<String> {
    let after = |name: &str| words.iter().position(|word| *word == name).and_then(|at| words.get(at + 1));
    let package = after("-p").or_else(|| after("--package"))?;
    let members = std::fs::read_to_string(root().join("Cargo.toml")).unwrap();
    let folders = members.lines().filter_map(|line| line.trim().strip_prefix('"')?.split('"').next());
    let folder = folders.map(|folder| root().join(folder)).find(|folder| {
        std::fs::read_to_string(folder.join("Cargo.toml"))
            .is_ok_and(|manifest| manifest.contains(&format!("name = \"{package}\"")))
    });
    let Some(folder) = folder else {
        // The driver that a reader makes.
        return (*package != "wirebend-driver-my-bender").then(|| format!("there is no package {package}"));
    };
    let test = after("--test").or_else(|| after("--bench"))?;
    let is_there = ["tests", "benches"].iter().any(|kind| {
        folder.join(kind).join(format!("{test}.rs")).is_file()
            || folder.join(kind).join(test).join("main.rs").is_file()
    });
    (!is_there).then(|| format!("{package} has no test {test}"))
}

/// The program has to understand the words, and examples have to be there.
fn wirebend(words: &[&str]) -> Option<String> {
    let redirected = words.iter().position(|word| matches!(*word, ">" | "|" | "&&")).unwrap_or(words.len());
    let parsed = wirebend_cli::command()
        .try_get_matches_from(std::iter::once(&"wirebend").chain(&words[..redirected]));
    if let Err(error) = parsed {
        return Some(error.to_string());
    }
    let missing =
        words.iter().find(|word| word.starts_with("examples/") && !root().join(Path::new(word)).exists());
    missing.map(|word| format!("{word} is not there"))
}

#[test]
fn words_that_do_not_exist_are_found() {
    for known in [
        "make build",
        "make -C firmware flash PORT=/dev/ttyACM0",
        "UPDATE_EXPECT=1 cargo test -p wirebend-api --test all golden",
        "cargo test -p wirebend-core --test all routes::",
        "wirebend check examples/house.obj --machine wirebend-kit",
        "# a remark",
    ] {
        assert_eq!(unknown(known), None, "{known}");
    }
    for wrong in [
        "make nothing",
        "make -C firmware nothing",
        "make build NOTHING=1",
        "cargo test -p wirebend-nothing",
        "cargo test -p wirebend-api --test nothing",
        "wirebend check --nothing a.obj",
        "wirebend plan examples/nothing.obj -m x",
        "nothing",
    ] {
        assert!(unknown(wrong).is_some(), "{wrong} was taken");
    }
}
