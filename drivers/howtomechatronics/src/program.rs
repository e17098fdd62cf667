//! Jobs as files: a command a line, and what a person should know of them.

use std::fmt::Write as _;

use wirebend_driver_api::{DriverError, Encoded, EncodedFile, Job, Note};

use crate::command::Command;
use crate::whole::{Axes, Axis};

/// Writes every wire of a job, each with a rounding of its own.
pub(crate) fn encode(job: &Job, most_feed_mm: i32) -> Result<Encoded, DriverError> {
    let mut files = Vec::with_capacity(job.wires.len());
    let (mut rounded, mut divided) = (Rounded::default(), 0);
    for (index, wire) in job.wires.iter().enumerate() {
        let mut axes = Axes::default();
        let mut text = format!("{}\n", Command::Manual);
        for (n, step) in wire.machine_steps(index)?.iter().enumerate() {
            let commands =
                axes.commands(step, &format!("wire {}, step {}", index + 1, n + 1), most_feed_mm)?;
            divided += usize::from(commands.iter().filter(|c| matches!(c, Command::Feed(_))).count() > 1);
            for command in commands {
                let _ = writeln!(text, "{command}");
            }
        }
        let _ = writeln!(text, "{}", Command::End);
        rounded.add(&axes);
        files.push(EncodedFile { text });
    }
    let mut notes = vec![
        note(
            "no-hash",
            files.len(),
            "the machine knows no comments, so the file does not carry the hash of its design: keep it beside \
             the document",
        ),
        note(
            "line-by-line",
            files.len(),
            "send the file a line at a time, each when the machine has finished the one before: what arrives \
             together it takes for one command",
        ),
    ];
    notes.extend(rounded.note());
    if divided > 0 {
        let message = format!("feeds above {most_feed_mm} mm are written as several");
        notes.push(note("divided-feed", divided, &message));
    }
    Ok(Encoded { files, notes })
}

fn note(code: &str, count: usize, message: &str) -> Note {
    Note { code: code.to_owned(), count, message: message.to_owned() }
}

/// The worst of all wires: for feed, rotation and bend the error of a single one, and that of them together.
#[derive(Default)]
struct Rounded {
    changed: usize,
    axes: [(f64, f64); 3],
}

impl Rounded {
    fn add(&mut self, axes: &Axes) {
        let of = |axis: &Axis, together: f64| (axis.changed, axis.max_error, together);
        let axes = [
            of(&axes.feed, axes.feed.carry.abs()),
            of(&axes.rotate, axes.rotate.carry.abs()),
            of(axes.bend.each(), axes.bend.together()),
        ];
        for (worst, (changed, max_error, together)) in self.axes.iter_mut().zip(axes) {
            self.changed += changed;
            *worst = (worst.0.max(max_error), worst.1.max(together));
        }
    }

    fn note(&self) -> Option<Note> {
        let [feed, rotate, bend] = self.axes;
        let message = format!(
            "{} rounded to whole numbers, and what is left over goes to the next of the same axis, of \
             bends to the next in the same plane: a feed is off by up to {:.2} mm and all of them together by \
             {:.2} mm, a rotation by up to {:.2} degrees and all of them together by {:.2}, a bend by up to \
             {:.2} degrees and those in one plane together by {:.2}",
            if self.changed == 1 { "1 value is".to_owned() } else { format!("{} values are", self.changed) },
            feed.0,
            feed.1,
            rotate.0,
            rotate.1,
            bend.0,
            bend.1
        );
        (self.changed > 0).then(|| note("rounded", self.changed, &message))
    }
}
