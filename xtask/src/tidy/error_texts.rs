//! Rule: no code depends on the sentence of an error. Its text is for people; what a program needs is its code, its fields
//! and its remedies.

use super::finding::Finding;
use super::rust_source::{code_only, line_at, test_items, words};
use super::tree::TreeFile;

const WHY: &str =
    "a sentence that is cut or searched breaks when its wording changes, and this goes unnoticed";
const TO_DO: &str = "go by the code, a field or a remedy of the error; what it lacks, add to its type";

/// Files that read the text of a library or of another's driver, since that says it nowhere else.
const PLACES: &[(&str, &str)] = &[
    (
        "crates/driver-api/src/conformance/moving.rs",
        "whether a driver's message names the port is the rule itself",
    ),
    (
        "crates/driver-api/src/conformance/opening.rs",
        "whether a driver's message names the key is the rule itself",
    ),
    ("crates/driver-api/src/serial.rs", "the library of serial ports has no kind for a port that is in use"),
    (
        "crates/files/src/document/version.rs",
        "serde_json ends its text with the place that it also gives as numbers",
    ),
    ("crates/files/src/read/ply.rs", "the grammar of the PLY library puts what it found into its text alone"),
    ("crates/profile/src/layer.rs", "serde gives an unknown key and the known ones in its text alone"),
];

/// Methods that cut a text or search it.
const CUTS: &[&str] = &[
    "contains",
    "starts_with",
    "ends_with",
    "split",
    "split_once",
    "rsplit",
    "rsplit_once",
    "splitn",
    "strip_prefix",
    "strip_suffix",
    "find",
    "rfind",
    "replace",
    "replacen",
    "trim_start_matches",
    "trim_end_matches",
    "matches",
];
const SCRIPT_CUTS: &[&str] = &[
    "lastIndexOf",
    "indexOf",
    "split",
    "includes",
    "replace",
    "replaceAll",
    "slice",
    "substring",
    "substr",
    "match",
    "matchAll",
    "search",
    "startsWith",
    "endsWith",
];

/// What errors are called where their text is taken.
const ERRORS: &[&str] = &["error", "err", "e", "cause", "problem", "refusal", "refused", "fault"];

/// Texts of errors that are cut or searched outside tests.
pub(super) fn check(files: &[TreeFile]) -> Vec<Finding> {
    files.iter().flat_map(check_file).collect()
}

fn check_file(file: &TreeFile) -> Vec<Finding> {
    let Some(text) = file.text.as_deref() else { return Vec::new() };
    let is_test =
        ["/tests/", "/tests.rs", ".test.ts", "/testing."].iter().any(|part| file.path.contains(part));
    if is_test || PLACES.iter().any(|(place, _)| *place == file.path) {
        return Vec::new();
    }
    let rust = ["crates/", "drivers/", "src-tauri/src/"].iter().any(|room| file.path.starts_with(room));
    let found = if rust && file.has_extension(&["rs"]) {
        in_rust(text)
    } else if file.path.starts_with("ui/src/") && file.has_extension(&["ts", "tsx"]) {
        in_script(text)
    } else {
        Vec::new()
    };
    let finding = |(at, what): (usize, String)| {
        Finding::new(
            &file.path,
            line_at(text, at),
            format!("{what} cuts or searches the text of an error"),
            WHY,
            TO_DO,
        )
    };
    found.into_iter().map(finding).collect()
}

fn in_rust(source: &str) -> Vec<(usize, String)> {
    let code = code_only(source);
    let tests = test_items(&code);
    let fields = ["message", "help"].into_iter().flat_map(|field| {
        let of_value = words(&code, field).filter(|&at| code[..at].ends_with('.')).collect::<Vec<_>>();
        of_value.into_iter().filter_map(|at| cut_after(&code, at + field.len(), CUTS).map(|cut| (at, cut)))
    });
    let fields: Vec<_> = fields.collect();
    let taken = words(&code, "to_string()").filter(|&at| is_of_error(&code[..at])).flat_map(|at| {
        let after = at + "to_string()".len();
        let direct = cut_after(&code, after, CUTS).map(|cut| (at, cut));
        let kept = name_of_let(&code[..at]).and_then(|name| cut_of(&code, after, name));
        direct.into_iter().chain(kept)
    });
    let all = fields.into_iter().chain(taken.collect::<Vec<_>>());
    all.filter(|(at, _)| !tests.iter().any(|test| test.contains(at))).collect()
}

/// Whether code ends with an error and a dot.
fn is_of_error(before: &str) -> bool {
    let owner = before.strip_suffix('.').unwrap_or_default();
    let name = owner.rsplit(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or_default();
    ERRORS.contains(&name)
}

/// The name that a text is kept under, where the statement that code ends in is a `let`.
fn name_of_let(before: &str) -> Option<&str> {
    let statement = before.rsplit([';', '{', '}']).next()?.trim_start();
    let named = statement.strip_prefix("let ")?.trim_start();
    let named = named.strip_prefix("mut ").unwrap_or(named);
    let name = named.split(|c: char| !c.is_alphanumeric() && c != '_').next()?;
    (!name.is_empty()).then_some(name)
}

/// The first cut of a text that is kept under a name, before its block ends.
fn cut_of(code: &str, from: usize, name: &str) -> Option<(usize, String)> {
    let mut depth = 0_i32;
    let end = code[from..].char_indices().find_map(|(offset, c)| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        (depth < 0).then_some(from + offset)
    });
    let block = &code[from..end.unwrap_or(code.len())];
    words(block, name).find_map(|at| cut_after(block, at + name.len(), CUTS).map(|cut| (from + at, cut)))
}

