//! Pensa D.I.Wire script: `FEED 59.70871`, `ROTATE -133.78622`, `BEND -46.45666`, `(comment)`.
//!
//! No header and no footer; a program that ends on a feed, as ours do, ends on FEED.

use std::fmt::Write as _;

use wirebend_core::bend::{Convention, Step};

use super::number::{fixed, is_zero};

/// How the commands are spelled.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Case {
    /// `FEED`.
    #[default]
    Upper,
    /// `feed`.
    Lower,
    /// `Feed`.
    Title,
}

impl Case {
    fn spell(self, command: &str) -> String {
        match self {
            Self::Upper => command.to_owned(),
            Self::Lower => command.to_lowercase(),
            Self::Title => format!("{}{}", &command[..1], command[1..].to_lowercase()),
        }
    }
}

/// How a script is written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PensaLayout {
    /// Digits behind the decimal point.
    pub decimals: usize,
    /// Comments for the first lines; none for machines that do not read them. Parentheses in them
    /// become brackets, line ends blanks.
    pub comments: Vec<String>,
    /// How the commands are spelled.
    pub case: Case,
    /// How the machine counts its axes.
    pub convention: Convention,
}

impl Default for PensaLayout {
    /// Five decimals, upper case, no comments.
    fn default() -> Self {
        Self { decimals: 5, comments: Vec::new(), case: Case::Upper, convention: Convention::default() }
    }
}

/// Writes a script. Every feed is written; rotations and bends of zero are not.
#[must_use]
pub fn pensa(steps: &[Step], layout: &PensaLayout) -> String {
    let mut text = String::new();
    for comment in &layout.comments {
        let comment = comment.replace('(', "[").replace(')', "]").replace(|c: char| c.is_control(), " ");
        let _ = writeln!(text, "({comment})");
    }
    for step in steps.iter().map(|step| layout.convention.apply(*step)) {
        let _ = writeln!(text, "{} {}", layout.case.spell("FEED"), fixed(step.feed.mm(), layout.decimals));
        for (command, angle) in [("ROTATE", step.rotate), ("BEND", step.bend)] {
            let angle = fixed(angle.deg(), layout.decimals);
            if !is_zero(&angle) {
                let _ = writeln!(text, "{} {angle}", layout.case.spell(command));
            }
        }
    }
    text
}
