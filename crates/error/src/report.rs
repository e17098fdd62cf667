//! An error as a front end receives it.

use schemars::JsonSchema;
use serde::Serialize;

use crate::{ErrorCode, ErrorRemedy};

/// What failed, or is worth a warning.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ProblemReport {
    /// A name that stays the same while the wording changes. Drivers have names of their own.
    pub code: String,
    /// What is wrong, and where.
    pub message: String,
    /// What can be done about it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub remedies: Vec<ErrorRemedy>,
}

/// Errors with a code and remedies become reports. A function before them, as in `shown => MyError`, calls what words them.
#[macro_export]
macro_rules! reported {
    ($word:path => $($error:ty),* $(,)?) => {$(
        impl From<&$error> for $crate::ProblemReport {
            fn from(error: &$error) -> Self {
                Self::new(error.code(), $word(|| error.to_string()), error.remedies())
            }
        }
    )*};
    ($($error:ty),* $(,)?) => {$(
        impl From<&$error> for $crate::ProblemReport {
            fn from(error: &$error) -> Self {
                Self::new(error.code(), error.to_string(), error.remedies())
            }
        }
    )*};
}

impl ProblemReport {
    /// An error of the program's own.
    #[must_use]
    pub fn new(code: ErrorCode, message: String, remedies: Vec<ErrorRemedy>) -> Self {
        Self { code: code.as_str().to_owned(), message, remedies }
    }
}
