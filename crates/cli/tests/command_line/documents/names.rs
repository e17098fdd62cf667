//! Tables: the heading of the first column says what stands below it, and every name there exists. Where a table is a list of all there
//! is, nothing is missing in it either.

use std::collections::BTreeSet;

use serde_json::Value;

use crate::documents::known;
use crate::documents::markdown::{Document, Table, code_spans};
use crate::documents::{assert_none, documents, root};

/// Headings of first columns that hold no names. Those of `docs/physics.md` are checked by `crates/core/tests/physics`.
const PROSE: [&str; 9] = ["Design", "Figure", "Part", "Point", "Row", "Shield", "Step", "To", "Where"];

/// Words in the text that are written like keys: things in C and Rust.
const NO_KEYS: [&str; 5] = ["wirebend_driver_", "abi_major", "abi_minor", "_crc_ccitt_update", "check_wire"];
/// Ends of names of files.
const FILES: [&str; 2] = [".so", ".rs"];

/// What the names below a heading can be; `None` where the heading is not known.
fn below(heading: &str) -> Option<Names> {
    let schema = |path: &str| Names::Schema(known::json(path));
    let in_backticks = code_spans(heading).first().copied();
    if PROSE.contains(&heading) || heading == "θ" || heading.starts_with("![") {
        return Some(Names::Any);
    }
    let names = match (heading, in_backticks) {
        ("Key of a machine", _) => schema("machine-profiles/schema/machine.schema.json"),
        ("Key of a material", _) => schema("machine-profiles/schema/material.schema.json"),
        ("Key of a strut builder", _) => schema("machine-profiles/schema/strut-builder.schema.json"),
        ("Key of a noise profile", _) => schema("machine-profiles/schema/noise.schema.json"),
        ("Key of `.wirebend`", _) => schema("crates/files/schema/wirebend.schema.json"),
        ("Key of `.wbjob`", _) => schema("crates/files/schema/wbjob.schema.json"),
        (_, Some(command)) if heading.starts_with("Key of ") => {
            let name = command.strip_suffix(" --json")?.replace(' ', "-");
            schema(&format!("crates/api/schema/{name}.schema.json"))
        }
        (_, Some(driver)) if heading.starts_with("Setting of ") => Names::Schema(known::settings(driver)?),
        (_, Some(command)) if heading.starts_with("Option of ") => Names::Some(known::options(command)),
        ("Command", _) => Names::All(known::commands(&wirebend_cli::command(), "")),
        ("Machine", _) => Names::All(known::ids("machine-profiles/machines")),
        ("Material", _) => Names::All(known::ids("machine-profiles/materials")),
        ("Strut builder", _) => Names::All(known::ids("machine-profiles/strut-builders")),
        ("Noise profile", _) => Names::All(known::ids("machine-profiles/noise")),
        ("Driver", _) => Names::All(known::folders("drivers")),
        ("Format", _) => Names::All(known::formats()),
        ("`--from`", _) => Names::All(known::readers()),
        ("Check", _) => Names::All(known::checks()),
        ("Call", _) => Names::All(known::constants("crates/driver-api/schema/call.schema.json", "call")),
        ("Event", _) => Names::All(known::constants("crates/driver-api/schema/event.schema.json", "event")),
        ("Refusal", _) => Names::InSources(&["drivers", "crates/driver-api/src", "crates/driver-host/src"]),
        ("Exit status", _) => Names::InHelp,
        _ => return None,
    };
    Some(names)
}

enum Names {
    Any,
    /// Each has to be one of these.
    Some(BTreeSet<String>),
    /// And none of these may be missing.
    All(BTreeSet<String>),
    /// Keys of a JSON Schema, those inside of others after a dot.
    Schema(Value),
    /// Strings in the Rust sources below these folders.
    InSources(&'static [&'static str]),
    /// Words at the end of the program's help.
    InHelp,
}

