//! The command line: arguments become a [`wirebend_api::Command`], the response becomes text or JSON.
//!
//! What a person reads goes to the error stream, what another program reads to the standard output.

mod again;
mod args;
mod contents;
mod errors;
pub mod exit;
mod keyboard;
mod number;
mod progress;
mod render;
mod requests;
mod stop;
mod terminal;
mod usage;

use std::io::{IsTerminal, Write};
use std::process::ExitCode;

use clap::{CommandFactory, FromArgMatches};
use wirebend_api::{ApiError, Command, LiveProblem, OperationError, Places, Response};

pub use args::Cli;
pub use errors::error_schema;
use terminal::Terminal;

/// The arguments, for documentation: completions, manual page, reference.
#[must_use]
pub fn command() -> clap::Command {
    with_numbers_below_zero(Cli::command())
}

/// A number below zero behind an option is its value, and what is wrong with it is said of the number.
fn with_numbers_below_zero(command: clap::Command) -> clap::Command {
    let takes = |argument: clap::Arg| {
        let takes_values = argument.get_action().takes_values() && !argument.is_positional();
        if takes_values { argument.allow_negative_numbers(true) } else { argument }
    };
    command.mut_args(takes).mut_subcommands(with_numbers_below_zero)
}

/// Runs the program with the arguments of the process.
#[must_use]
pub fn main() -> ExitCode {
    // The process of a driver is this program too, and knows of nothing else.
    let mut words = std::env::args_os().skip(1);
    if words.next().is_some_and(|word| word == wirebend_api::CHILD_COMMAND) {
        return wirebend_api::child_main(&words.collect::<Vec<_>>());
    }
    let cli = match command().try_get_matches().and_then(|matches| Cli::from_arg_matches(&matches)) {
        Ok(cli) => cli,
        Err(error) => {
            let mut words = std::env::args_os().take_while(|word| word != "--");
            return errors::arguments(&error, words.any(|word| word == "--json"));
        }
    };
    listen(cli.verbose);
    let json = cli.json;
    match run(cli) {
        Ok(code) => ExitCode::from(code),
        Err(error) => errors::report(&error, json),
    }
}

/// Sends what the program logs about its work to the error stream.
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
    let (command, output) = match requests::prepare(command)? {
        requests::Prepared::Command(command, output) => (*command, output),
        requests::Prepared::Text(text) => {
            std::io::stdout().write_all(&text)?;
            return Ok(exit::DONE);
        }
    };
    again::keep(&profiles, &driver_path, runs_folder.as_deref());
    let own = Places::of_person();
    let runs = runs_folder.or_else(|| own.runs.clone());
    let installation = Places { profiles, drivers: driver_path, runs, ..own }.installation()?;
    for refused in installation.refused_profiles() {
        let advice = render::advice::of(&refused.remedies()).join("\n  help: ");
        tracing::warn!("{refused}\n  help: {advice}");
    }
    if is_live(&command) {
        stop::listen()?;
    } else if may_search(&command) {
        stop::listen_while_searching()?;
    }
    let terminal = Terminal::new(json);
    let response = command.run(&installation, &terminal);
    terminal.finish();
    let mut response = match response {
        // Ctrl-C is no answer.
        Err(ApiError::Operation(OperationError::Live(LiveProblem::InDoubt { .. })))
            if stop::was_pressed() =>
        {
            return Err(ApiError::from(LiveProblem::Declined).into());
        }
        response => response?,
    };
    if let Response::Run(found) = &mut response {
        found.wires.iter_mut().for_each(|wire| wire.resume = wire.resumable.as_ref().map(again::resume));
    }
    render::show(&response, json, output)
}

/// What may move a machine, so that a stop has to be at hand.
const fn is_live(command: &Command) -> bool {
    matches!(
        command,
        Command::Run(_)
            | Command::Jog(_)
            | Command::Replay(_)
            | Command::DryRun(_)
            | Command::MachineSettings(_)
            | Command::Console(_)
    )
}

/// What may search, which Ctrl-C ends with the best so far.
const fn may_search(command: &Command) -> bool {
    let choices = match command {
        Command::Check(request) => &request.choices,
        Command::Plan(request) => &request.choices,
        Command::Export(request) => &request.choices,
        Command::Dump(request) => &request.choices,
        Command::Compare(request) => &request.choices,
        Command::Wires(request) => &request.choices,
        _ => return false,
    };
    choices.avoid_collisions
}