/// The method that cuts what ends at an offset, with those before it that hand the text on.
fn cut_after(code: &str, mut at: usize, cuts: &[&'static str]) -> Option<String> {
    const HAND_ON: &[&str] = &["as_str", "as_ref", "to_lowercase", "trim", "toLowerCase", "clone"];
    loop {
        let rest = code[at..].trim_start();
        let rest = rest.strip_prefix('?').unwrap_or(rest);
        let called = rest.strip_prefix('.')?;
        let name = called.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or_default();
        if !called[name.len()..].starts_with('(') {
            return None;
        }
        if cuts.contains(&name) {
            return Some(name.to_owned());
        }
        if !HAND_ON.contains(&name) {
            return None;
        }
        at = code.len() - called.len() + name.len() + "()".len();
    }
}

fn in_script(source: &str) -> Vec<(usize, String)> {
    let code = without_comments(source);
    let mut found = Vec::new();
    for field in ["message", "help"] {
        for at in words(&code, field) {
            if let Some(cut) = cut_after(&code, at + field.len(), SCRIPT_CUTS) {
                found.push((at, cut));
            } else if let Some(test) = tested(&code, at) {
                found.push((at, test.to_owned()));
            }
        }
    }
    found
}

/// The method of a regular expression whose argument ends with the field at an offset: `/x/.test(problem.message)`.
fn tested(code: &str, at: usize) -> Option<&'static str> {
    let argument = code[..at].trim_end_matches(|c: char| c.is_alphanumeric() || "._?".contains(c));
    ["test", "exec"].into_iter().find(|method| argument.ends_with(&format!(".{method}(")))
}

/// The source with the insides of its comments replaced by spaces.
fn without_comments(source: &str) -> String {
    let mut code = String::with_capacity(source.len());
    let mut in_block = false;
    for line in source.split_inclusive('\n') {
        let trimmed = line.trim_start();
        in_block |= trimmed.starts_with("/*");
        if in_block || trimmed.starts_with("//") {
            code.extend(line.chars().map(|c| if c == '\n' { c } else { ' ' }));
            // Offsets are those of the source.
            let wide = line.len() - line.chars().count();
            let end = code.len() - usize::from(code.ends_with('\n'));
            code.insert_str(end, &" ".repeat(wide));
        } else {
            code.push_str(line);
        }
        in_block &= !trimmed.contains("*/");
    }
    code
}

#[cfg(test)]
mod tests {
    use super::super::sample::{file, places};
    use super::*;

    fn lines(path: &str, source: &str) -> Vec<String> {
        places(&check(&[file(path, source)]))
    }

    #[test]
    fn a_message_that_is_searched_is_found() {
        let source = "fn f(error: &E) -> bool {\n    error.message.contains(\"busy\")\n        || refusal\n            .help\n            .starts_with(\"x\")\n}";
        assert_eq!(lines("crates/api/src/x.rs", source), ["crates/api/src/x.rs:2", "crates/api/src/x.rs:4"]);
        assert_eq!(lines("drivers/grbl/src/x.rs", source).len(), 2);
        assert!(lines("xtask/src/x.rs", source).is_empty());
    }

    #[test]
    fn the_text_of_an_error_is_found_at_once_and_under_a_name() {
        let direct = "fn f() { if error.to_string().starts_with(\"unknown variant\") {} }";
        assert_eq!(lines("crates/api/src/x.rs", direct).len(), 1);
        let kept = "fn f() {\n    let text = cause.to_string().to_lowercase();\n    g(&text);\n    text.split(\"; \");\n}";
        assert_eq!(lines("crates/api/src/x.rs", kept), ["crates/api/src/x.rs:4"]);
        let lower = "fn f() { error.to_string().to_lowercase().contains(\"x\"); }";
        assert_eq!(lines("crates/api/src/x.rs", lower).len(), 1);
    }

    #[test]
    fn other_texts_tests_and_what_is_only_shown_are_free() {
        let free = "fn f() {\n    let text = number.to_string();\n    text.split('.');\n    let shown = error.to_string();\n    show(shown);\n    // error.message.contains(\"x\")\n    line.contains(\"x\");\n    error.message.is_empty();\n}\nfn g(shown: &str) { shown.contains(\"x\"); }\n#[cfg(test)]\nmod tests { fn f() { error.message.contains(\"x\"); } }";
        assert!(lines("crates/api/src/x.rs", free).is_empty());
        let test = "fn f() { error.message.contains(\"x\"); }";
        assert!(lines("crates/api/tests/all/x.rs", test).is_empty());
        assert!(lines(PLACES[0].0, test).is_empty());
    }

    #[test]
    fn the_window_neither_cuts_nor_tests_a_message() {
        let cut = "const before = (problem) => problem.message.slice(0, problem.message.lastIndexOf(\"; \"));\nconst b = help?.split(\". \");\nif (/busy/.test(refusal.message)) x();\n";
        let found = lines("ui/src/features/x.ts", cut);
        assert_eq!(
            found,
            [
                "ui/src/features/x.ts:1",
                "ui/src/features/x.ts:1",
                "ui/src/features/x.ts:3",
                "ui/src/features/x.ts:2"
            ]
        );
        let free = "/** message.split(x) – no */\nconst a = problem.message;\nshow(said(note.message), names.includes(a));\nexpect(x);\n";
        assert!(lines("ui/src/features/x.ts", free).is_empty());
        assert!(lines("ui/src/features/x.test.ts", cut).is_empty());
    }
}
