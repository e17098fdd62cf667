//! The command line: arguments become a [`wirebend_app::Request`], the response becomes text or JSON.
//!
//! What a person reads goes to the error stream, what another program reads to the standard output.

mod args;
mod errors;
mod number;
mod progress;
mod render;
mod requests;
mod stop;
mod terminal;

use std::io::{IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{CommandFactory, FromArgMatches};
use wirebend_app::{AppError, LiveProblem, Places, Request};

pub use args::Cli;
pub use errors::{error_schema, exit};
use terminal::Terminal;

/// The arguments, for documentation: completions, manual page, reference.
#[must_use]
pub fn command() -> clap::Command {
    Cli::command()
}

/// Runs the program with the arguments of the process.
#[must_use]
pub fn main() -> ExitCode {
    // The process of a driver is this program too, and knows of nothing else.
    let mut words = std::env::args_os().skip(1);
    if words.next().is_some_and(|word| word == wirebend_app::CHILD_COMMAND) {
        return wirebend_app::child_main(&words.collect::<Vec<_>>());
    }
    let cli = match command().try_get_matches().and_then(|matches| Cli::from_arg_matches(&matches)) {
        Ok(cli) => cli,
        Err(error) => {
            // Help and version are asked for; the rest is a wrong use.
            let code = if error.use_stderr() { exit::USAGE } else { exit::DONE };
            return if error.print().is_ok() { ExitCode::from(code) } else { ExitCode::from(exit::FAILURE) };
        }
    };
    listen(cli.verbose);
    let json = cli.json;
    match run(cli) {
        Ok(code) => ExitCode::from(code),
        Err(error) => errors::report(&error, json),
    }
}

/// Sends what the program tells about its work to the error stream.
fn listen(verbose: u8) {
    let level = match verbose {
        0 => tracing::Level::WARN,
        1 => tracing::Level::INFO,
        2 => tracing::Level::DEBUG,
        _ => tracing::Level::TRACE,
    };
    // A second call, as in a test, finds the first one's listener in place.
    let _ = tracing_subscriber::fmt()
        .with_max_level(level)
        .with_writer(std::io::stderr)
        .with_ansi(std::io::stderr().is_terminal())
        .without_time()
        .with_target(false)
        .try_init();
}

fn run(cli: Cli) -> anyhow::Result<u8> {
    let Cli { command, json, profiles, driver_path, runs_folder, .. } = cli;
    let (request, output) = match requests::prepare(command)? {
        requests::Prepared::Request(request, output) => (*request, output),
        requests::Prepared::Text(text) => {
            std::io::stdout().write_all(&text)?;
            return Ok(exit::DONE);
        }
    };
    let options = said_again(&profiles, &driver_path, runs_folder.as_deref());
    let own = Places::of_person();
    let runs = runs_folder.or_else(|| own.runs.clone());
    let app = Places { profiles, drivers: driver_path, runs, ..own }.app()?.with_options(options);
    for refused in app.refused_profiles() {
        tracing::warn!("{refused}");
    }
    if is_live(&request) {
        stop::listen()?;
    }
    let terminal = Terminal::new(json);
    let response = app.run(&request, &terminal);
    terminal.finish();
    let response = match response {
        // Ctrl-C is no answer.
        Err(AppError::Live(LiveProblem::InDoubt { .. })) if stop::was_pressed() => {
            return Err(AppError::from(LiveProblem::Declined).into());
        }
        response => response?,
    };
    render::show(&response, json, output)
}

/// The options of this command without which the next one would look elsewhere.
fn said_again(profiles: &[PathBuf], drivers: &[PathBuf], runs: Option<&Path>) -> Vec<String> {
    let profiles = profiles.iter().map(|path| ("--profiles", path.as_path()));
    let drivers = drivers.iter().map(|path| ("--driver-path", path.as_path()));
    let all = profiles.chain(drivers).chain(runs.map(|path| ("--runs-folder", path)));
    all.flat_map(|(option, path)| [option.to_owned(), path.display().to_string()]).collect()
}

/// What may move a machine, so that a stop has to be at hand.
const fn is_live(request: &Request) -> bool {
    matches!(request, Request::Run(_) | Request::Jog(_) | Request::Replay(_) | Request::MachineSettings(_))
}
