//! Rule: what was copied from others is listed with its source, is there, and has its licence beside it.
//!
//! A `SOURCES.md` holds a table whose first column is `file`: names relative to its folder, in backticks.

use super::finding::Finding;
use super::tree::TreeFile;

const NAME: &str = "SOURCES.md";

/// Rows whose file is missing, that name no source or licence, or whose licence text is not beside the file.
pub(super) fn check(files: &[TreeFile]) -> Vec<Finding> {
    let is_table = |file: &&TreeFile| file.path == NAME || file.path.ends_with(&format!("/{NAME}"));
    files.iter().filter(is_table).flat_map(|table| check_table(table, files)).collect()
}

fn check_table(table: &TreeFile, files: &[TreeFile]) -> Vec<Finding> {
    let folder = table.path.strip_suffix(NAME).unwrap_or_default();
    let mut findings = Vec::new();
    let mut header: Vec<String> = Vec::new();
    for (line, text) in table.lines() {
        let Some(cells) = row(text) else {
            header.clear();
            continue;
        };
        if header.is_empty() {
            header = cells.iter().map(|cell| cell.to_lowercase()).collect();
            continue;
        }
        let is_rule = cells.iter().all(|cell| cell.chars().all(|c| matches!(c, '-' | ':')));
        if is_rule || header.first().is_none_or(|name| name != "file") {
            continue;
        }
        let mut report = |what: String, to_do: &str| {
            let why = "other people's work needs its source and its licence";
            findings.push(Finding::new(&table.path, line, what, why, to_do));
        };
        for name in ["source", "licence"] {
            let column = header.iter().position(|cell| cell.starts_with(name));
            if column.and_then(|column| cells.get(column)).is_none_or(|cell| cell.is_empty()) {
                report(format!("no {name} for {}", cells[0]), "fill in the cell");
            }
        }
        for copied in names(cells[0]) {
            let path = format!("{folder}{copied}");
            if !files.iter().any(|file| file.path == path) {
                report(format!("{path} does not exist"), "correct the name or remove the row");
            } else if !has_licence_beside(&path, files) {
                report(format!("no LICENSE file beside {path}"), "copy the licence text into its folder");
            }
        }
    }
    findings
}

/// The cells of a line of a Markdown table.
fn row(line: &str) -> Option<Vec<&str>> {
    let inner = line.trim().strip_prefix('|')?.strip_suffix('|')?;
    Some(inner.split('|').map(str::trim).collect())
}

/// The names in backticks in a cell, or the cell itself when there are none.
fn names(cell: &str) -> Vec<&str> {
    if cell.contains('`') { cell.split('`').skip(1).step_by(2).collect() } else { vec![cell] }
}

fn has_licence_beside(path: &str, files: &[TreeFile]) -> bool {
    let folder = path.rfind('/').map_or("", |end| &path[..=end]);
    files.iter().any(|file| {
        file.path.strip_prefix(folder).is_some_and(|name| name.starts_with("LICENSE") && !name.contains('/'))
    })
}

#[cfg(test)]
mod tests {
    use super::super::sample::{file, places};
    use super::*;

    const HEAD: &str = "# Sources\n\n| file | what | source | licence |\n| --- | --- | --- | --- |\n";

    fn found(rows: &str, others: &[&str]) -> Vec<Finding> {
        let mut files = vec![file("examples/SOURCES.md", &format!("{HEAD}{rows}"))];
        files.extend(others.iter().map(|path| file(path, "")));
        check(&files)
    }

    #[test]
    fn a_file_with_its_licence_is_fine() {
        let row = "| `a.obj`, `b.obj` | two | someone: x, 1 | MIT |\n";
        assert!(found(row, &["examples/a.obj", "examples/b.obj", "examples/LICENSE.someone"]).is_empty());
    }

    #[test]
    fn a_missing_file_is_found_on_its_row() {
        let row = "| a.obj | one | someone: x, 1 | MIT |\n| `gone.obj` | two | someone: x, 1 | MIT |\n";
        let found = found(row, &["examples/a.obj", "examples/LICENSE"]);
        assert_eq!(places(&found), ["examples/SOURCES.md:6"]);
    }

    #[test]
    fn a_missing_licence_text_or_an_empty_cell_is_found() {
        let row = "| `a.obj` | one |  | MIT |\n";
        let found = found(row, &["examples/a.obj", "LICENSE-MIT"]);
        let whats: Vec<&str> = found.iter().map(|finding| finding.what.as_str()).collect();
        assert_eq!(whats, ["no source for `a.obj`", "no LICENSE file beside examples/a.obj"]);
    }
}
