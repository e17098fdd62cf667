//! What machines did, where they can be, and how they are set.

use std::io::Write;

use wirebend_api::{
    ConsoleResponse, DoneBy, JogResponse, LeftBecause, MachineSettingsResponse, PiecesReport, PortsResponse,
    RunOutcome, RunResponse, SeverityName, Standstill, StoppedBy, StoppedIn, Usb, WireRun, shown_deg,
};

use super::number::{count, duration};
use super::tables::table;
use super::{advice, severity_style, written};

/// The summary of a run, for the reader of the result.
pub(super) fn run(out: &mut impl Write, err: &mut impl Write, found: &RunResponse) -> std::io::Result<()> {
    // Warnings were shown when they came; notes were not.
    super::notes(err, &found.notes)?;
    for wire in &found.wires {
        one_wire(out, err, wire)?;
    }
    if !found.left.is_empty() {
        let left: Vec<String> = found.left.iter().map(|wire| (wire + 1).to_string()).collect();
        let why = match found.left_because {
            Some(LeftBecause::Declined) => "as you said",
            Some(LeftBecause::NothingToResume) => {
                "so that there is nothing to resume: run each with --wire N"
            }
            Some(LeftBecause::NobodyAsked) => {
                "because it could not be confirmed that the next wire is loaded: run each with --wire N"
            }
            None => "because the wire before them was not done",
        };
        if found.pieces.of > 1 {
            let pieces = count((found.pieces.of - found.pieces.made) as usize, "piece", "pieces");
            let why = match found.left_because {
                Some(LeftBecause::NobodyAsked) => {
                    "because nobody could be asked before the next one: run them at a terminal"
                }
                _ => why,
            };
            writeln!(err, "not begun: {pieces}, {why}")?;
        } else {
            writeln!(err, "not begun: wire {}, {why}", left.join(", "))?;
        }
    }
    pieces(err, found.pieces)?;
    written(err, found.files.iter())
}

/// How many pieces are done, and what is left of the wire.
fn pieces(err: &mut impl Write, pieces: PiecesReport) -> std::io::Result<()> {
    let PiecesReport { made, of, stock_left_mm } = pieces;
    if of == 1 {
        return Ok(());
    }
    let left = stock_left_mm.map_or_else(String::new, |mm| format!("; {mm:.0} mm of wire are left"));
    writeln!(err, "{made} of {of} pieces finished{left}")
}

fn one_wire(out: &mut impl Write, err: &mut impl Write, wire: &WireRun) -> std::io::Result<()> {
    let WireRun { wire: index, id, made, steps, .. } = wire;
    let took = duration(wire.elapsed_s);
    // What the clock counts was not observed.
    let made = match wire.done_by {
        DoneBy::Machine => format!("{made} of {steps} steps done"),
        DoneBy::Clock => {
            format!("{made} of {steps} steps sent in full; the machine does not report whether it ran them")
        }
    };
    let outcome = match wire.outcome {
        RunOutcome::Made => format!("finished in {took}, all {steps} steps"),
        RunOutcome::MadeBefore => format!("finished before, all {steps} steps: nothing was left to do"),
        RunOutcome::Sent => {
            format!(
                "sent, all {steps} steps; the machine does not report whether it ran them: look at the wire"
            )
        }
        RunOutcome::Stopped => format!("stopped with {made}"),
        RunOutcome::Failed => format!("failed with {made}"),
        RunOutcome::Abandoned => format!("given up with {made}"),
    };
    let piece =
        wire.piece.map_or_else(String::new, |piece| format!("piece {} of {}, ", piece.number, piece.of));
    writeln!(out, "{piece}wire {}: {outcome} (record {id})", index + 1)?;
    if let Some(worst) = wire.worst_deviation_mm() {
        writeln!(out, "  the worst vertex of the simulated wire is {worst:.2} mm off")?;
    }
    if let Some(problem) = &wire.problem {
        let style = severity_style(SeverityName::Error);
        writeln!(err, "{style}error{style:#}[{}]: {}", problem.code, problem.message)?;
        advice::write(err, &problem.remedies)?;
    }
    standing(err, wire.stopped_by, wire.standstill)?;
    if let Some([first, last]) = wire.in_doubt {
        let which = if first == last { format!("step {first}") } else { format!("steps {first} to {last}") };
        let was = if first == last { "was" } else { "were" };
        writeln!(err, "it is not known whether {which} of {steps} {was} done: look at the wire")?;
    }
    if let Some(StoppedIn { step, made, of, bend_at_deg, sure }) = &wire.stopped_in {
        let counted = if *sure { "" } else { ", as the machine counts" };
        writeln!(
            err,
            "step {step} of {steps} was stopped in its middle{counted}: {:.1} of {:.1} mm are fed and {:.1}° of {:.1}° turned{}",
            made.feed_mm,
            of.feed_mm,
            shown_deg(made.rotate_deg),
            of.rotate_deg,
            bend_at_deg
                .map_or_else(String::new, |at| format!("; the bend axis stands at {:.1}°", shown_deg(at)))
        )?;
    }
    if let Some(resume) = &wire.resume {
        writeln!(err, "resume with:\n  {resume}")?;
    }
    Ok(())
}

