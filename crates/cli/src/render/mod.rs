//! Responses as text for a person, or as JSON for a program.

pub(crate) mod advice;
mod calibrate;
mod compare;
mod drivers;
mod frame;
mod live;
pub(crate) mod number;
mod options;
pub(crate) mod plan;
mod profile;
mod runs;
mod sequence;
mod simulate;
mod tables;
mod wires;

use std::io::Write;

use anstyle::{AnsiColor, Style};
use wirebend_api::{
    ExportResponse, GenerateResponse, ImportResponse, LeftBecause, NoteReport, Response, RunOutcome,
    RunResponse, SeverityName, Standstill,
};

use crate::contents::Contents;
use crate::exit;
use crate::usage::WrongUse;
use number::{count, mm};

/// Shows a response and gives the exit status that it deserves.
pub(crate) fn show(response: &Response, json: bool, contents: Contents) -> anyhow::Result<u8> {
    // Contents on the standard output leave no room for a second value there: the report is then for a
    // person, whatever was asked for.
    let on_output = contents == Contents::StandardOutput && write_contents(response)?;
    if json && !on_output {
        let mut out = std::io::stdout().lock();
        writeln!(out, "{}", serde_json::to_string_pretty(response)?)?;
    } else {
        let mut err = anstream::stderr().lock();
        match response {
            Response::Machines(found) => tables::machines(&mut std::io::stdout().lock(), found)?,
            Response::Materials(found) => tables::materials(&mut std::io::stdout().lock(), found)?,
            Response::Drivers(found) => drivers::list(&mut std::io::stdout().lock(), &mut err, found)?,
            Response::DriverCheck(found) => drivers::check(&mut err, found)?,
            Response::DriverTrust(found) => drivers::trust(&mut err, found)?,
            Response::Import(found) => import(&mut err, found)?,
            Response::Generate(found) => generate(&mut err, found)?,
            Response::Check(found) => plan::check(&mut err, found)?,
            Response::Plan(found) => plan::plan(&mut err, found)?,
            Response::Export(found) => export(&mut err, found)?,
            Response::Simulate(found) => simulate::simulate(&mut err, found)?,
            Response::Frame(found) => frame::frame(&mut err, found)?,
            Response::Tolerance(found) => frame::tolerance(&mut err, found)?,
            Response::Sequence(found) => sequence::sequence(&mut err, found)?,
            Response::Run(found) => live::run(&mut std::io::stdout().lock(), &mut err, found)?,
            Response::Jog(found) | Response::Replay(found) | Response::DryRun(found) => {
                live::jog(&mut std::io::stdout().lock(), &mut err, found)?;
            }
            Response::Ports(found) => live::ports(&mut std::io::stdout().lock(), &mut err, found)?,
            Response::MachineSettings(found) => {
                live::machine_settings(&mut std::io::stdout().lock(), &mut err, found)?;
            }
            Response::Console(found) => {
                live::console(&mut std::io::stdout().lock(), &mut err, found)?;
            }
            Response::Runs(found) => runs::list(&mut std::io::stdout().lock(), &mut err, found)?,
            Response::RunsShow(found) => runs::show(&mut std::io::stdout().lock(), found)?,
            Response::RunsExport(found) => runs::export(&mut err, found)?,
            Response::Dump(found) => {
                writeln!(std::io::stdout().lock(), "{}", serde_json::to_string_pretty(&found.value)?)?;
            }
            Response::Compare(found) => compare::compare(&mut err, found)?,
            Response::Wires(found) => wires::wires(&mut err, found)?,
            Response::ProfileCheck(found) => profile::check(&mut err, found)?,
            Response::ProfileNew(found) => profile::new(&mut err, found)?,
            Response::ProfileSet(found) => profile::set(&mut err, found)?,
            Response::ProfileRevert(found) => profile::revert(&mut err, found)?,
            Response::ProfileExport(found) => profile::exported(&mut err, found)?,
            Response::ProfileImport(found) => profile::imported(&mut err, found)?,
            Response::CalibrateNew(found) => calibrate::new(&mut err, found)?,
            Response::CalibrateEnter(found) => calibrate::enter(&mut err, found)?,
            Response::CalibrateFit(found) => calibrate::fit(&mut anstream::stdout().lock(), found)?,
            Response::CalibrateApply(found) => calibrate::apply(&mut err, found)?,
            Response::CalibrateCompare(found) => calibrate::compare(&mut std::io::stdout().lock(), found)?,
            Response::ProfileExplain(found) => profile::explain(&mut anstream::stdout().lock(), found)?,
        }
    }
    Ok(status(response))
}

