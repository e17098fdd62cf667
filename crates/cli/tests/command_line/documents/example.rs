//! The check that CONTRIBUTING.md writes as an exercise: it is new, and it would compile.

use std::collections::BTreeSet;

use crate::documents::markdown::Document;
use crate::documents::root;

fn source(name: &str) -> String {
    std::fs::read_to_string(root().join("crates/core/src/checks").join(name)).unwrap()
}

/// The lines between one that ends in `start` and the next that begins with `end`.
fn between<'a>(text: &'a str, start: &'a str, end: &'a str) -> impl Iterator<Item = &'a str> {
    let lines = text.lines().map(str::trim).skip_while(move |line| !line.ends_with(start)).skip(1);
    lines.take_while(move |line| !line.starts_with(end))
}

#[test]
fn the_exercise_fits_the_checks_that_there_are() {
    let document = Document::read(&root().join("CONTRIBUTING.md"));
    let block = document.blocks.iter().find(|block| block.language == "rust").unwrap();
    let example = block.lines.join("\n");

    let wanted = source("diagnostic.rs");
    let fields =
        between(&wanted, "pub struct Diagnostic {", "}").filter_map(|line| line.strip_prefix("pub "));
    let fields: BTreeSet<&str> = fields.filter_map(|field| field.split(':').next()).collect();
    let given = between(&example, "Diagnostic {", "}").filter_map(|field| field.split(':').next()).collect();
    assert!(fields.len() > 3, "the fields of a diagnostic were not found");
    assert_eq!(fields, given, "the exercise of CONTRIBUTING.md does not fill in a Diagnostic");

    let used = example.split("use super::{").nth(1).and_then(|rest| rest.split('}').next()).unwrap();
    for name in used.split(", ") {
        assert!(source("mod.rs").contains(name), "crates/core/src/checks has no {name}");
    }
    assert!(!wanted.contains("ManyBends"), "the check of the exercise is there already: take another one");
}
