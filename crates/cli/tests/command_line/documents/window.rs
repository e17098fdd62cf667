//! What documents call the things in the window: `*File*` for a word on the screen, `` `Ctrl-Z` `` for a key. Both have to be in the
//! sources of the window.

use std::path::Path;

use crate::documents::markdown::{Document, code_spans};
use crate::documents::{assert_none, root};

/// Documents that lead through the window.
const ABOUT_THE_WINDOW: [&str; 3] = ["docs/tutorial.md", "README.md", "CONTRIBUTING.md"];
/// Keys with a name; others are a single sign.
const KEYS: [&str; 5] = ["Home", "Space", "Delete", "Enter", "Esc"];

/// The sources of the window, tests left out.
fn sources(folder: &Path, text: &mut String) {
    for entry in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap()) {
        let (path, name) = (entry.path(), entry.file_name().display().to_string());
        if path.is_dir() {
            sources(&path, text);
        } else if [".ts", ".tsx"].iter().any(|end| name.ends_with(end)) && !name.contains(".test.") {
            text.push_str(&std::fs::read_to_string(&path).unwrap());
        }
    }
}

/// Words between single asterisks: the menu and its entry are two.
fn labels(line: &str) -> Vec<String> {
    let prose: Vec<&str> = line.split('`').step_by(2).collect();
    let prose = prose.join("").replace("**", "");
    let emphasised = prose.split('*').skip(1).step_by(2);
    emphasised.flat_map(|words| words.split(" ▸ ")).map(str::to_owned).collect()
}

fn is_key(span: &str) -> bool {
    let one = |key: &str| key.chars().count() == 1 || KEYS.contains(&key);
    span.strip_prefix("Ctrl-").map_or(one(span) && !span.chars().all(char::is_lowercase), |key| {
        one(key) || key.starts_with("Shift-")
    })
}

#[test]
fn every_word_and_key_of_the_window_is_there() {
    let mut text = String::new();
    sources(&root().join("ui/src"), &mut text);
    let mut wrong = Vec::new();
    let mut compared = 0;
    for name in ABOUT_THE_WINDOW {
        let document = Document::read(&root().join(name));
        for (line, prose) in document.prose() {
            let labels = labels(prose).into_iter().filter(|label| !text.contains(label.as_str()));
            wrong.extend(labels.map(|label| format!("{}: the window has no '{label}'", document.at(line))));
            for key in code_spans(prose).into_iter().filter(|span| is_key(span)) {
                compared += 1;
                let written = key.replace('-', "+").replace("Esc", "Escape");
                if !text.contains(&format!("\"{written}\"")) {
                    wrong.push(format!("{}: the window has no key {key}", document.at(line)));
                }
            }
        }
    }
    assert_none(&wrong);
    assert!(compared > 5, "the keys of the tutorial were not found");
}
