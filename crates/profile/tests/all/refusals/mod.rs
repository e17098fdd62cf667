//! What is refused, and what a person then reads: file, line, expectation, remedy.
#![allow(clippy::needless_pass_by_value, reason = "an `expect![]` is handed over where it stands")]
#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them so")]

mod machines;
mod reading;
mod relatives;
mod wires;

use std::fmt::Write as _;

use expect_test::Expect;
use serde_json::{Value, json};
use wirebend_profile::{Library, ProfileError, check_text};

/// A small child of the kit with more lines put in.
pub(crate) fn child(lines: &str) -> String {
    format!(
        "{{\n\"schema_version\": 1,\n\"kind\": \"machine\",\n\"id\": \"mine\",\n\
         \"inherits\": \"wirebend-kit\"{}{lines}\n}}",
        if lines.is_empty() { "" } else { ",\n" }
    )
}

pub(crate) fn figure(value: f64) -> Value {
    json!({"value": value, "source": "test", "measured": false})
}

/// All messages for a text, each between its code and what can be done about it.
pub(crate) fn refuse(file: &str, text: &str, expected: Expect) {
    expected.assert_eq(&messages(&check_text(file, text).unwrap_err()));
}

pub(crate) fn messages(errors: &[ProfileError]) -> String {
    let mut text = String::new();
    for error in errors {
        writeln!(text, "{}: {error} {:?}", error.code(), error.remedies()).unwrap();
    }
    text
}

/// Writes files into a new folder, adds it to the shipped profiles, and hides the folder's name.
pub(crate) fn refuse_folder(files: &[(&str, &[u8])], expected: Expect) {
    let root = tempfile::tempdir().unwrap();
    for (path, bytes) in files {
        let path = root.path().join(path);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, bytes).unwrap();
    }
    let added = Library::shipped().unwrap().add_folder(root.path());
    let name = root.path().display().to_string();
    expected.assert_eq(&messages(&added.refused).replace(&name, "PROFILES").replace('\\', "/"));
}
