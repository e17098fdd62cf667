//! What can go wrong with whatever is asked.

use wirebend_driver_host::HostError;
use wirebend_editor::EditorError;
use wirebend_error::{ErrorCode, ErrorRemedy};
use wirebend_files::document::DocumentError;
use wirebend_files::read::ReadError;
use wirebend_operation::{LiveProblem, OperationError, OperatorError};
use wirebend_planning::{DriverProblem, ErrorKind, PlanReport, PlanningError, StencilFileError};
use wirebend_profile::ProfileError;

/// Why something that was asked came to nothing.
#[derive(Debug, thiserror::Error)]
pub enum ApiError {
    /// A design, a job, a profile or a driver cannot be used.
    #[error(transparent)]
    Planning(#[from] PlanningError),
    /// The open design cannot be changed like this, or not be kept safe.
    #[error(transparent)]
    Editor(EditorError),
    /// A machine does not do it.
    #[error(transparent)]
    Operation(OperationError),
    /// There is no example of this id.
    #[error("there is no example '{id}'")]
    NoExample {
        /// The wanted one.
        id: String,
        known: Vec<String>,
    },
    /// The file that is open to be run is another one on the disk by now.
    #[error(
        "{name} has changed on the disk since it was opened: the view shows what was read then, and nothing of what the file has now was looked at"
    )]
    FileChanged { name: String },
    /// There is no folder for a person's own profiles.
    #[error("there is no home folder for profiles of your own")]
    NoOwnFolder,
}

impl From<EditorError> for ApiError {
    fn from(error: EditorError) -> Self {
        match error {
            EditorError::Planning(error) => Self::Planning(error),
            other => Self::Editor(other),
        }
    }
}

impl From<OperationError> for ApiError {
    fn from(error: OperationError) -> Self {
        match error {
            OperationError::Planning(error) => Self::Planning(error),
            other => Self::Operation(other),
        }
    }
}

/// What is of a room before.
macro_rules! through {
    ($through:ty: $($error:ty),*) => {$(
        impl From<$error> for ApiError {
            fn from(error: $error) -> Self {
                <$through>::from(error).into()
            }
        }
    )*};
}

through!(PlanningError: DocumentError, DriverProblem, HostError, ProfileError, ReadError, StencilFileError, serde_json::Error);
through!(OperationError: LiveProblem, OperatorError);

impl ApiError {
    /// The kind of error, which gives the exit status.
    pub fn kind(&self) -> ErrorKind {
        match self {
            Self::Planning(error) => error.kind(),
            Self::Editor(error) => error.kind(),
            Self::Operation(error) => error.kind(),
            Self::FileChanged { .. } => ErrorKind::BadInput,
            Self::NoExample { .. } | Self::NoOwnFolder => ErrorKind::Usage,
        }
    }

    /// A name that stays the same while the wording may change.
    pub fn code(&self) -> ErrorCode {
        match self {
            Self::Planning(error) => error.code(),
            Self::Editor(error) => error.code(),
            Self::Operation(error) => error.code(),
            Self::NoExample { .. } => ErrorCode::NoExample,
            Self::FileChanged { .. } => ErrorCode::FileChanged,
            Self::NoOwnFolder => ErrorCode::NoOwnFolder,
        }
    }

    /// What can be done about it.
    pub fn remedies(&self) -> Vec<ErrorRemedy> {
        match self {
            Self::Planning(error) => error.remedies(),
            Self::Editor(error) => error.remedies(),
            Self::Operation(error) => error.remedies(),
            Self::NoExample { known, .. } => {
                vec![ErrorRemedy::ChooseKnown { near: Vec::new(), known: known.clone() }]
            }
            Self::FileChanged { .. } => vec![ErrorRemedy::ReadAgain],
            Self::NoOwnFolder => vec![ErrorRemedy::SetHome],
        }
    }

    /// What the checks said, where that is the reason.
    pub fn report(&self) -> Option<&PlanReport> {
        match self {
            Self::Planning(error) => error.report(),
            _ => None,
        }
    }
}
