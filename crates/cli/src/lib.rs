//! The command line: arguments become a [`wirebend_app::Request`], the response becomes text or JSON.
//!
//! What a person reads goes to the error stream, what another program reads to the standard output.

mod args;
mod errors;
mod progress;
mod render;
mod requests;
mod stop;
mod terminal;

use std::io::{IsTerminal, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{CommandFactory, FromArgMatches};
use etcetera::BaseStrategy;
use wirebend_app::{App, DriverFolders, Request};

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
    let app = App::new(&profile_folders(profiles))?
        .with_drivers(driver_folders(driver_path))
        .with_runs(runs_folder.or_else(own_runs));
    for refused in app.refused_profiles() {
        tracing::warn!("{refused}");
    }
    if is_live(&request) {
        stop::listen()?;
    }
    let terminal = Terminal::new(json);
    let response = app.run(&request, &terminal);
    terminal.finish();
    render::show(&response?, json, output)
}

/// What may move a machine, so that a stop has to be at hand.
const fn is_live(request: &Request) -> bool {
    matches!(request, Request::Run(_) | Request::Jog(_) | Request::Replay(_) | Request::MachineSettings(_))
}

/// Where journals and records are kept unless a folder is named; `None` without a home.
fn own_runs() -> Option<PathBuf> {
    etcetera::choose_base_strategy().ok().map(|home| home.data_dir().join("wirebend").join("runs"))
}

/// The folder of the person's own profiles, whether it is there or not; `None` without a home.
fn own_folder() -> Option<PathBuf> {
    etcetera::choose_base_strategy().ok().map(|home| home.config_dir().join("wirebend"))
}

/// The person's own drivers and the list of those that they trust, and what was named on the command line.
fn driver_folders(named: Vec<PathBuf>) -> DriverFolders {
    let own = own_folder();
    DriverFolders {
        user: own.as_ref().map(|folder| folder.join("drivers")).filter(|folder| folder.is_dir()),
        trusted: own.map(|folder| folder.join("trusted-drivers.json")),
        named,
        ..DriverFolders::default()
    }
}

/// The person's own profiles, and those named on the command line.
fn profile_folders(named: Vec<PathBuf>) -> Vec<PathBuf> {
    let own = own_folder().filter(|folder| folder.is_dir());
    own.into_iter().chain(named).collect()
}
