//! A person's yes, and where it comes from.

use wirebend_driver_host::{Asked, Confirmed};

use super::LiveProblem;
use crate::{News, Progress};

/// A person has said that a machine may move. It can only be had by asking; each act takes a part of it.
pub(crate) struct Yes {
    question: String,
}

impl Yes {
    /// Tells what will happen and asks. `confirmed`: the person has said it with the request already.
    pub fn ask(
        progress: &dyn Progress,
        lines: Vec<String>,
        question: &str,
        confirmed: bool,
    ) -> Result<Self, LiveProblem> {
        progress.news(&News::About { lines });
        let said = if confirmed { Some(true) } else { progress.confirm(question) };
        match said {
            Some(true) => Ok(Self { question: question.to_owned() }),
            Some(false) => Err(LiveProblem::Declined),
            None => Err(LiveProblem::NotConfirmed),
        }
    }

    /// Nobody has to be asked where nothing moves, such as on a simulated machine.
    pub fn where_nothing_moves() -> Self {
        Self { question: "may nothing move?".to_owned() }
    }

    /// What the session takes.
    pub fn confirmed(&self) -> Result<Confirmed, LiveProblem> {
        // The person has answered this very question.
        Confirmed::by(&Asked { question: self.question.clone() }, |_| true).ok_or(LiveProblem::NotConfirmed)
    }
}

/// What zero is wanted for, on a machine whose axes a person brings there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Zero {
    /// For a wire, or the rest of one, or moves that were recorded: all of it counts from there.
    Wire,
    /// For moves by hand, such as those that bring the axes to zero.
    Moves,
}

impl Zero {
    /// What a person has to know before they answer.
    pub fn lines(self) -> Vec<String> {
        let taken = "this machine has no switches, and nothing moves for this: the place where the axes stand now is taken as zero";
        let more = match self {
            Self::Wire => {
                "turn the head to its zero mark, and bring the bend axis to its zero: by hand with the motors off, or by jogging before"
            }
            Self::Moves => "before a wire you are asked again whether every axis stands at zero",
        };
        vec![taken.to_owned(), more.to_owned()]
    }

    /// The question.
    pub const fn question(self) -> &'static str {
        match self {
            Self::Wire => "Does every axis stand at zero?",
            Self::Moves => "May these moves count from where the axes stand now?",
        }
    }
}