fn status(response: &Response) -> u8 {
    let feasible = match response {
        Response::Check(found) => found.feasible,
        Response::Plan(found) => found.report.feasible(),
        Response::Compare(found) => found.from.feasible,
        Response::Simulate(found) => !simulate::hits(found),
        Response::Frame(found) => found.holds,
        Response::Sequence(found) => found.feasible,
        Response::Wires(found) => found.rows.iter().any(|row| row.side.feasible),
        Response::ProfileCheck(found) => return if found.ok { exit::DONE } else { exit::BAD_INPUT },
        Response::DriverCheck(found) => return if found.kept { exit::DONE } else { exit::FAILURE },
        // A user who asked to accept it has to read that it is not accepted.
        Response::DriverTrust(found) => return if found.accepted { exit::DONE } else { exit::USAGE },
        Response::Run(found) => return status_of_run(found),
        Response::Jog(found) | Response::Replay(found) | Response::DryRun(found)
            if may_move(found.standstill) =>
        {
            return exit::MAY_MOVE;
        }
        Response::Jog(found) | Response::Replay(found) | Response::DryRun(found) if found.stopped => {
            return exit::STOPPED;
        }
        Response::Jog(found) | Response::Replay(found) | Response::DryRun(found)
            if found.left_because.is_some() =>
        {
            return match found.left_because {
                Some(LeftBecause::NobodyAsked | LeftBecause::NothingToResume) => exit::USAGE,
                Some(LeftBecause::Declined) | None => exit::STOPPED,
            };
        }
        Response::Jog(found) | Response::Replay(found) | Response::DryRun(found)
            if found.problem.is_some() =>
        {
            return exit::FAILURE;
        }
        Response::Console(found) if found.stopped => return exit::STOPPED,
        Response::Console(found) if found.problem.is_some() => return exit::FAILURE,
        Response::Jog(_)
        | Response::Console(_)
        | Response::Replay(_)
        | Response::DryRun(_)
        | Response::Ports(_)
        | Response::MachineSettings(_)
        | Response::Runs(_)
        | Response::RunsShow(_)
        | Response::RunsExport(_)
        | Response::Machines(_)
        | Response::Drivers(_)
        | Response::Materials(_)
        | Response::Import(_)
        | Response::Generate(_)
        | Response::Export(_)
        | Response::Dump(_)
        | Response::Tolerance(_)
        | Response::ProfileNew(_)
        | Response::ProfileExplain(_)
        | Response::ProfileSet(_)
        | Response::ProfileRevert(_)
        | Response::ProfileExport(_)
        | Response::ProfileImport(_)
        | Response::CalibrateNew(_)
        | Response::CalibrateEnter(_)
        | Response::CalibrateFit(_)
        | Response::CalibrateApply(_)
        | Response::CalibrateCompare(_) => true,
    };
    if feasible { exit::DONE } else { exit::NOT_FEASIBLE }
}

/// Whether a machine was stopped that has not confirmed that it stands.
fn may_move(standstill: Option<Standstill>) -> bool {
    standstill.is_some_and(|standstill| standstill != Standstill::Confirmed)
}

/// A machine that may still be moving counts before all else, a wire that failed before one that was stopped, and that
/// before what was not confirmed.
fn status_of_run(found: &RunResponse) -> u8 {
    let any = |outcome| found.wires.iter().any(|wire| wire.outcome == outcome);
    match found.left_because {
        _ if found.wires.iter().any(|wire| may_move(wire.standstill)) => exit::MAY_MOVE,
        _ if any(RunOutcome::Failed) => exit::FAILURE,
        _ if any(RunOutcome::Stopped) => exit::STOPPED,
        // It was made, and not cut off.
        _ if found.wires.iter().any(|wire| wire.outcome.is_whole() && wire.problem.is_some()) => {
            let stopped = found.wires.iter().any(|wire| wire.stopped_by.is_some());
            if stopped { exit::STOPPED } else { exit::FAILURE }
        }
        Some(LeftBecause::Declined) => exit::STOPPED,
        Some(LeftBecause::NobodyAsked | LeftBecause::NothingToResume) => exit::USAGE,
        None => exit::DONE,
    }
}

