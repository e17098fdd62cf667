//! Rule: `unsafe` stands at the boundary to drivers and nowhere else.

use super::RULES;
use super::finding::Finding;
use super::rust_source::{code_only, line_at, words};
use super::tree::TreeFile;

const WHY: &str = "what the compiler does not check has to be read by a person, and so is kept in few places";

/// Where it may stand: the C table from both sides, the loading of a library, and tests of these; and the
/// simulator of the firmware's tests, which is a C library.
const PLACES: &[&str] = &[
    "crates/driver-api/src/glue.rs",
    "crates/driver-api/src/abi.rs",
    "crates/driver-api/src/table.rs",
    "crates/driver-api/src/conformance/subject.rs",
    "crates/driver-api/tests/",
    "crates/driver-host/src/library.rs",
    "drivers/hostile/src/",
    // A variable of the environment that the window's toolkit reads.
    "src-tauri/src/environment.rs",
    // The firmware's core, which is C.
    "drivers/wirebend-kit/src/controller/ffi.rs",
    "tests/firmware/src/ffi.rs",
];

/// Code that is unsafe, or allows itself to be, in other places.
pub(super) fn check(files: &[TreeFile]) -> Vec<Finding> {
    let elsewhere = |file: &&TreeFile| {
        let allowed = PLACES.iter().any(|place| file.path.starts_with(place));
        file.has_extension(&["rs"]) && !allowed && !file.path.starts_with(RULES) && !file.is_fixture()
    };
    files.iter().filter(elsewhere).flat_map(in_file).collect()
}

fn in_file(file: &TreeFile) -> Vec<Finding> {
    let code = code_only(file.text.as_deref().unwrap_or_default());
    let found = |word: &'static str| words(&code, word).map(|at| line_at(&code, at)).collect::<Vec<_>>();
    let mut lines = [found("unsafe"), found("unsafe_code")].concat();
    lines.sort_unstable();
    lines.dedup();
    let to_do =
        "find a safe way, or add the file to PLACES in xtask/src/tidy/unsafe_code.rs and say there why";
    lines.into_iter().map(|line| Finding::new(&file.path, line, "unsafe code", WHY, to_do)).collect()
}

#[cfg(test)]
mod tests {
    use super::super::sample::{file, places};
    use super::*;

    #[test]
    fn unsafe_code_is_found_on_its_line() {
        let source = "// unsafe in words\nfn a() {\n    unsafe { b() }\n}\n#![allow(unsafe_code)]\nlet not_unsafe = 1;\n";
        assert_eq!(
            places(&check(&[file("crates/api/src/a.rs", source)])),
            ["crates/api/src/a.rs:3", "crates/api/src/a.rs:5"]
        );
    }

    #[test]
    fn the_boundary_may_be_unsafe() {
        assert!(check(&[file("crates/driver-api/src/table.rs", "unsafe { x() }")]).is_empty());
    }
}
