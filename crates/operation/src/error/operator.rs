//! Why an operator refuses an order.

use wirebend_driver_host::{OrderName, Phase, StoppedBy};

use wirebend_error::{ErrorCode, ErrorRemedy as R};

use super::live::{after_hard_stop, hard_stop};
use wirebend_planning::ErrorKind;

/// Why an operator refuses an order. Nothing moves for it.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum OperatorError {
    /// It is not the time for it.
    #[error("{order} is not possible while the machine is {phase}")]
    NotNow {
        order: OrderName,
        /// What the machine is in.
        phase: Phase,
    },
    /// An order before is still being carried out.
    #[error("{order} has to wait: an order before it is not done yet")]
    Busy { order: OrderName },
    /// A person is being asked.
    #[error("{order} has to wait until the question is answered")]
    QuestionOpen { order: OrderName },
    /// The driver does not know this at all.
    #[error("the driver of this machine cannot do this: {order}")]
    Unable { order: OrderName },
    /// A question that is not open any more was answered.
    #[error("question {id} is not open: it was answered, or what it was about is over")]
    NoQuestion { id: u64 },
    /// The answer is one to another kind of question.
    #[error("this does not answer question {id}, which takes {expected}")]
    WrongAnswer {
        id: u64,
        /// What answers it.
        expected: &'static str,
    },
    #[error("nothing was recorded")]
    NothingRecorded,
    /// The driver was opened with other settings than the job was planned with.
    #[error(
        "the job was planned with other settings of the driver, or other signs, than the profile of '{machine}' has now"
    )]
    ProfileChanged { machine: String },
    /// What it would do by its profile as it is now it would do otherwise.
    #[error("'{machine}' was connected before its profile was changed")]
    ConnectedBefore { machine: String },
    /// A wire of another machine is not finished by the simulated one.
    #[error(
        "wire {} was begun on the machine at {begun_at}, and this is the simulated one at {port}",
        .wire + 1
    )]
    BegunElsewhere {
        /// Index of the wire, from 0.
        wire: usize,
        begun_at: String,
        port: String,
    },
    /// The user has not confirmed that the wire may resume, and the machine has not left it.
    #[error("the machine still is in wire {}, and holds", .wire + 1)]
    LeftInWire {
        /// Index of the wire, from 0.
        wire: usize,
    },
    /// The driver did not pass a stop on.
    #[error("the driver did not pass the stop on and was ended{}", hard_stop(*.by))]
    DriverEnded {
        /// Who has stopped the machine.
        by: StoppedBy,
    },
    /// A speed that no machine is asked for.
    #[error("a speed of {percent} % is not possible: 10 to 200 % are")]
    Speed { percent: u8 },
    /// No machine is connected.
    #[error("no machine is connected")]
    NotConnected,
    /// A wire is ordered without the job that it is of.
    #[error("{order} needs a job")]
    NoJob { order: OrderName },
    /// The job of an interrupted wire is not there any more.
    #[error("the job {hash} of this wire was not kept, and the open design gives another one")]
    JobNotKept { hash: String },
    /// The system does not give a thread.
    #[error("the connection cannot be begun: {cause}")]
    NoThread { cause: String },
}

impl OperatorError {
    /// The kind of error, which gives the exit status.
    pub const fn kind(&self) -> ErrorKind {
        match self {
            Self::DriverEnded { .. } => ErrorKind::Stopped,
            Self::NoThread { .. } => ErrorKind::Failure,
            Self::ProfileChanged { .. } => ErrorKind::BadInput,
            _ => ErrorKind::Usage,
        }
    }

    /// A name that stays the same while the wording may change.
    #[must_use]
    pub const fn code(&self) -> ErrorCode {
        match self {
            Self::NotNow { .. } => ErrorCode::NotNow,
            Self::Busy { .. } => ErrorCode::Busy,
            Self::QuestionOpen { .. } => ErrorCode::QuestionOpen,
            Self::Unable { .. } => ErrorCode::Unsupported,
            Self::NoQuestion { .. } => ErrorCode::NoQuestion,
            Self::WrongAnswer { .. } => ErrorCode::WrongAnswer,
            Self::NothingRecorded => ErrorCode::NothingRecorded,
            Self::ProfileChanged { .. } => ErrorCode::ProfileChanged,
            Self::ConnectedBefore { .. } => ErrorCode::ConnectedBefore,
            Self::BegunElsewhere { .. } => ErrorCode::BegunElsewhere,
            Self::LeftInWire { .. } => ErrorCode::LeftInWire,
            Self::DriverEnded { .. } => ErrorCode::DriverEnded,
            Self::Speed { .. } => ErrorCode::Value,
            Self::NotConnected => ErrorCode::NotConnected,
            Self::NoJob { .. } => ErrorCode::NoJob,
            Self::JobNotKept { .. } => ErrorCode::JobNotKept,
            Self::NoThread { .. } => ErrorCode::NoThread,
        }
    }

    /// What can be done about it.
    pub fn remedies(&self) -> Vec<R> {
        match self {
            Self::NotNow { phase, .. } => vec![phase.remedy()],
            Self::Busy { .. } => vec![R::Wait, R::Stop],
            Self::QuestionOpen { .. } => vec![R::Answer],
            Self::Unable { .. } => vec![R::UseOtherMachine],
            Self::NothingRecorded => vec![R::RecordFirst],
            Self::ProfileChanged { .. } => vec![R::PlanAgain],
            Self::ConnectedBefore { .. } => vec![R::ConnectAgain],
            Self::BegunElsewhere { begun_at, .. } => vec![R::ConnectAt { port: begun_at.clone() }],
            Self::LeftInWire { .. } => vec![R::ContinueOrStop, R::BeginAnew],
            Self::DriverEnded { by } => after_hard_stop(*by),
            Self::NotConnected => vec![R::Connect],
            Self::NoJob { .. } => vec![R::ChooseJob],
            Self::JobNotKept { .. } => vec![R::OpenDesign],
            Self::NoThread { .. } => vec![R::CloseOtherPrograms],
            Self::NoQuestion { .. } | Self::WrongAnswer { .. } | Self::Speed { .. } => Vec::new(),
        }
    }
}
