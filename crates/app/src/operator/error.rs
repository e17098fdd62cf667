//! Why an operator does not do what it was told.

use wirebend_driver_host::StoppedBy;

use super::order::OrderName;
use super::state::Phase;
use crate::ErrorKind;
use crate::live::hard_stop;

/// Why an operator does not do what it was told. Nothing moves for it.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum OperatorError {
    /// It is not the time for it.
    #[error("{order} is not possible while the machine is {phase}: {}", phase.advice())]
    NotNow {
        /// What was ordered.
        order: OrderName,
        /// What the machine is in.
        phase: Phase,
    },
    /// An order before is still being carried out.
    #[error("{order} has to wait: an order before it is not done yet; wait for it, or stop the machine")]
    Busy {
        /// What was ordered.
        order: OrderName,
    },
    /// A person is being asked.
    #[error("{order} has to wait until the question is answered: say yes or no to it first")]
    QuestionOpen {
        /// What was ordered.
        order: OrderName,
    },
    /// The driver does not know this at all.
    #[error("the driver of this machine cannot do this: {order}; use another machine, or do it by hand")]
    Unable {
        /// What was ordered.
        order: OrderName,
    },
    /// A question that is not open any more was answered.
    #[error("question {id} is not open: it was answered, or what it was about is over")]
    NoQuestion {
        /// Its number.
        id: u64,
    },
    /// The answer is one to another kind of question.
    #[error("this does not answer question {id}: say {expected}")]
    WrongAnswer {
        /// Its number.
        id: u64,
        /// What answers it.
        expected: &'static str,
    },
    /// Nothing was recorded.
    #[error("nothing was recorded: move the machine by hand with recording on")]
    NothingRecorded,
    /// The driver was opened with other settings than the job was planned with.
    #[error(
        "the job was planned with other settings of the driver, or other signs, than the profile of '{machine}' has now: plan the design again"
    )]
    ProfileChanged {
        /// The machine.
        machine: String,
    },
    /// What it would do by its profile as it is now it would do otherwise.
    #[error("'{machine}' was connected before its profile was changed: disconnect it, and connect it again")]
    ConnectedBefore {
        /// The machine.
        machine: String,
    },
    /// A wire of another machine is not finished by the simulated one.
    #[error(
        "wire {} was begun on the machine at {begun_at}, and this is the simulated one at {port}: connect to that one to go on with it",
        .wire + 1
    )]
    BegunElsewhere {
        /// Index of the wire, from 0.
        wire: usize,
        /// Where it was begun.
        begun_at: String,
        /// Where this one is.
        port: String,
    },
    /// Nobody has said that the wire may go on, and the machine has not left it.
    #[error(
        "the machine still is in wire {}, and holds: go on with it, or give it up and connect the machine anew",
        .wire + 1
    )]
    LeftInWire {
        /// Index of the wire, from 0.
        wire: usize,
    },
    /// The driver did not pass a stop on.
    #[error("the driver did not pass the stop on and was ended: {}", hard_stop(*.by))]
    DriverEnded {
        /// Who has stopped the machine.
        by: StoppedBy,
    },
    /// There is no machine to be told anything.
    #[error("no machine is connected: connect it first")]
    NotConnected,
    /// The job of an interrupted wire is not there any more.
    #[error(
        "the job {hash} of this wire was not kept, and the open design makes another one: open its design, or go on with it by `wirebend run JOB --resume`"
    )]
    JobNotKept {
        /// Its hash.
        hash: String,
    },
    /// The system does not give a thread.
    #[error("the connection cannot be begun: {cause}; close other programs and try again")]
    NoThread {
        /// Why.
        cause: String,
    },
}

impl OperatorError {
    /// Whose turn it is.
    pub(crate) const fn kind(&self) -> ErrorKind {
        match self {
            Self::DriverEnded { .. } => ErrorKind::Stopped,
            Self::NoThread { .. } => ErrorKind::Failure,
            Self::ProfileChanged { .. } => ErrorKind::BadInput,
            _ => ErrorKind::Usage,
        }
    }

    /// A name that stays the same while the wording may change.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::NotNow { .. } => "not-now",
            Self::Busy { .. } => "busy",
            Self::QuestionOpen { .. } => "question-open",
            Self::Unable { .. } => "unsupported",
            Self::NoQuestion { .. } => "no-question",
            Self::WrongAnswer { .. } => "wrong-answer",
            Self::NothingRecorded => "nothing-recorded",
            Self::ProfileChanged { .. } => "profile-changed",
            Self::ConnectedBefore { .. } => "connected-before",
            Self::BegunElsewhere { .. } => "begun-elsewhere",
            Self::LeftInWire { .. } => "left-in-wire",
            Self::DriverEnded { .. } => "driver-ended",
            Self::NotConnected => "not-connected",
            Self::JobNotKept { .. } => "job-not-kept",
            Self::NoThread { .. } => "no-thread",
        }
    }
}
