//! Rule: a file of the firmware's core includes only files of rows above its own in the table of `firmware/README.md`.

use super::finding::Finding;
use super::tree::TreeFile;

const MANUAL: &str = "firmware/README.md";
const HEADING: &str = "## Files of the core";
const CORE: &str = "firmware/core/";
/// What a board may include of the core.
const FOR_BOARDS: &[&str] = &["entry", "hal"];
const BOARDS: &[&str] = &["firmware/hal_avr/", "firmware/hal_host/"];

const WHY: &str = "without circles a file can be read, tested and changed with those above it alone";

/// A file of the core in the manual's table, without its extension.
struct Row<'a> {
    name: &'a str,
    rank: usize,
    line: usize,
}

/// Includes against the order, files without a place in it, and places without a file.
pub(super) fn check(files: &[TreeFile]) -> Vec<Finding> {
    let rows = files.iter().find(|file| file.path == MANUAL).map(rows).unwrap_or_default();
    let mut findings = Vec::new();
    for row in &rows {
        let is_it = |file: &TreeFile| in_core(file).is_some_and(|(name, _)| name == row.name);
        if !files.iter().any(is_it) {
            let what = format!("{CORE}{} does not exist", row.name);
            findings.push(Finding::new(MANUAL, row.line, what, WHY, "remove it from the table"));
        }
    }
    for file in files {
        if let Some((name, _)) = in_core(file) {
            findings.extend(in_order(file, name, &rows));
        } else if BOARDS.iter().any(|board| file.path.starts_with(board)) {
            findings.extend(board(file));
        }
    }
    findings
}

/// Name and extension of a file of the core.
fn in_core(file: &TreeFile) -> Option<(&str, &str)> {
    let (name, extension) = file.path.strip_prefix(CORE)?.split_once('.')?;
    matches!(extension, "c" | "h").then_some((name, extension))
}

/// The table below the heading: names in backquotes in the first cell of each row.
fn rows(manual: &TreeFile) -> Vec<Row<'_>> {
    let lines = manual.lines().skip_while(|(_, line)| *line != HEADING).skip(1);
    let table =
        lines.take_while(|(_, line)| !line.starts_with('#')).filter(|(_, line)| line.starts_with('|'));
    let mut rows = Vec::new();
    for (rank, (line, text)) in table.enumerate() {
        let cell = text.trim_start_matches('|').split('|').next().unwrap_or_default();
        let names = cell.split('`').skip(1).step_by(2);
        rows.extend(names.map(|name| Row { name, rank, line }));
    }
    rows
}

fn in_order(file: &TreeFile, name: &str, rows: &[Row<'_>]) -> Vec<Finding> {
    let rank_of = |name: &str| rows.iter().find(|row| row.name == name).map(|row| row.rank);
    let Some(own) = rank_of(name) else {
        let what = format!("{name} is not in the table below '{HEADING}' of {MANUAL}");
        return vec![Finding::new(&file.path, 1, what, WHY, "give it a row below all that it includes")];
    };
    let mut findings = Vec::new();
    for (line, header) in includes(file) {
        let known = header.strip_suffix(".h").unwrap_or(header);
        if known != name && rank_of(known).is_none_or(|rank| rank >= own) {
            let what = format!("{name} includes {header}, which is not above it in {MANUAL}");
            let to_do = "hand over what it needs as an argument, or move the code that needs it down";
            findings.push(Finding::new(&file.path, line, what, WHY, to_do));
        }
    }
    findings
}

/// A board calls the core by `entry.h` and is called by `hal.h`.
fn board(file: &TreeFile) -> Vec<Finding> {
    let of_core = |&(_, header): &(usize, &str)| header.contains("core/");
    let others = includes(file).filter(of_core).filter(|(_, header)| {
        let name = header.rsplit('/').next().and_then(|name| name.strip_suffix(".h"));
        !name.is_some_and(|name| FOR_BOARDS.contains(&name))
    });
    let finding = |(line, header)| {
        let why = "a board that knows no more of the core can be exchanged for another";
        Finding::new(&file.path, line, format!("a board includes {header}"), why, "use entry.h and hal.h")
    };
    others.map(finding).collect()
}

/// Headers in quotes, with their lines; those in angle brackets are the compiler's.
fn includes(file: &TreeFile) -> impl Iterator<Item = (usize, &str)> {
    file.lines().filter_map(|(line, text)| {
        let header = text.trim_start().strip_prefix("#include")?.trim_start().strip_prefix('"')?;
        Some((line, header.split('"').next()?))
    })
}

#[cfg(test)]
mod tests {
    use super::super::sample::{file, places};
    use super::*;

    const TABLE: &str = "# Firmware\n\n| `not this` | |\n\n## Files of the core\n\n| files | for |\n|---|---|\n\
                         | `crc` `hal` | |\n| `queue` | |\n| `entry` | |\n\n## Next\n\n| `nor this` | |\n";

    fn found(path: &str, text: &str) -> Vec<String> {
        let mut files = vec![file(MANUAL, TABLE)];
        files.extend(
            ["crc", "hal", "queue", "entry"].map(|name| file(&format!("firmware/core/{name}.h"), "")),
        );
        files.push(file(path, text));
        places(&check(&files))
    }

    #[test]
    fn files_above_and_the_own_header_may_be_included() {
        let text = "#include \"queue.h\"\n#include <stdint.h>\n#include \"hal.h\"\n";
        assert!(found("firmware/core/queue.c", text).is_empty());
    }

    #[test]
    fn files_of_the_same_row_or_below_may_not() {
        let text = "#include \"crc.h\"\n#include \"hal.h\"\n\n#include \"entry.h\"\n";
        assert_eq!(found("firmware/core/crc.c", text), ["firmware/core/crc.c:2", "firmware/core/crc.c:4"]);
        assert_eq!(
            found("firmware/core/queue.c", "#include \"../hal_avr/pin.h\"\n"),
            ["firmware/core/queue.c:1"]
        );
    }

    #[test]
    fn table_and_folder_have_the_same_files() {
        assert_eq!(found("firmware/core/new.c", "\n"), ["firmware/core/new.c:1"]);
        assert_eq!(
            places(&check(&[file(MANUAL, "## Files of the core\n| `crc` | |\n")])),
            ["firmware/README.md:2"]
        );
        assert_eq!(places(&check(&[file("firmware/core/crc.c", "")])), ["firmware/core/crc.c:1"]);
    }

    #[test]
    fn a_board_knows_the_two_headers_for_boards() {
        assert!(found("firmware/hal_avr/board.h", "#include \"../core/entry.h\"\n").is_empty());
        assert_eq!(
            found("firmware/hal_host/host.c", "#include \"host.h\"\n#include \"../core/queue.h\"\n"),
            ["firmware/hal_host/host.c:2"]
        );
    }
}