impl Names {
    fn has(&self, name: &str) -> bool {
        match self {
            Self::Any => true,
            Self::Some(names) | Self::All(names) => names.contains(name),
            Self::Schema(schema) => known::has_key(schema, schema, name),
            Self::InSources(folders) => {
                let quoted = format!("\"{name}\"");
                folders.iter().any(|folder| {
                    known::sources(&root().join(folder)).iter().any(|text| text.contains(&quoted))
                })
            }
            Self::InHelp => {
                let help = wirebend_cli::command().render_long_help().to_string();
                let statuses = help.split("Exit status:").nth(1).unwrap_or_default();
                statuses.split_whitespace().any(|word| word == name)
            }
        }
    }
}

/// The names of a row: what is in backticks in its first cell, or the cell.
fn named(row: &[String]) -> Vec<String> {
    let first = row.first().map(String::as_str).unwrap_or_default();
    if first.contains('`') {
        code_spans(first).into_iter().map(str::to_owned).collect()
    } else {
        vec![first.to_owned()]
    }
}

fn check(document: &Document, table: &Table, wrong: &mut Vec<String>) {
    let heading = table.heading.first().cloned().unwrap_or_default();
    let line = table.rows.first().map_or(0, |(line, _)| *line);
    let Some(known) = below(&heading) else {
        wrong
            .push(format!("{}: nothing checks a table whose first column is '{heading}'", document.at(line)));
        return;
    };
    let mut seen = BTreeSet::new();
    for (line, row) in &table.rows {
        for name in named(row) {
            if !known.has(&name) {
                wrong.push(format!("{}: {heading}: there is no {name}", document.at(*line)));
            }
            if let (Names::Schema(schema), Some("default")) =
                (&known, table.heading.get(1).map(String::as_str))
            {
                check_default(schema, &name, &row[1], &document.at(*line), wrong);
            }
            seen.insert(name);
        }
    }
    if let Names::All(all) = &known {
        let missing: Vec<&String> = all.iter().filter(|name| !seen.contains(*name)).collect();
        if !missing.is_empty() {
            wrong.push(format!("{}: {heading}: {missing:?} are missing", document.at(line)));
        }
    }
}

/// The default of a setting as a table shows it.
fn check_default(schema: &Value, name: &str, shown: &str, at: &str, wrong: &mut Vec<String>) {
    let default = &schema["properties"][name]["default"];
    let same = match shown.parse::<f64>() {
        Ok(number) => default.as_f64().is_some_and(|default| (default - number).abs() < 1e-9),
        Err(_) => default.to_string().trim_matches('"') == shown,
    };
    if !same {
        wrong.push(format!("{at}: the default of {name} is {default}, not {shown}"));
    }
}

#[test]
fn every_name_in_a_table_exists() {
    let mut wrong = Vec::new();
    let mut tables = 0;
    for document in documents() {
        for table in document.tables() {
            tables += 1;
            check(&document, &table, &mut wrong);
        }
    }
    assert_none(&wrong);
    assert!(tables > 20, "the tables were not found");
}

/// Options and keys in running text: `--force`, `limits.min_edge_mm`.
#[test]
fn every_option_and_key_in_the_text_exists() {
    let options = known::all_options();
    let keys: BTreeSet<String> = known::all_keys().into_iter().chain(known::checks()).collect();
    let is_key = |span: &str| {
        span.contains('_')
            && span.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || "_.".contains(c))
    };
    let mut wrong = Vec::new();
    let mut compared = 0;
    for document in documents() {
        for (line, text) in document.prose() {
            for span in code_spans(text) {
                let option = span.split([' ', '=']).next().unwrap_or(span);
                let missing = if option.starts_with("--") {
                    !options.contains(option)
                } else if is_key(span)
                    && !NO_KEYS.contains(&span)
                    && !FILES.iter().any(|end| span.ends_with(end))
                {
                    !span.split('.').all(|key| keys.contains(key))
                } else {
                    continue;
                };
                compared += 1;
                if missing {
                    wrong.push(format!("{}: there is no {span}", document.at(line)));
                }
            }
        }
    }
    assert_none(&wrong);
    assert!(compared > 100, "options and keys were not found");
}
