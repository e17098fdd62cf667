//! What was bent.

use std::io::Write;

use wirebend_api::{
    Outcome, PartInWire, RunEntry, RunsExportResponse, RunsResponse, RunsShowResponse, ToldBy,
};

use super::number::mm;
use super::tables::table;
use super::{notes, written};

pub(super) fn list(out: &mut impl Write, err: &mut impl Write, found: &RunsResponse) -> std::io::Result<()> {
    let rows = found.runs.iter().filter(|run| run.problem.is_none()).map(row);
    table(out, ["id", "begun", "design", "machine", "steps", "outcome", "worst"], rows)?;
    for run in &found.runs {
        if let Some(problem) = &run.problem {
            writeln!(err, "{}: {problem}", run.id)?;
        }
    }
    Ok(())
}

fn row(run: &RunEntry) -> [String; 7] {
    let text = |text: &Option<String>| text.clone().unwrap_or_default();
    let interruptions = match run.interruptions.unwrap_or_default() {
        0 => String::new(),
        1 => ", interrupted once".to_owned(),
        times => format!(", interrupted {times} times"),
    };
    [
        run.id.clone(),
        text(&run.started),
        run.piece.map_or_else(
            || text(&run.name),
            |piece| format!("{}, {} of {}", text(&run.name), piece.number, piece.of),
        ),
        text(&run.machine),
        format!("{} of {}", run.made.unwrap_or_default(), run.steps.unwrap_or_default()),
        format!("{}{interruptions}", run.outcome.map_or("", outcome)),
        run.worst_deviation_mm.map_or_else(|| "-".to_owned(), |worst| format!("{worst:.2} mm")),
    ]
}

const fn outcome(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Finished => "finished",
        Outcome::Sent => "sent, not acknowledged",
        Outcome::Abandoned => "given up",
        Outcome::Unfinished => "not over",
    }
}

pub(super) fn show(out: &mut impl Write, found: &RunsShowResponse) -> std::io::Result<()> {
    let record = &found.record;
    let job = &record.job;
    let mut line = |label: &str, text: &str| writeln!(out, "  {label:<12} {text}");
    line("record", &found.id)?;
    line("design", &format!("{} ({})", job.name, job.design_hash))?;
    line("job", &format!("{}, wire {}", job.job_hash, job.wire + 1))?;
    line(
        "machine",
        &format!("{} at {}, driver {} {}", job.machine, job.port, job.driver, job.driver_version),
    )?;
    let stock = job.stock_mm.map(|stock| format!(", {} mm put in", mm(stock))).unwrap_or_default();
    line("material", &format!("{}{stock}", job.material))?;
    line("begun", &record.started)?;
    line("over", record.ended.as_deref().unwrap_or("not yet"))?;
    line("outcome", &format!("{}, {} of {} steps", outcome(record.outcome), record.made, job.steps))?;
    for interruption in &record.interruptions {
        let text = format!("{} after step {}: {}", interruption.at, interruption.after, interruption.what);
        line("interrupted", &text)?;
    }
    for pause in &record.pauses {
        line("paused", &format!("{} after step {}: {}", pause.at, pause.after, pause.note))?;
    }
    for decision in &record.decisions {
        let step = decision.step;
        let what = match decision.part {
            _ if decision.made => format!("step {step} was done"),
            None => format!("step {step} was not done"),
            Some(PartInWire { feed_mm, rotate_deg, by }) => {
                let by = match by {
                    ToldBy::Machine => "it",
                    ToldBy::Person => "a person",
                };
                format!(
                    "of step {step} {feed_mm:.1} mm were fed and {rotate_deg:.1}° turned by the machine's own count, as {by} said"
                )
            }
        };
        line("decided", &format!("{}: {what}", decision.at))?;
    }
    if let Some(deviations) = &record.deviations_mm {
        let worst = deviations.iter().copied().fold(0.0, f64::max);
        line("deviation", &format!("the worst vertex is {worst:.2} mm off"))?;
    }
    Ok(())
}

pub(super) fn export(err: &mut impl Write, found: &RunsExportResponse) -> std::io::Result<()> {
    notes(err, &found.notes)?;
    written(err, found.output.iter())
}
