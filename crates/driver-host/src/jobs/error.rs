//! Why a wire is not begun, reattached or resumed.

use wirebend_error::{ErrorCode, ErrorRemedy};

use super::journal::JournalError;
use super::resume::{Contradiction, Settled};
use crate::session::SessionError;

/// Why a wire is not begun, reattached or resumed. Nothing moves for it.
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
        journal: String,
        job: String,
    },
    /// A number that cannot be sent to a machine, or steps that are not as many as the job says.
    #[error("{what}")]
    Steps { what: String },
    /// A person has to look first.
    #[error("it is not known whether step {step} was done")]
    InDoubt {
        /// The first step in doubt.
        step: u32,
    },
    /// A person has said something of a step that is not in doubt.
    #[error("step {step} is not the one in doubt: {}", expected(*in_doubt))]
    NotInDoubt {
        step: u32,
        /// The first that is.
        in_doubt: Option<u32>,
    },
    /// More of a step, or less than nothing of it.
    #[error("step {step} has a {what} of {whole:.1}{unit}, of which {part:.1}{unit} cannot be done")]
    NotOfStep {
        step: u32,
        /// Feed or rotation.
        what: &'static str,
        /// What was said of it.
        part: f64,
        whole: f64,
        unit: &'static str,
    },
    /// The machine is bending it at this moment.
    #[error("the wire is being bent")]
    AtWork,
    /// The machine and the journal cannot both be right.
    #[error(transparent)]
    Contradiction(#[from] Contradiction),
    /// There is nothing left to do.
    #[error("there is nothing left to do: {}", settled(*.0))]
    Nothing(Settled),
    /// A person has said that the wire goes on, and it waits for nobody.
    #[error("the wire does not wait at a pause point")]
    NotWaiting,
    /// It was not confirmed since the wire was begun or stopped.
    #[error("the wire was not begun, or was stopped since")]
    NotBegun,
}

impl JobError {
    /// A name that stays the same while the wording may change.
    #[must_use]
    pub fn code(&self) -> ErrorCode {
        match self {
            Self::Journal(error) => error.code(),
            Self::Session(error) => error.code(),
            Self::OtherWire { .. } => ErrorCode::OtherWire,
            Self::Steps { .. } => ErrorCode::Steps,
            Self::InDoubt { .. } | Self::NotInDoubt { .. } => ErrorCode::InDoubt,
            Self::NotOfStep { .. } => ErrorCode::NotOfStep,
            Self::AtWork => ErrorCode::AtWork,
            Self::Contradiction(_) => ErrorCode::Contradiction,
            Self::Nothing(_) => ErrorCode::Nothing,
            Self::NotBegun | Self::NotWaiting => ErrorCode::NotBegun,
        }
    }

    /// What can be done about it.
    #[must_use]
    pub fn remedies(&self) -> Vec<ErrorRemedy> {
        match self {
            Self::Journal(error) => error.remedies(),
            Self::Session(error) => error.remedies(),
            Self::Steps { .. } => vec![ErrorRemedy::PlanAgain],
            Self::InDoubt { .. } => vec![ErrorRemedy::LookAtWire],
            Self::AtWork => vec![ErrorRemedy::Wait, ErrorRemedy::Stop],
            Self::Contradiction(_) => vec![ErrorRemedy::Stop, ErrorRemedy::LookAtWire, ErrorRemedy::Home],
            Self::NotBegun => vec![ErrorRemedy::BeginAnew],
            Self::OtherWire { .. }
            | Self::NotInDoubt { .. }
            | Self::NotOfStep { .. }
            | Self::NotWaiting
            | Self::Nothing(_) => Vec::new(),
        }
    }
}

fn expected(in_doubt: Option<u32>) -> String {
    in_doubt.map_or_else(|| "none is".to_owned(), |step| format!("step {step} is"))
}

const fn settled(settled: Settled) -> &'static str {
    match settled {
        Settled::Finished => "the wire is finished",
        Settled::Abandoned => "the wire was given up",
        Settled::AllMade => "every step is done",
    }
}
