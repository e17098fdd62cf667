//! What a rule reports: where, what, why, and what to do about it.

use std::fmt;

/// One place that breaks a rule.
#[derive(Debug)]
pub(super) struct Finding {
    /// Path below the workspace root.
    pub(super) path: String,
    /// Line from 1.
    pub(super) line: usize,
    pub(super) what: String,
    pub(super) why: &'static str,
    pub(super) to_do: String,
    /// Shown, but does not fail the check.
    pub(super) only_report: bool,
}

impl Finding {
    pub(super) fn new(
        path: &str,
        line: usize,
        what: impl Into<String>,
        why: &'static str,
        to_do: impl Into<String>,
    ) -> Self {
        Self { path: path.to_owned(), line, what: what.into(), why, to_do: to_do.into(), only_report: false }
    }

    pub(super) fn into_report(self) -> Self {
        Self { only_report: true, ..self }
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let report = if self.only_report { "report: " } else { "" };
        write!(f, "{report}{}:{}: {}; {}; {}", self.path, self.line, self.what, self.why, self.to_do)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_as_place_what_why_what_to_do() {
        let finding = Finding::new("a/b.rs", 3, "what", "why", "what to do");
        assert_eq!(finding.to_string(), "a/b.rs:3: what; why; what to do");
        assert_eq!(finding.into_report().to_string(), "report: a/b.rs:3: what; why; what to do");
    }
}
