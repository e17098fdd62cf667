//! A job as files of G-code, one for each wire.

use std::rc::Rc;

use wirebend_driver_api::{DriverError, EncodedFile, Job};

use crate::program::{Program, trimmed};
use crate::settings::{Comments, Names, Settings, clean};

pub(crate) fn wire(settings: &Rc<Settings>, job: &Job, index: usize) -> Result<EncodedFile, DriverError> {
    let wire = &job.wires[index];
    let steps = wire.machine_steps(index)?;
    let names = Names {
        name: job.name.clone(),
        design: job.design_hash.clone(),
        // A design can be written without a job.
        job: job.job_hash.clone().unwrap_or_else(|| "none".to_owned()),
        machine: job.machine.id.clone(),
        wire: index + 1,
        steps: steps.len(),
        stock_mm: wire.stock_mm,
    };
    let mut program = Program::new(Rc::clone(settings), &names)?;
    let mut file = File { text: String::new(), comments: settings.comments };
    file.comment("WireBend-kit G-code: mm and degrees");
    file.comment(&format!("name {}", names.name));
    file.comment(&format!("design {}", names.design));
    file.comment(&format!("job {}", names.job));
    file.comment(&format!("machine {}", names.machine));
    file.comment(&format!("material {}", job.material.id));
    file.comment(&format!("wire {}, {} steps", names.wire, names.steps));
    if let Some(stock_mm) = wire.stock_mm {
        file.comment(&format!("stock {} mm", trimmed(stock_mm)));
    }
    file.lines(program.start());
    for (number, step) in (1_usize..).zip(steps) {
        let lines = program.step(step).map_err(|why| {
            let message = format!("wire {}, step {number} cannot be written: {why}", names.wire);
            DriverError::new(
                "step",
                message,
                "look at the step in the plan, and at the units in the settings",
            )
        })?;
        file.comment(&format!("step {number}"));
        file.lines(lines);
    }
    file.lines(program.end());
    Ok(EncodedFile { text: file.text })
}

struct File {
    text: String,
    comments: Comments,
}

impl File {
    fn comment(&mut self, text: &str) {
        // A word and a hash together are longer than the most that a placeholder becomes.
        let (word, rest) = text.split_once(' ').unwrap_or((text, ""));
        let text = format!("{word} {}", clean(rest));
        match self.comments {
            Comments::Parentheses => self.lines([format!("({text})")]),
            Comments::Semicolon => self.lines([format!("; {text}")]),
            Comments::None => {}
        }
    }

    fn lines(&mut self, lines: impl IntoIterator<Item = String>) {
        for line in lines {
            self.text.push_str(&line);
            self.text.push('\n');
        }
    }
}
