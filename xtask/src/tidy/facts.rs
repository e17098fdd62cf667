//! Rule: `core`, `accuracy` and `sequence` say facts, not prose. They format nothing but units and ids, hold no text of several
//! words, and their errors give no advice.

use std::ops::Range;

use super::finding::Finding;
use super::is_pure;
use super::rust_source::{attributes, code_only, item_end, line_at, strings, test_items, words};
use super::tree::TreeFile;

const WHY: &str =
    "a sentence in a pure room is worded again by every front end, and not all of them are found";
const TO_DO: &str =
    "carry the figures in a Fact, a Remedy or an error, and word them in crates/planning/src/text";

/// Words with which an error would advise a person what to do.
const ADVICE: &[&str] = &["give", "choose", "leave", "correct", "try", "please", "instead"];

/// Prose in the code of the pure rooms that is not a test.
pub(super) fn check(files: &[TreeFile]) -> Vec<Finding> {
    let is_code = |file: &&TreeFile| {
        let test = ["/tests.rs", "/testing.rs"].iter().any(|name| file.path.ends_with(name))
            || file.path.contains("/tests/");
        is_pure(&file.path) && file.has_extension(&["rs"]) && !test
    };
    files.iter().filter(is_code).flat_map(check_source).collect()
}

fn check_source(file: &TreeFile) -> Vec<Finding> {
    let source = file.text.as_deref().unwrap_or_default();
    let code = code_only(source);
    let tests = test_items(&code);
    let found = formatting(&code)
        .map(|(at, name)| (at, format!("formats text with {name}")))
        .chain(texts(source, &code));
    found
        .filter(|(at, _)| !within(&tests, *at))
        .map(|(at, what)| Finding::new(&file.path, line_at(source, at), what, WHY, TO_DO))
        .collect()
}

/// Macros that make text. Units, ids and coordinates may write themselves in their `Display`.
fn formatting(code: &str) -> impl Iterator<Item = (usize, &'static str)> {
    let display: Vec<Range<usize>> =
        words(code, "Display for").map(|at| at..item_end(code.as_bytes(), at)).collect();
    let of = |name: &'static str| words(code, name).map(move |at| (at, name)).collect::<Vec<_>>();
    let written = ["write!", "writeln!"].into_iter().flat_map(of);
    let written: Vec<_> = written.filter(|(at, _)| !within(&display, *at)).collect();
    ["format!", "format_args!"].into_iter().flat_map(of).chain(written)
}

/// Texts of several words outside attributes, and advice in the texts of errors.
fn texts<'s>(source: &'s str, code: &'s str) -> impl Iterator<Item = (usize, String)> + 's {
    let attributes = attributes(code);
    strings(source).into_iter().filter_map(move |text| {
        let at = text.start;
        let text = &source[text];
        let Some(attribute) = attributes.iter().find(|attribute| attribute.contains(&at)) else {
            return is_prose(text).then(|| (at, format!("holds the text {text}")));
        };
        let of_error = code[attribute.clone()].starts_with("#[error");
        let advice = ADVICE.iter().find(|advice| words(text, advice).next().is_some());
        let option = ["--", "`"].iter().find(|option| text.contains(**option));
        let word = advice.or(option).filter(|_| of_error)?;
        Some((at, format!("an error says '{word}', which is advice or a front end's word")))
    })
}

/// Whether a text has two words next to each other; figures with a unit and separators have not.
fn is_prose(text: &str) -> bool {
    let words: Vec<&str> = text.trim_matches('"').split(' ').collect();
    let is_word = |word: &str| word.len() > 1 && word.chars().all(char::is_alphabetic);
    words.windows(2).any(|pair| pair.iter().all(|word| is_word(word.trim_end_matches([',', ':', ';', '.']))))
}

fn within(ranges: &[Range<usize>], at: usize) -> bool {
    ranges.iter().any(|range| range.contains(&at))
}

#[cfg(test)]
mod tests {
    use super::super::sample::file;
    use super::*;

    fn found_in(source: &str) -> Vec<String> {
        check(&[file("crates/core/src/x.rs", source)])
            .iter()
            .map(|finding| format!("{}: {}", finding.line, finding.what))
            .collect()
    }

    #[test]
    fn text_that_is_formatted_is_found() {
        let source =
            "fn f() -> String {\n    format!(\"{}\", 1)\n}\nfn g(out: &mut W) { write!(out, \"x\") }";
        let expected = ["2: formats text with format!", "4: formats text with write!"];
        assert_eq!(found_in(source), expected);
    }

    #[test]
    fn a_sentence_is_found_and_a_name_is_not() {
        let source = "const A: &str = \"weld_tolerance\";\nconst B: &str = \"the weld tolerance\";\ncodes! { /// An edge has no length.\n X = \"y z\", }";
        assert_eq!(found_in(source), ["2: holds the text \"the weld tolerance\""]);
    }

    #[test]
    fn units_documentation_and_tests_are_free() {
        let source = "//! Some words here: format!(\"a b\").\nimpl fmt::Display for Length {\n    fn fmt(&self) { write!(f, \"{:.1} mm\", self.0) }\n}\n#[doc = \"some words\"]\n#[cfg(test)]\nmod tests { fn f() { panic!(\"{}\", format!(\"not here\")) } }";
        assert_eq!(found_in(source), [""; 0]);
        let formats = |path| check(&[file(path, "fn f() { format!(\"a b\") }")]).len();
        let places = [
            "crates/files/src/x.rs",
            "crates/core/tests/x.rs",
            "crates/accuracy/src/x.rs",
            "crates/sequence/src/a/b.rs",
        ];
        assert_eq!(places.map(formats), [0, 0, 1, 1]);
    }

    #[test]
    fn an_error_states_and_does_not_advise() {
        let source = "#[error(\"there is no edge {0}\")]\nstruct A;\n#[error(\n    \"too short; give a longer one\"\n)]\nstruct B;\n#[error(\"not there: see --help\")]\nstruct C;";
        let said = found_in(source);
        assert_eq!(said.len(), 2, "{said:?}");
        assert!(said[0].starts_with("4: an error says 'give'"), "{said:?}");
        assert!(said[1].starts_with("7: an error says '--'"), "{said:?}");
    }
}
