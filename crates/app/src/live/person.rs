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