/// Whether there were contents to write.
fn write_contents(response: &Response) -> anyhow::Result<bool> {
    let mut out = std::io::stdout().lock();
    let contents = match response {
        Response::Import(found) => &found.contents,
        Response::Generate(found) => &found.contents,
        Response::Plan(found) => &found.contents,
        Response::ProfileNew(found) => &found.contents,
        Response::ProfileExport(found) => &found.contents,
        Response::RunsExport(found) => &found.contents,
        Response::Export(found) => {
            if found.contents.len() > 1 {
                let wires = found.contents.len();
                let advice = "name one with -o, and the others get numbers";
                return Err(WrongUse(format!("{wires} wires go to {wires} files: {advice}")).into());
            }
            let Some(contents) = found.contents.first() else { return Ok(false) };
            contents
        }
        _ => return Ok(false),
    };
    out.write_all(contents)?;
    out.flush()?;
    Ok(!contents.is_empty())
}

/// The colour of a severity, where the terminal has colours.
pub(crate) fn severity_style(severity: SeverityName) -> Style {
    let colour = match severity {
        SeverityName::Error => AnsiColor::Red,
        SeverityName::Warning => AnsiColor::Yellow,
        SeverityName::Info => AnsiColor::Cyan,
    };
    Style::new().bold().fg_color(Some(colour.into()))
}

pub(crate) fn notes(out: &mut impl Write, notes: &[NoteReport]) -> std::io::Result<()> {
    notes.iter().try_for_each(|note| {
        writeln!(out, "note: {}", note.message)?;
        advice::write(out, &note.remedies)
    })
}

fn import(out: &mut impl Write, found: &ImportResponse) -> std::io::Result<()> {
    notes(out, &found.notes)?;
    let size: Vec<String> = found.size_mm.iter().map(|&length| mm(length)).collect();
    writeln!(
        out,
        "{}: {}, {}, {}; {} mm in all, {} mm large",
        found.format,
        count(found.vertices, "vertex", "vertices"),
        count(found.edges, "edge", "edges"),
        count(found.components, "part", "parts"),
        mm(found.length_mm),
        size.join(" × ")
    )?;
    if let Some(stencil) = found.stencil {
        let faces = count(stencil.faces, "face", "faces");
        writeln!(out, "stencil: {}, {faces}", count(stencil.vertices, "vertex", "vertices"))?;
    }
    written(out, found.output.iter())
}

fn generate(out: &mut impl Write, found: &GenerateResponse) -> std::io::Result<()> {
    notes(out, &found.notes)?;
    let size: Vec<String> = found.size_mm.iter().map(|&length| mm(length)).collect();
    let [least, most] = found.strut_mm.map(mm);
    let struts = if least == most { least } else { format!("{least} to {most}") };
    writeln!(
        out,
        "{}, {} of {struts} mm; {} mm in all, {} mm large",
        count(found.vertices, "vertex", "vertices"),
        count(found.edges, "edge", "edges"),
        mm(found.length_mm),
        size.join(" × ")
    )?;
    written(out, found.output.iter())
}

fn export(out: &mut impl Write, found: &ExportResponse) -> std::io::Result<()> {
    notes(out, &found.notes)?;
    if !found.feasible {
        let style = severity_style(SeverityName::Warning);
        let machine = &found.machine;
        writeln!(
            out,
            "{style}warning{style:#}: this cannot be bent on '{machine}'; `wirebend check --collisions` says why"
        )?;
    }
    written(out, found.files.iter())
}

pub(crate) fn written<'a>(
    out: &mut impl Write,
    mut files: impl Iterator<Item = &'a std::path::PathBuf>,
) -> std::io::Result<()> {
    files.try_for_each(|file| writeln!(out, "wrote {}", file.display()))
}
