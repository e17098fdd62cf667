//! Why a driver does not do what it was asked.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A refusal, for a person to read and for a program to tell apart.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema, thiserror::Error)]
#[error("{message}")]
#[schemars(deny_unknown_fields)]
pub struct DriverError {
    /// A name of lower-case letters, digits and hyphens that stays the same while the wording may change.
    pub code: String,
    /// What is wrong: which key, line or step, and what was expected.
    pub message: String,
    /// What to do about it.
    #[serde(default)]
    pub help: String,
}

impl DriverError {
    /// A refusal.
    pub fn new(code: &str, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self { code: code.to_owned(), message: message.into(), help: help.into() }
    }

    /// Whether the driver failed in this call or in an earlier one, rather than refused.
    #[must_use]
    pub fn has_panicked(&self) -> bool {
        [Self::PANIC, Self::PANICKED].contains(&self.code.as_str())
    }

    /// The code of a refusal that was a panic.
    pub(crate) const PANIC: &'static str = "panic";
    /// The code of refusals after one.
    pub(crate) const PANICKED: &'static str = "panicked";

    /// The code of the refusal of a console line that may change something, without a person's confirmation. Since 1.7.
    pub const NOT_A_QUESTION: &'static str = "not-a-question";

    /// A console line may move the machine or change what it has stored, and nobody has confirmed that.
    #[must_use]
    pub fn not_a_question(line: &str) -> Self {
        Self::new(
            Self::NOT_A_QUESTION,
            format!("'{line}' may move the machine or change its settings"),
            "confirm that it may",
        )
    }

    /// What the driver or its machine cannot do at all.
    #[must_use]
    pub fn unsupported(what: &str) -> Self {
        Self::new(
            "unsupported",
            format!("this driver cannot {what}"),
            "see the capabilities that it describes",
        )
    }

    /// A format that the driver does not write.
    #[must_use]
    pub fn unknown_format(format: &str, known: &[&str]) -> Self {
        let known = known.join(", ");
        Self::new(
            "unknown-format",
            format!("'{format}' is not a format of this driver"),
            format!("known: {known}"),
        )
    }

    /// A program was asked for of a wire, by its index from 0, that the checks let no program be made of.
    #[must_use]
    pub fn no_machine_steps(wire: usize) -> Self {
        let message = format!("wire {} has no steps for a machine: it could not be compensated", wire + 1);
        Self::new("no-machine-steps", message, "see what the checks say")
    }
}
