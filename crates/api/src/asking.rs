//! How a window asks.

use serde_json::value::RawValue;

use crate::{ApiErrorReport, Request, Workspace};

impl Workspace {
    /// Answers. Several may be asked at once, from several threads; those that work on the open design take turns. After
    /// a refusal the design is as it was.
    pub fn ask(&self, request: &Request) -> Result<Box<RawValue>, ApiErrorReport> {
        request.answer(self).map_err(|error| ApiErrorReport::from(&error))
    }

    /// The same as text: JSON with the name under `ask` beside what it needs.
    pub fn ask_json(&self, text: &str) -> Result<Box<RawValue>, ApiErrorReport> {
        let request: Request =
            serde_json::from_str(text).map_err(|error| ApiErrorReport::not_asked_well(&error))?;
        self.ask(&request)
    }

    /// The same as a value.
    pub fn ask_value(&self, value: serde_json::Value) -> Result<Box<RawValue>, ApiErrorReport> {
        let request: Request =
            serde_json::from_value(value).map_err(|error| ApiErrorReport::not_asked_well(&error))?;
        self.ask(&request)
    }
}
