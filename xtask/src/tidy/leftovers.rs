//! Rule: nothing unfinished stays in the tree.

use super::RULES;
use super::finding::Finding;
use super::rust_source::{code_only, line_at, words};
use super::tree::TreeFile;

const WHY: &str = "unfinished work in the tree is forgotten there";

/// In Rust code, outside comments and strings.
const IN_CODE: &[(&str, &str)] = &[
    ("todo!(", "write the code, or return an error that a person can read"),
    ("unimplemented!(", "write the code, or return an error that a person can read"),
    ("dbg!(", "remove it"),
    ("#[ignore", "repair the test or delete it"),
];

/// In any text, comments included.
const IN_TEXT: &[&str] = &["TODO", "FIXME", "XXX"];

/// Unfinished code, ignored tests and notes to oneself.
pub(super) fn check(files: &[TreeFile]) -> Vec<Finding> {
    let searched =
        files.iter().filter(|file| !file.path.starts_with(RULES) && !file.is_fixture() && !is_data(file));
    searched.flat_map(|file| in_code(file).into_iter().chain(in_text(file))).collect()
}

fn is_data(file: &TreeFile) -> bool {
    file.has_extension(&["lock", "json", "obj", "stl", "ply", "svg", "dxf"])
}

fn in_code(file: &TreeFile) -> Vec<Finding> {
    if !file.has_extension(&["rs"]) {
        return Vec::new();
    }
    let code = code_only(file.text.as_deref().unwrap_or_default());
    let places =
        IN_CODE.iter().flat_map(|&(found, to_do)| words(&code, found).map(move |at| (at, found, to_do)));
    places.map(|(at, found, to_do)| Finding::new(&file.path, line_at(&code, at), found, WHY, to_do)).collect()
}

fn in_text(file: &TreeFile) -> Vec<Finding> {
    let text = file.text.as_deref().unwrap_or_default();
    let places = IN_TEXT.iter().flat_map(|word| words(text, word).map(move |at| (at, *word)));
    let finding = |(at, word)| {
        Finding::new(&file.path, line_at(text, at), format!("the word {word}"), WHY, "do it, or drop it")
    };
    places.map(finding).collect()
}

#[cfg(test)]
mod tests {
    use super::super::sample::{file, places};
    use super::*;

    #[test]
    fn unfinished_code_is_found_on_its_line() {
        let source = "fn a() {\n    todo!()\n}\n#[ignore = \"slow\"]\nfn b() { dbg!(1); } // FIXME later\n";
        let mut found = places(&check(&[file("crates/api/src/a.rs", source)]));
        found.sort();
        assert_eq!(
            found,
            [
                "crates/api/src/a.rs:2",
                "crates/api/src/a.rs:4",
                "crates/api/src/a.rs:5",
                "crates/api/src/a.rs:5"
            ]
        );
    }

    #[test]
    fn a_note_in_a_script_is_found() {
        assert_eq!(places(&check(&[file("Makefile", "a:\n# TODO\n")])), ["Makefile:2"]);
    }

    #[test]
    fn strings_longer_words_and_data_are_free() {
        let source = "let a = \"dbg!(\"; /// `todo!()` is refused\nlet todo_list = 1; const XXXL: u8 = 0;";
        assert!(check(&[file("crates/api/src/a.rs", source), file("tests/golden/a.txt", "TODO")]).is_empty());
    }
}
