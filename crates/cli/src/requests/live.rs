//! The requests of what moves a machine, or asks it.

use std::path::{Path, PathBuf};

use wirebend_api::{
    Answers, Command, ConsoleRequest, DryRunRequest, JogRequest, MachineSettingsRequest, Output,
    PortsRequest, Repeat, ReplayRequest, RunHow, RunRequest, RunsExportRequest, RunsRequest, RunsShowRequest,
    SimulatedAs,
};

use super::{Prepared, input, place};
use crate::args::live::{
    Answer, ConsoleArgs, DryRunArgs, JogArgs, MachineSettingsArgs, PortArgs, PortsArgs, ReplayArgs, RunArgs,
    RunsCommand, ToRunArgs, ZeroArgs, moves,
};
use crate::contents::Contents;
use crate::usage::{BadInput, WrongUse};

pub(super) fn run(args: RunArgs) -> anyhow::Result<Command> {
    let RunArgs {
        what,
        wire,
        repeat,
        stock,
        cut,
        resume,
        abandon,
        accept_settings,
        simulated,
        record,
        force,
    } = args;
    let ToRunArgs { job, machine, material, despite_errors, at, zero } = what;
    let answers = answers(&at, &zero);
    let wire = wire.map(|wire| wire.get() - 1);
    let how = match resume {
        Some(Answer(decided)) => RunHow::Resume { decided },
        None if abandon => RunHow::Abandon,
        None => RunHow::Begin,
    };
    Ok(Command::Run(RunRequest {
        job: input(&job)?,
        machine,
        material,
        despite_errors,
        port: at.port,
        wire,
        repeat: Repeat { pieces: repeat, stock_mm: stock, cut },
        how,
        simulated_as: SimulatedAs {
            machine: simulated.simulated_machine,
            material: simulated.simulated_material,
        },
        answers,
        accept_settings,
        record: record_file(record, force)?,
    }))
}

pub(super) fn dry_run(args: DryRunArgs) -> anyhow::Result<Command> {
    let DryRunArgs { what, wire, accept_settings } = args;
    let ToRunArgs { job, machine, material, despite_errors, at, zero } = what;
    let answers = answers(&at, &zero);
    let (job, wire) = (input(&job)?, wire.map(|wire| wire.get() - 1));
    let port = at.port;
    Ok(Command::DryRun(DryRunRequest {
        job,
        machine,
        material,
        despite_errors,
        accept_settings,
        port,
        wire,
        answers,
    }))
}

pub(super) fn jog(args: JogArgs) -> anyhow::Result<Command> {
    let JogArgs { machine, at, zero, record, force, moves: words } = args;
    let answers = answers(&at, &zero);
    Ok(Command::Jog(JogRequest {
        machine,
        port: at.port,
        moves: moves(&words).map_err(WrongUse)?,
        answers,
        record: record_file(record, force)?,
    }))
}

pub(super) fn replay(args: ReplayArgs) -> anyhow::Result<Command> {
    let ReplayArgs { file, at, zero, machine } = args;
    let (file, answers) = (input(&file)?, answers(&at, &zero));
    Ok(Command::Replay(ReplayRequest { file, machine, port: at.port, answers }))
}

fn record_file(path: Option<PathBuf>, force: bool) -> Result<Option<Output>, WrongUse> {
    if path.as_deref() == Some(Path::new("-")) {
        return Err(WrongUse("a record goes to a file: name one after --record".to_owned()));
    }
    Ok(path.map(|path| Output { path, force }))
}

const fn answers(at: &PortArgs, zero: &ZeroArgs) -> Answers {
    Answers { confirmed: at.yes, axes_at_zero: zero.axes_at_zero, head_at_deg: zero.head_at }
}

pub(super) fn ports(args: PortsArgs) -> Command {
    let PortsArgs { machine, driver } = args;
    Command::Ports(PortsRequest { machine, driver })
}

pub(super) fn machine_settings(args: MachineSettingsArgs) -> Command {
    let MachineSettingsArgs { machine, port, write, yes } = args;
    Command::MachineSettings(MachineSettingsRequest { machine, port, write, confirmed: yes })
}

pub(super) fn console(args: ConsoleArgs) -> anyhow::Result<Command> {
    let ConsoleArgs { machine, port, yes, mut lines } = args;
    if lines.is_empty() {
        let text = String::from_utf8(super::standard_input()?)
            .map_err(|_| BadInput("the lines of standard input are no UTF-8 text".to_owned()))?;
        lines = text.lines().map(str::to_owned).filter(|line| !line.trim().is_empty()).collect();
    }
    if lines.is_empty() {
        return Err(WrongUse("no line to send: name one, or write lines to standard input".to_owned()).into());
    }
    Ok(Command::Console(ConsoleRequest { machine, port, lines, confirmed: yes }))
}

pub(super) fn runs(command: RunsCommand) -> Result<Prepared, WrongUse> {
    let written = |request| Prepared::Command(Box::new(request), Contents::Written);
    Ok(match command {
        RunsCommand::List => written(Command::Runs(RunsRequest {})),
        RunsCommand::Show { id } => written(Command::RunsShow(RunsShowRequest { id })),
        RunsCommand::Export { id, output } => {
            let (output, contents) = place(output, true)?;
            let request = Command::RunsExport(RunsExportRequest { id, output });
            Prepared::Command(Box::new(request), contents)
        }
    })
}
