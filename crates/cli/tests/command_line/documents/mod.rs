//! What the documents say is true: every command in them is run and its output compared, every link and picture is there,
//! every name in a table exists.
//!
//! Where the program has changed what it prints, `UPDATE_EXPECT=1 cargo test -p wirebend-cli documents::` writes the new outputs
//! into the documents. Read the difference before you commit it.
//!
//! The kinds of code blocks that a document may have:
//!
//! | first line | what is done with it |
//! | --- | --- |
//! | `console` | commands after `$ ` are run, one after the other for the whole document, and what follows is their output |
//! | `sh` | not run, because it installs, needs a display or a machine, or takes minutes; its words are looked up |
//! | `json FILE`, `obj FILE`, … | written to that file before the next command |
//! | `json NAME` of a driver's message | each line is compared with the schema of that message |
//! | `text` | a diagram or an equation |
mod console;
mod example;
mod known;
mod links;
mod markdown;
mod messages;
mod names;
mod window;
mod words;

use std::path::{Path, PathBuf};

use markdown::Document;

/// The most that a person reads before they know what this is.
const README_BYTES: usize = 8 * 1024;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap()
}

/// The documents for people who use the program or write for it.
fn documents() -> Vec<Document> {
    let mut paths: Vec<PathBuf> =
        std::fs::read_dir(root().join("docs")).unwrap().map(|e| e.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "md"));
    paths.extend(["README.md", "CONTRIBUTING.md", "drivers/README.md"].map(|name| root().join(name)));
    paths.sort();
    paths.into_iter().map(|path| Document::read(&path)).collect()
}

/// Stops with everything that is wrong, a line each.
#[track_caller]
fn assert_none(wrong: &[String]) {
    assert!(wrong.is_empty(), "\n{}\n", wrong.join("\n"));
}

#[test]
fn the_readme_is_short() {
    let bytes = std::fs::read(root().join("README.md")).unwrap().len();
    assert!(
        bytes <= README_BYTES,
        "README.md has {bytes} bytes, {README_BYTES} are enough: move the rest to docs/"
    );
}

#[test]
fn every_block_of_code_is_of_a_kind_that_is_checked() {
    let mut wrong = Vec::new();
    for document in documents() {
        for block in &document.blocks {
            let known = match &block.name {
                None => ["console", "sh", "text"].contains(&block.language.as_str()),
                Some(_) => ["json", "obj", "toml", "rust"].contains(&block.language.as_str()),
            };
            if !known {
                wrong.push(format!(
                    "{}: a block '{}' is not checked by anything",
                    document.at(block.line),
                    block.language
                ));
            }
            if block.language == "text"
                && block.lines.iter().any(|line| line.trim_start().starts_with("wirebend "))
            {
                wrong.push(format!("{}: commands belong into a block of 'console'", document.at(block.line)));
            }
        }
        // Not the second line of an entry in a list.
        let follows_text = |line: usize| line > 1 && !document.lines[line - 2].trim().is_empty();
        let is_indented = |text: &str| text.starts_with("    ") && !text.trim().is_empty();
        for (line, _) in document.prose().filter(|(line, text)| is_indented(text) && !follows_text(*line)) {
            wrong.push(format!("{}: code is fenced, so that it is checked", document.at(line)));
        }
    }
    assert_none(&wrong);
}
