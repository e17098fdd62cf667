//! What a person reads before they say yes.

use wirebend_core::units::Mm;
use wirebend_driver_host::api::{DoneBy, ReferenceBy};

use super::task::Task;
use crate::OperationError;
use crate::live::Connection;
use wirebend_planning::job::JobCollisions;
use wirebend_planning::machine::planned_despite;
use wirebend_planning::pauses;
use wirebend_planning::report::shown_deg;
use wirebend_planning::text::shown;

/// What will happen to a wire. `begins`: what to see to where it is begun; none where it resumes. `homes`: the reference is found
/// first.
pub fn about(
    task: &Task,
    connection: &Connection,
    wire: usize,
    begins: Option<Vec<String>>,
    homes: bool,
) -> Result<Vec<String>, OperationError> {
    let kept = task.wire(wire)?;
    let (setup, count) = (&task.setup, task.job.contents().wires.len());
    let identity = connection.session.identity();
    let said = if identity.is_empty() { String::new() } else { format!(" ({identity})") };
    let mut lines = vec![format!("{} at {}{said}", setup.machine_name(), connection.port)];
    lines.extend(connection.why_here());
    if let Some(program) = &task.job.contents().program {
        lines.push(format!("the program {} runs as it stands: nothing of it is compensated", program.file));
    }
    let steps = kept.compensated.len();
    let bends = kept.compensated.iter().filter(|step| step.bend_deg != 0.0).count();
    let fed = setup.fed_mm(kept);
    let which = if count > 1 { format!("wire {} of {count}", wire + 1) } else { "the wire".to_owned() };
    let (steps, bends) = (counted(steps, "step"), counted(bends, "bend"));
    let seconds = task.work(wire, connection)?.estimates.iter().map(|time| time.total().as_secs_f64()).sum();
    let anew = begins.is_some();
    // How long the rest of a wire that was begun takes is not estimated.
    let time = if anew { format!("; {} on the machine", minutes(seconds)) } else { String::new() };
    lines.push(format!("{which}: {steps}, {bends}, {:.1} fed{time}", Mm(fed)));
    if anew && connection.wire_bent && !task.pieces.get().follows() {
        lines.push(
            "a wire was bent before: cut it off and take it out, if it is still in the machine".to_owned(),
        );
    }
    lines.extend(begins.into_iter().flatten());
    lines.extend(pauses::lines(if anew { task.pauses(wire) } else { &[] }));
    if connection.wire_used {
        let what = if anew {
            "wire was fed or bent by hand before: put in new wire, or cut off what sticks out of the nozzle"
        } else {
            "wire was fed or bent by hand since it was interrupted: the rest of the wire comes out displaced by that"
        };
        lines.push(what.to_owned());
    }
    let (mut head, mut least, mut most) = (0.0_f64, 0.0_f64, 0.0_f64);
    // As in the wire: what turns are off by, and what they lose, is in what the head is told.
    for step in &kept.scheduled {
        head += step.rotate_deg;
        (least, most) = (least.min(head), most.max(head));
    }
    if most > least {
        lines.push(format!(
            "the head turns between {:.1}° and {:.1}°, and ends at {:.1}°",
            shown_deg(least),
            shown_deg(most),
            shown_deg(head)
        ));
    }
    lines.extend(collisions(task, wire)?);
    if anew && task.pieces.get().cut_at_mm().is_some() {
        // The others follow without a question.
        for other in task.wanted().into_iter().filter(|&other| other != wire) {
            let found = JobCollisions::of(task.wire(other)?, &task.setup);
            let of_other = shown(|| found.lines());
            lines.extend(of_other.into_iter().map(|line| format!("wire {}: {line}", other + 1)));
        }
    }
    if connection.session.done_by() == DoneBy::Clock {
        lines.push(
            "this machine does not report whether it runs what it is sent: watch it, and see that it is at this port"
                .to_owned(),
        );
    }
    lines.extend(connection.head_lines(homes));
    if homes {
        lines.push(first(connection.reference(), "the bend axis moves at once"));
    }
    lines.extend(task.stale());
    lines.extend(task.job.contents().objections.iter().map(|error| planned_despite(error)));
    Ok(lines)
}

/// What is known of collisions, and that a person watches in any case.
fn collisions(task: &Task, wire: usize) -> Result<Vec<String>, OperationError> {
    const WATCH: &str = "watch it, with STOP at hand";
    task.progress.stage("checking for collisions");
    let found = JobCollisions::of(task.wire(wire)?, &task.setup);
    let mut lines = shown(|| found.lines());
    match lines.last_mut().filter(|_| !found.some()) {
        Some(last) => *last = format!("{last}: {WATCH}"),
        None => lines.push(WATCH.to_owned()),
    }
    Ok(lines)
}

/// How the reference is found before a wire; `moves`: what a person has to see to where the machine moves for it.
pub(super) fn first(reference: ReferenceBy, moves: &str) -> String {
    match reference {
        ReferenceBy::Machine => format!("first the machine homes: {moves}"),
        ReferenceBy::Person => {
            "first you are asked whether every axis stands at zero: this machine has no switches to find it"
                .to_owned()
        }
    }
}

pub(super) fn counted(many: usize, one: &str) -> String {
    if many == 1 { format!("1 {one}") } else { format!("{many} {one}s") }
}

fn minutes(seconds: f64) -> String {
    if seconds < 60.0 { format!("about {seconds:.0} s") } else { format!("about {:.1} min", seconds / 60.0) }
}
