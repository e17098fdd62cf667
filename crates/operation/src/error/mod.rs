//! What can go wrong with a machine.

mod head;
mod live;
mod live_code;
mod live_remedies;
mod operator;

use wirebend_driver_host::HostError;
use wirebend_error::{ErrorCode, ErrorRemedy};
use wirebend_files::document::DocumentError;
use wirebend_files::read::ReadError;
use wirebend_planning::{DriverProblem, ErrorKind, PlanningError};
use wirebend_profile::ProfileError;

pub use head::HeadProblem;
pub use live::LiveProblem;
pub use operator::OperatorError;

/// Why an operation came to nothing.
#[derive(Debug, thiserror::Error)]
pub enum OperationError {
    /// A job, a profile or a driver cannot be used.
    #[error(transparent)]
    Planning(#[from] PlanningError),
    /// A machine does not move, or does not any more.
    #[error(transparent)]
    Live(#[from] LiveProblem),
    /// An operator refuses an order.
    #[error(transparent)]
    Operator(#[from] OperatorError),
}

/// What is no matter of a machine.
macro_rules! of_planning {
    ($($error:ty),*) => {$(
        impl From<$error> for OperationError {
            fn from(error: $error) -> Self {
                Self::Planning(error.into())
            }
        }
    )*};
}

of_planning!(DocumentError, DriverProblem, HostError, ProfileError, ReadError, serde_json::Error);

impl OperationError {
    /// The kind of error, which gives the exit status.
    pub fn kind(&self) -> ErrorKind {
        match self {
            Self::Planning(error) => error.kind(),
            Self::Live(problem) => problem.kind(),
            Self::Operator(problem) => problem.kind(),
        }
    }

    /// A name that stays the same while the wording may change.
    pub fn code(&self) -> ErrorCode {
        match self {
            Self::Planning(error) => error.code(),
            Self::Live(problem) => problem.code(),
            Self::Operator(problem) => problem.code(),
        }
    }

    /// What can be done about it.
    pub fn remedies(&self) -> Vec<ErrorRemedy> {
        match self {
            Self::Planning(error) => error.remedies(),
            Self::Live(problem) => problem.remedies(),
            Self::Operator(problem) => problem.remedies(),
        }
    }
}

wirebend_error::reported!(wirebend_planning::text::shown => OperationError, LiveProblem);