/// Whether the machine stands, and what to do if that is not known.
fn standing(
    err: &mut impl Write,
    by: Option<StoppedBy>,
    standstill: Option<Standstill>,
) -> std::io::Result<()> {
    let told = !matches!(by, Some(StoppedBy::EndOfDriver | StoppedBy::NothingMore));
    match standstill {
        Some(Standstill::Confirmed) if by == Some(StoppedBy::EndOfSimulation) => {
            writeln!(err, "the simulated machine has ended with its driver")
        }
        Some(Standstill::Confirmed) => writeln!(err, "the machine has confirmed that it stands"),
        Some(Standstill::NotConfirmed | Standstill::Awaited) if told => {
            writeln!(err, "the machine has NOT confirmed that it stands: cut its power")
        }
        Some(Standstill::NotConfirmed | Standstill::Awaited) => {
            writeln!(err, "the machine was not ordered to stop and may still be moving: cut its power")
        }
        None => Ok(()),
    }
}

pub(super) fn jog(out: &mut impl Write, err: &mut impl Write, found: &JogResponse) -> std::io::Result<()> {
    let made = count(found.made.len(), "move", "moves");
    let stopped = if found.stopped { ", then stopped" } else { "" };
    writeln!(out, "{made} of {} done{stopped}", found.of)?;
    if !found.made.is_empty() && found.made.len() < found.of {
        let each: Vec<String> = found.made.iter().map(ToString::to_string).collect();
        writeln!(out, "  done: {}", each.join(", "))?;
    }
    if let Some(problem) = &found.problem {
        let style = severity_style(SeverityName::Error);
        writeln!(err, "{style}error{style:#}[{}]: {}", problem.code, problem.message)?;
        advice::write(err, &problem.remedies)?;
    }
    standing(err, None, found.standstill)?;
    // The others were told before anything moved.
    let of_recording = ["nothing-recorded", "not-saved", "misnamed"];
    for note in found.notes.iter().filter(|note| of_recording.contains(&&*note.code)) {
        writeln!(err, "note: {}", note.message)?;
    }
    written(err, found.output.iter())
}

pub(super) fn ports(
    out: &mut impl Write,
    err: &mut impl Write,
    found: &PortsResponse,
) -> std::io::Result<()> {
    let rows = found.ports.iter().map(|port| {
        [
            port.name.clone(),
            port.usb
                .as_ref()
                .map_or_else(|| "-".to_owned(), |usb| format!("{:04x}:{:04x}", usb.vid, usb.pid)),
            if port.likely_for.is_empty() { "-".to_owned() } else { port.likely_for.join(", ") },
            described(&port.description, port.usb.as_ref()),
        ]
    });
    table(out, ["port", "usb", "likely driver", "what"], rows)?;
    found.problems.iter().try_for_each(|problem| writeln!(err, "not asked: {problem}"))?;
    advice::write(err, &found.remedies)
}

fn described(description: &str, usb: Option<&Usb>) -> String {
    let serial = usb.and_then(|usb| usb.serial.as_ref());
    serial.map_or_else(|| description.to_owned(), |serial| format!("{description}, serial number {serial}"))
}

/// What was sent and answered, each line with its time; what else there is to say goes elsewhere.
pub(super) fn console(
    out: &mut impl Write,
    err: &mut impl Write,
    found: &ConsoleResponse,
) -> std::io::Result<()> {
    for line in &found.lines {
        let way = if line.to_machine { "->" } else { "<-" };
        writeln!(out, "{} {way} {}", line.at, line.text)?;
    }
    if found.stopped {
        writeln!(err, "stopped: {} of {} answered", found.answered, count(found.of, "line", "lines"))?;
    }
    if let Some(problem) = &found.problem {
        let style = severity_style(SeverityName::Error);
        writeln!(err, "{style}error{style:#}[{}]: {}", problem.code, problem.message)?;
        advice::write(err, &problem.remedies)?;
    }
    Ok(())
}

pub(super) fn machine_settings(
    out: &mut impl Write,
    err: &mut impl Write,
    found: &MachineSettingsResponse,
) -> std::io::Result<()> {
    writeln!(out, "{} at {}", found.identity, found.port)?;
    if found.settings.is_empty() {
        writeln!(out, "its settings match the profile '{}'", found.machine)?;
    } else {
        let rows = found.settings.iter().map(|setting| {
            let matters = if setting.matters { "wires come out wrong" } else { "does not matter" };
            let matters = if setting.machine == setting.expected { "as it should be" } else { matters };
            [setting.name.clone(), setting.machine.clone(), setting.expected.clone(), matters.to_owned()]
        });
        table(out, ["setting", "machine", "profile", ""], rows)?;
    }
    if found.written {
        return writeln!(err, "the settings were written; home the machine before it moves");
    }
    if !found.fits && !found.writable {
        return writeln!(
            err,
            "its driver cannot write settings: set them at the machine with its own program, or correct the profile"
        );
    }
    if !found.fits {
        let (machine, port) = (&found.machine, &found.port);
        writeln!(
            err,
            "write those of the profile with:\n  wirebend machine-settings --machine {machine} --port {port} --write"
        )?;
    }
    Ok(())
}
