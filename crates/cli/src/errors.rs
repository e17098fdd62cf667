//! How a failure is reported, and the exit status that goes with it.

use std::io::Write;
use std::process::ExitCode;

use clap::error::ErrorKind;
use schemars::JsonSchema;
use serde::Serialize;
use wirebend_api::{ApiError, ErrorCode, ErrorKind as ApiErrorKind, ErrorRemedy, PlanReport};

use crate::usage::{BadInput, WrongUse};
use crate::{exit, render};

/// The JSON Schema of what `--json` prints instead of a result.
#[must_use]
pub fn error_schema() -> serde_json::Value {
    schemars::generate::SchemaSettings::draft2020_12()
        .for_serialize()
        .into_generator()
        .into_root_schema_for::<ErrorReport>()
        .to_value()
}

/// What `--json` prints instead of a result.
#[derive(Debug, Serialize, JsonSchema)]
struct ErrorReport<'a> {
    /// What went wrong.
    error: &'a ErrorBody<'a>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct ErrorBody<'a> {
    /// A name that stays the same while the wording may change.
    code: ErrorCode,
    message: String,
    /// What can be done about it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    remedies: Vec<ErrorRemedy>,
    /// The same in words, with options and commands; how the command is used, where it was not understood.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    help: Vec<String>,
    /// What the checks say, where that is the reason.
    #[serde(skip_serializing_if = "Option::is_none")]
    report: Option<&'a PlanReport>,
}

/// Reports arguments that cannot be understood. Help and version, which are asked for, are no failure.
pub(crate) fn arguments(error: &clap::Error, json: bool) -> ExitCode {
    let code = if error.use_stderr() { exit::USAGE } else { exit::DONE };
    if !json || code == exit::DONE {
        let is_lost = error.print().is_err_and(|error| error.kind() != std::io::ErrorKind::BrokenPipe);
        return ExitCode::from(if is_lost { exit::FAILURE } else { code });
    }
    let text = error.render().to_string();
    let (message, help) = if error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        // What is printed then is the help.
        let usage = text.lines().find(|line| line.starts_with("Usage:"));
        ("a command is missing".to_owned(), usage.map(str::to_owned).into_iter().collect())
    } else {
        let (first, rest) = text.split_once("\n\n").unwrap_or((&text, ""));
        let lines = rest.lines().map(str::trim).filter(|line| !line.is_empty());
        // The line that names --help is for a terminal.
        let lines = lines.filter(|line| !line.starts_with("For more information"));
        let help = lines.map(|line| line.strip_prefix("tip: ").unwrap_or(line).to_owned()).collect();
        (first.strip_prefix("error: ").unwrap_or(first).trim_end().to_owned(), help)
    };
    print(&ErrorBody { code: ErrorCode::Usage, message, remedies: Vec::new(), help, report: None });
    ExitCode::from(code)
}

fn print(body: &ErrorBody) {
    if let Ok(text) = serde_json::to_string_pretty(&ErrorReport { error: body }) {
        let _ = writeln!(std::io::stdout(), "{text}");
    }
}

/// Reports a failure and gives its exit status.
pub(crate) fn report(error: &anyhow::Error, json: bool) -> ExitCode {
    if is_broken_pipe(error) {
        // The reader has what it wanted, as `head` does.
        return ExitCode::from(exit::DONE);
    }
    let known = error.downcast_ref::<ApiError>();
    let code = match known.map(ApiError::kind) {
        Some(ApiErrorKind::Usage) => exit::USAGE,
        Some(ApiErrorKind::BadInput) => exit::BAD_INPUT,
        Some(ApiErrorKind::NotFeasible) => exit::NOT_FEASIBLE,
        None if error.is::<WrongUse>() => exit::USAGE,
        None if error.is::<BadInput>() => exit::BAD_INPUT,
        Some(ApiErrorKind::Stopped) => exit::STOPPED,
        Some(ApiErrorKind::MayMove) => exit::MAY_MOVE,
        Some(ApiErrorKind::Failure) | None => exit::FAILURE,
    };
    let report = known.and_then(ApiError::report);
    let remedies = known.map(ApiError::remedies).unwrap_or_default();
    if json {
        let message = format!("{error:#}");
        let other = if error.is::<WrongUse>() { ErrorCode::Usage } else { ErrorCode::Failure };
        let code = known.map_or(other, ApiError::code);
        let help = render::advice::of(&remedies);
        print(&ErrorBody { code, message, remedies, help, report });
    } else {
        if let Some(report) = report {
            let _ = render::plan::diagnostics(&mut anstream::stderr().lock(), report);
        }
        let style = render::severity_style(wirebend_api::SeverityName::Error);
        let _ = writeln!(anstream::stderr(), "{style}error{style:#}: {error:#}");
        let _ = render::advice::write(&mut anstream::stderr().lock(), &remedies);
    }
    ExitCode::from(code)
}

fn is_broken_pipe(error: &anyhow::Error) -> bool {
    let io = error.downcast_ref::<std::io::Error>();
    io.is_some_and(|io| io.kind() == std::io::ErrorKind::BrokenPipe)
}
