//! The files of a case: what each stage makes of it, rounded so that they are the same everywhere.

use std::fmt::Write;

use serde_json::Value;
use wirebend_api::{ApiError, Command, DriverProblem, DumpRequest, PlanningError, Response, StageName};

use crate::cases::{Case, run};

const KIT: &str = "wirebend-kit";
const PENSA: &str = "pensa-diwire-pro";

/// Name and contents of every file. A stage that the design does not reach has none; the checks say why.
pub fn files(case: &Case) -> Vec<(String, String)> {
    let mut files = Vec::new();
    for stage in [
        StageName::Wireframe,
        StageName::Route,
        StageName::Program,
        StageName::Schedule,
        StageName::Compensated,
    ] {
        let request = DumpRequest { stage, design: case.input(), choices: case.choices(KIT) };
        match run(&Command::Dump(request)) {
            Ok(Response::Dump(found)) => {
                files.push((format!("{}.json", stage.as_str()), lines(&found.value)));
            }
            Err(ApiError::Planning(PlanningError::StageNotReached { .. })) => {}
            other => panic!("{}: {other:?}", case.about),
        }
    }
    for (name, machine) in [("checks-wirebend-kit", KIT), ("checks-pensa", PENSA)] {
        files.push((format!("{name}.txt"), checks(case, machine)));
    }
    for (name, machine, format) in [
        ("wirebend-kit.txt", KIT, "wirebend-kit-text"),
        ("pensa.txt", PENSA, "pensa-script"),
        ("lra.csv", KIT, "lra-csv"),
    ] {
        match case.export(machine, format) {
            Ok(texts) => files.push((name.to_owned(), texts.join("\n"))),
            Err(ApiError::Planning(
                PlanningError::StageNotReached { .. }
                | PlanningError::Driver(DriverProblem::Unwritten { .. }),
            )) => {}
            Err(error) => panic!("{}: {error}", case.about),
        }
    }
    files
}

fn checks(case: &Case, machine: &str) -> String {
    let plan = case.plan(machine);
    let of_wires = plan.wires().iter().flat_map(|wire| &wire.diagnostics);
    let lines: Vec<String> = plan
        .diagnostics()
        .iter()
        .chain(of_wires)
        .map(|d| format!("{:?} {} {}", d.severity, d.code, d.message).to_lowercase())
        .collect();
    format!("feasible: {}\n{}\n", plan.feasible(), lines.join("\n"))
}

/// JSON with numbers rounded to a millionth and one innermost list or object a line.
fn lines(value: &Value) -> String {
    let mut text = String::new();
    put(value, 0, &mut text);
    text.push('\n');
    text
}

fn put(value: &Value, depth: usize, text: &mut String) {
    let nests = |value: &Value| value.is_array() || value.is_object();
    let (open, close, entries): (char, char, Vec<(Option<&str>, &Value)>) = match value {
        Value::Array(items) => ('[', ']', items.iter().map(|item| (None, item)).collect()),
        Value::Object(map) => ('{', '}', map.iter().map(|(key, item)| (Some(key.as_str()), item)).collect()),
        Value::Number(number) if number.is_f64() => {
            let rounded = (number.as_f64().unwrap() * 1e6).round() / 1e6 + 0.0;
            text.push_str(&rounded.to_string());
            return;
        }
        other => {
            text.push_str(&other.to_string());
            return;
        }
    };
    let broken = entries.iter().any(|(_, item)| nests(item));
    text.push(open);
    for (k, (key, item)) in entries.iter().enumerate() {
        text.push_str(if k > 0 { "," } else { "" });
        if broken {
            text.push('\n');
            text.push_str(&" ".repeat(2 * (depth + 1)));
        } else if k > 0 {
            text.push(' ');
        }
        if let Some(key) = key {
            write!(text, "\"{key}\": ").unwrap();
        }
        put(item, depth + 1, text);
    }
    if broken {
        text.push('\n');
        text.push_str(&" ".repeat(2 * depth));
    }
    text.push(close);
}
