//! Why something that a window asked for came to nothing, as it is told to it.

use schemars::JsonSchema;
use serde::Serialize;

use crate::{AppError, DiagnosticReport, ErrorKind};

/// Why something came to nothing. A window shows the message and may go by the code; it never compares texts.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Refusal {
    /// A name that stays the same while the wording may change.
    pub code: String,
    /// Whose turn it is.
    pub kind: ErrorKind,
    /// What is wrong, where, and what to do.
    pub message: String,
    /// What the checks say, where that is the reason.
    pub diagnostics: Vec<DiagnosticReport>,
}

impl From<&AppError> for Refusal {
    fn from(error: &AppError) -> Self {
        let report = error.report();
        let of_wires = report.iter().flat_map(|report| report.wires()).flat_map(|wire| &wire.diagnostics);
        let of_design = report.iter().flat_map(|report| report.diagnostics());
        Self {
            code: error.code().to_owned(),
            kind: error.kind(),
            message: error.to_string(),
            diagnostics: of_design.chain(of_wires).cloned().collect(),
        }
    }
}

impl Refusal {
    /// Something that failed in this program.
    #[must_use]
    pub fn failure(message: String) -> Self {
        Self { code: "failure".to_owned(), kind: ErrorKind::Failure, message, diagnostics: Vec::new() }
    }

    /// Something that could not be understood as something to ask for.
    #[must_use]
    pub fn not_asked_well(error: &serde_json::Error) -> Self {
        Self {
            code: "ask".to_owned(),
            kind: ErrorKind::Usage,
            message: format!("this is nothing that can be asked for: {error}"),
            diagnostics: Vec::new(),
        }
    }
}
