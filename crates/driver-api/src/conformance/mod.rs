//! Does a driver keep the rules? The same checks for a driver's own tests and for a compiled library.
//!
//! In the tests of a driver in Rust:
//!
//! ```text
//! #[test]
//! fn keeps_the_rules() {
//!     wirebend_driver_api::conformance::assert_kept::<MyDriver>();
//! }
//! ```
//!
//! For a library in any language: `wirebend driver check LIBRARY`.

mod describing;
mod exporting;
mod limiting;
mod moving;
mod opening;
mod sample;
mod subject;

use std::fmt;

use schemars::JsonSchema;
use serde::Serialize;

use crate::Description;
pub use sample::{job as sample_job, mirrored as mirrored_job};
pub use subject::{Broken, Subject};

/// What became of one rule.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Finding {
    /// The rule, as a sentence about the driver.
    pub rule: String,
    /// What is wrong; absent when the rule is kept.
    pub broken: Option<String>,
}

/// What became of all rules that concern a driver.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, JsonSchema)]
pub struct Conformance {
    /// In the order in which they were tried; what a broken rule makes pointless is left out.
    pub findings: Vec<Finding>,
}

impl Conformance {
    /// Whether every rule that was tried is kept.
    #[must_use]
    pub fn kept(&self) -> bool {
        !self.findings.is_empty() && self.findings.iter().all(|finding| finding.broken.is_none())
    }

    /// Notes what became of a rule, and whether it is kept.
    fn note(&mut self, rule: impl Into<String>, outcome: Result<(), String>) -> bool {
        let broken = outcome.err();
        let kept = broken.is_none();
        self.findings.push(Finding { rule: rule.into(), broken });
        kept
    }
}

impl fmt::Display for Conformance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for Finding { rule, broken } in &self.findings {
            match broken {
                None => writeln!(f, "kept    {rule}")?,
                Some(what) => writeln!(f, "BROKEN  {rule}\n        {what}")?,
            }
        }
        Ok(())
    }
}

/// Tries every rule that concerns a driver.
pub fn check(subject: &mut dyn Subject) -> Conformance {
    let mut found = Conformance::default();
    let Some(description) = describing::check(subject, &mut found) else {
        return found;
    };
    if opening::check(subject, &mut found) {
        exporting::check(subject, &description, &mut found);
        limiting::check(subject, &description, &mut found);
        moving::check(subject, &description, &mut found);
    }
    found.note("closes without being open", subject.close().map_err(|broken| broken.0));
    found
}

/// Tries every rule on a driver in this process, through its C table.
///
/// # Panics
/// When a rule is broken, with all findings.
pub fn assert_kept<D: crate::MachineDriver>() {
    let found = check(&mut subject::InProcess::new::<D>());
    assert!(found.kept(), "\n{found}");
}

/// The description that a subject gives, where it gives one.
fn described(subject: &mut dyn Subject) -> Result<Description, String> {
    let bytes = subject::done(subject.describe())?;
    serde_json::from_slice(&bytes).map_err(|error| format!("the description cannot be read: {error}"))
}
