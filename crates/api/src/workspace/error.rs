//! Why something that a window asked for came to nothing, as it is reported to it.

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_error::{ErrorCode, ErrorRemedy};
use wirebend_planning::text::shown;

use crate::{ApiError, DiagnosticReport, ErrorKind};

/// Why something came to nothing. A window shows the message and may go by the code; it never compares texts.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ApiErrorReport {
    /// A name that stays the same while the wording may change.
    pub code: ErrorCode,
    /// The kind of error.
    pub kind: ErrorKind,
    pub message: String,
    /// What can be done about it.
    pub remedies: Vec<ErrorRemedy>,
    /// What the checks say, where that is the reason.
    pub diagnostics: Vec<DiagnosticReport>,
}

impl From<&ApiError> for ApiErrorReport {
    fn from(error: &ApiError) -> Self {
        let report = error.report();
        let of_wires = report.iter().flat_map(|report| report.wires()).flat_map(|wire| &wire.diagnostics);
        let of_design = report.iter().flat_map(|report| report.diagnostics());
        Self {
            code: error.code(),
            kind: error.kind(),
            message: shown(|| error.to_string()),
            remedies: error.remedies(),
            diagnostics: of_design.chain(of_wires).cloned().collect(),
        }
    }
}

impl ApiErrorReport {
    /// Something that failed in this program.
    #[must_use]
    pub fn failure(message: String) -> Self {
        Self {
            code: ErrorCode::Failure,
            kind: ErrorKind::Failure,
            message,
            remedies: Vec::new(),
            diagnostics: Vec::new(),
        }
    }

    /// Something that could not be understood as something to ask for.
    #[must_use]
    pub fn not_asked_well(error: &serde_json::Error) -> Self {
        Self {
            code: ErrorCode::Ask,
            kind: ErrorKind::Usage,
            message: format!("invalid request: {error}"),
            remedies: Vec::new(),
            diagnostics: Vec::new(),
        }
    }
}
