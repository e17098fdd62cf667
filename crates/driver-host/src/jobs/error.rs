//! Why a wire is not begun, taken up or gone on with.

use super::journal::JournalError;
use super::resume::{Contradiction, Settled};
use crate::session::SessionError;

/// Why a wire is not begun, taken up or gone on with. Nothing moves for it.
#[derive(Debug, thiserror::Error)]
pub enum JobError {
    /// The journal cannot be read or written.
    #[error(transparent)]
    Journal(#[from] JournalError),
    /// The session does not do it.
    #[error(transparent)]
    Session(#[from] SessionError),
    /// The journal is of something else.
    #[error("the journal is of another wire: its {what} is {journal}, and that of the job is {job}")]
    OtherWire {
        /// What differs.
        what: &'static str,
        /// In the journal.
        journal: String,
        /// In the job.
        job: String,
    },
    /// A number that a machine cannot be told, or steps that are not as many as the job says.
    #[error("{what}; plan the job again")]
    Steps {
        /// What is wrong.
        what: String,
    },
    /// A person has to look first.
    #[error("nobody knows whether step {step} was made: look at the wire, and say so first")]
    InDoubt {
        /// The first step in doubt.
        step: u32,
    },
    /// A person has said something of a step that is not in doubt.
    #[error("step {step} is not the one in doubt: {}", expected(*in_doubt))]
    NotInDoubt {
        /// The step.
        step: u32,
        /// The first that is.
        in_doubt: Option<u32>,
    },
    /// More of a step, or less than nothing of it.
    #[error("step {step} has a {what} of {whole:.1}{unit}, of which {part:.1}{unit} cannot be made")]
    NotOfStep {
        /// The step.
        step: u32,
        /// Feed or rotation.
        what: &'static str,
        /// What was said of it.
        part: f64,
        /// The whole.
        whole: f64,
        /// Its unit.
        unit: &'static str,
    },
    /// The machine makes it at this moment.
    #[error("the wire is being made: wait, or stop the machine first")]
    AtWork,
    /// The machine and the journal cannot both be right.
    #[error(transparent)]
    Contradiction(#[from] Contradiction),
    /// There is nothing to be made.
    #[error("there is nothing to be made: {}", settled(*.0))]
    Nothing(Settled),
    /// Nobody has confirmed it since the wire was begun or stopped.
    #[error("the wire was not begun, or was stopped since: begin it first")]
    NotBegun,
}

fn expected(in_doubt: Option<u32>) -> String {
    in_doubt.map_or_else(|| "none is".to_owned(), |step| format!("step {step} is"))
}

const fn settled(settled: Settled) -> &'static str {
    match settled {
        Settled::Finished => "the wire is made",
        Settled::Abandoned => "the wire was given up",
        Settled::AllMade => "every step is made",
    }
}
