//! Rule: every field of a C struct of the firmware has its unit beside it.

use super::finding::Finding;
use super::tree::TreeFile;

const FOLDER: &str = "firmware/";

/// Units, and what a number is that has none. A comment may continue after one of them.
const UNITS: &[&str] = &[
    "steps/s^2",
    "steps/s",
    "steps",
    "pulses",
    "0.5 us",
    "4 us",
    "us",
    "1.024 ms",
    "ms",
    "cycles",
    "bytes",
    "lines",
    "readings",
    "starts",
    "percent",
    "numbers",
    "number",
    "index",
    "id",
    "code",
    "letter",
    "bits",
    "flag",
    "sign",
    "enum",
    "CRC",
];

/// Types of which a field is one number, or an array of them.
const TYPES: &[&str] = &[
    "bool", "char", "int8_t", "int16_t", "int32_t", "int64_t", "uint8_t", "uint16_t", "uint32_t", "uint64_t",
    "size_t",
];

const WHY: &str = "a number without a unit is read in the wrong one";

/// Fields without a comment that begins with a unit.
pub(super) fn check(files: &[TreeFile]) -> Vec<Finding> {
    let is_c = |file: &&TreeFile| file.path.starts_with(FOLDER) && file.has_extension(&["c", "h"]);
    files.iter().filter(is_c).flat_map(check_file).collect()
}

fn check_file(file: &TreeFile) -> Vec<Finding> {
    let mut findings = Vec::new();
    let mut inside = false;
    for (number, line) in file.lines() {
        let (code, comment) = line.split_once("/*").unwrap_or((line, ""));
        let opens = code.contains("struct") && code.trim_end().ends_with('{') && !code.contains('(');
        let in_one_line = code.contains("struct") && has_fields(code);
        if code.trim_start().starts_with('}') {
            inside = false;
        }
        let is_field = inside && is_number(code) || in_one_line;
        if is_field && (in_one_line || !has_unit(comment)) {
            let what = format!("no unit: {}", code.trim());
            let to_do =
                "begin its comment with a unit of UNITS in xtask/src/tidy/c_units.rs, one field a line";
            findings.push(Finding::new(&file.path, number, what, WHY, to_do));
        }
        inside |= opens;
    }
    findings
}

/// Whether braces on this line have declarations in them.
fn has_fields(code: &str) -> bool {
    let inner = code.split_once('{').map(|(_, rest)| rest.split_once('}').map_or(rest, |(inner, _)| inner));
    inner.is_some_and(|inner| inner.contains(';'))
}

/// Whether the line declares a number or an array of numbers; pointers and structs have no unit.
fn is_number(code: &str) -> bool {
    let mut words = code.split_whitespace().filter(|word| !matches!(*word, "volatile" | "const"));
    words.next().is_some_and(|word| TYPES.contains(&word))
        && !code.contains('*')
        && code.trim_end().ends_with(';')
}

fn has_unit(comment: &str) -> bool {
    let comment = comment.trim_start();
    UNITS.iter().any(|unit| {
        let rest = comment.strip_prefix(unit);
        rest.is_some_and(|rest| rest.starts_with([' ', ';', ':', ',']))
    })
}

#[cfg(test)]
mod tests {
    use super::super::sample::{file, places};
    use super::*;

    fn found(text: &str) -> Vec<String> {
        places(&check(&[file("firmware/core/a.h", text)]))
    }

    #[test]
    fn a_field_has_a_unit_beside_it() {
        let text = "struct wb_move {\n    volatile int32_t steps[3]; /* steps */\n    uint16_t rate; /* steps/s */\n    \
                    uint8_t end; /* enum wb_end */\n    void *board;\n    struct wb_line line;\n};\n";
        assert!(found(text).is_empty());
        assert!(
            places(&check(&[file("tests/firmware/shim/uno.c", "struct a {\n    int32_t b;\n};\n")]))
                .is_empty()
        );
    }

    #[test]
    fn a_number_without_one_is_found_on_its_line() {
        let text = "struct a {\n    int32_t far; /* how far */\n    bool on;\n    uint32_t stepsize; /* stepsize */\n};\n\
                    static uint8_t b;\n";
        assert_eq!(found(text), ["firmware/core/a.h:2", "firmware/core/a.h:3", "firmware/core/a.h:4"]);
    }

    #[test]
    fn fields_stand_on_lines_of_their_own() {
        assert_eq!(found("struct a { uint8_t b, c; /* us */ };\n"), ["firmware/core/a.h:1"]);
        assert_eq!(found("static struct { int32_t b; } C[2] = {1, 2};\n"), ["firmware/core/a.h:1"]);
        assert!(
            found("static struct a b = {.c = 1};\nstruct a f(struct a b) {\n    uint8_t c;\n}\n").is_empty()
        );
    }
}
