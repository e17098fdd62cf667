//! Rule: a source file is short enough to be read in one go.

use super::finding::Finding;
use super::tree::TreeFile;

/// From here on a file is reported.
const LONG: usize = 400;
/// From here on it fails.
const TOO_LONG: usize = 600;

const WHY: &str = "a file that long does two things, and the folder listing shows only one of them";

/// Reports source files over 400 lines; over 600 lines they must be split.
pub(super) fn check(files: &[TreeFile]) -> Vec<Finding> {
    let is_source = |file: &&TreeFile| {
        file.has_extension(&["rs", "ts", "tsx", "c", "h"])
            && !file.is_fixture()
            && !file.path.contains("/generated/")
    };
    files.iter().filter(is_source).filter_map(check_file).collect()
}

fn check_file(file: &TreeFile) -> Option<Finding> {
    let lines = file.lines().count();
    let what = format!("{lines} lines");
    let finding =
        Finding::new(&file.path, lines, what, WHY, "look for the second thing it does and give it a file");
    if lines <= LONG {
        None
    } else if lines <= TOO_LONG {
        Some(finding.into_report())
    } else {
        Some(finding)
    }
}

#[cfg(test)]
mod tests {
    use super::super::sample::file;
    use super::*;

    fn verdict(path: &str, lines: usize) -> Option<bool> {
        check(&[file(path, &"x\n".repeat(lines))]).first().map(|finding| finding.only_report)
    }

    #[test]
    fn four_hundred_is_free_six_hundred_is_reported_more_fails() {
        assert_eq!(verdict("crates/core/src/a.rs", 400), None);
        assert_eq!(verdict("crates/core/src/a.rs", 401), Some(true));
        assert_eq!(verdict("ui/src/a.tsx", 600), Some(true));
        assert_eq!(verdict("firmware/core/a.c", 601), Some(false));
    }

    #[test]
    fn generated_types_and_data_are_free() {
        assert_eq!(verdict("ui/src/generated/types.ts", 900), None);
        assert_eq!(verdict("examples/bunny.obj", 900), None);
    }
}
