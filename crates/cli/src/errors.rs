//! How a failure is told, and the exit status that goes with it.

use std::io::Write;
use std::process::ExitCode;

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_app::{AppError, ErrorKind, PlanReport};

use crate::render;

/// Exit statuses.
pub mod exit {
    /// Done.
    pub const DONE: u8 = 0;
    /// Wrong use.
    pub const USAGE: u8 = 2;
    /// Bad input.
    pub const BAD_INPUT: u8 = 3;
    /// Not feasible on this machine.
    pub const NOT_FEASIBLE: u8 = 4;
    /// Machine, driver or computer failure.
    pub const FAILURE: u8 = 5;
    /// A machine was stopped, or its driver was lost, and the machine has not confirmed that it stands.
    pub const MAY_MOVE: u8 = 6;
    /// Stopped by the person.
    pub const STOPPED: u8 = 130;
}

/// The JSON Schema of what `--json` prints instead of a result.
#[must_use]
pub fn error_schema() -> serde_json::Value {
    schemars::generate::SchemaSettings::draft2020_12()
        .for_serialize()
        .into_generator()
        .into_root_schema_for::<ErrorReport>()
        .to_value()
}

/// The command was given in a way that cannot be followed, as only the command line can tell.
#[derive(Debug)]
pub(crate) struct WrongUse(pub String);

impl std::fmt::Display for WrongUse {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for WrongUse {}

/// The command line itself was given an input that it cannot pass on.
#[derive(Debug)]
pub(crate) struct BadInput(pub String);

impl std::fmt::Display for BadInput {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for BadInput {}

/// What `--json` prints instead of a result.
#[derive(Debug, Serialize, JsonSchema)]
struct ErrorReport<'a> {
    /// What went wrong.
    error: ErrorBody<'a>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct ErrorBody<'a> {
    /// A name that stays the same while the wording may change.
    code: &'static str,
    /// What went wrong and what to do.
    message: String,
    /// What the checks say, where that is the reason.
    #[serde(skip_serializing_if = "Option::is_none")]
    report: Option<&'a PlanReport>,
}

/// Tells a failure and gives its exit status.
pub(crate) fn report(error: &anyhow::Error, json: bool) -> ExitCode {
    if is_broken_pipe(error) {
        // The reader has what it wanted, as `head` does.
        return ExitCode::from(exit::DONE);
    }
    let known = error.downcast_ref::<AppError>();
    let code = match known.map(AppError::kind) {
        Some(ErrorKind::Usage) => exit::USAGE,
        Some(ErrorKind::BadInput) => exit::BAD_INPUT,
        Some(ErrorKind::NotFeasible) => exit::NOT_FEASIBLE,
        None if error.is::<WrongUse>() => exit::USAGE,
        None if error.is::<BadInput>() => exit::BAD_INPUT,
        Some(ErrorKind::Stopped) => exit::STOPPED,
        Some(ErrorKind::MayMove) => exit::MAY_MOVE,
        Some(ErrorKind::Failure) | None => exit::FAILURE,
    };
    let report = known.and_then(AppError::report);
    if json {
        let message = format!("{error:#}");
        let body = ErrorBody { code: known.map_or("failure", AppError::code), message, report };
        if let Ok(text) = serde_json::to_string_pretty(&ErrorReport { error: body }) {
            let _ = writeln!(std::io::stdout(), "{text}");
        }
    } else {
        if let Some(report) = report {
            let _ = render::plan::diagnostics(&mut anstream::stderr().lock(), report);
        }
        let style = render::severity_style(wirebend_app::SeverityName::Error);
        let _ = writeln!(anstream::stderr(), "{style}error{style:#}: {error:#}");
    }
    ExitCode::from(code)
}

fn is_broken_pipe(error: &anyhow::Error) -> bool {
    let io = error.downcast_ref::<std::io::Error>();
    io.is_some_and(|io| io.kind() == std::io::ErrorKind::BrokenPipe)
}
