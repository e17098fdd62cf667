//! A person's yes, and where it comes from.

use schemars::JsonSchema;
use serde::Deserialize;
use wirebend_driver_host::{Permit, PermitKind, Session};

use super::refused::refused;
use crate::FrontEnd;
use crate::MachineEvent;
use crate::error::LiveProblem;

/// What a person answers with the request itself, before they are asked.
#[derive(Debug, Clone, Copy, Default, Deserialize, JsonSchema)]
pub struct Answers {
    /// Whether the machine may move. In a job it counts for one wire: before the next, the user is asked. Of several pieces it counts
    /// for all on a simulated machine, where nothing has to be cut off, and is refused on a real one.
    #[serde(default)]
    pub confirmed: bool,
    /// Whether every axis stands at zero, for a machine without switches; for moves by hand, whether they may count from where
    /// the axes stand. It counts once.
    #[serde(default)]
    pub axes_at_zero: bool,
    /// Where the head stands, degrees from where its cable is unwound, as a person has seen it; absent, it stands where it
    /// was left, and where that is not known, the user is asked.
    #[serde(default)]
    pub head_at_deg: Option<f64>,
}

/// Shows the user what will happen, asks them, and gives what the session then permits. `confirmed`: they have said yes
/// with the request already.
pub fn ask_permit(
    session: &mut Session,
    front_end: &dyn FrontEnd,
    kind: PermitKind,
    lines: Vec<String>,
    question: &str,
    confirmed: bool,
) -> Result<Permit, LiveProblem> {
    front_end.event(&MachineEvent::About { lines });
    let request = session.ask(kind);
    let said = if confirmed { Some(true) } else { front_end.confirm(question) };
    match said {
        Some(true) => session
            .permit(request.confirm())
            .map_err(|error| refused(session, error, "a person was asked about it")),
        Some(false) => Err(LiveProblem::Declined),
        None => Err(LiveProblem::NotConfirmed),
    }
}

/// What zero is wanted for, on a machine whose axes a person brings there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Zero {
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

    pub const fn question(self) -> &'static str {
        match self {
            Self::Wire => "Does every axis stand at zero?",
            Self::Moves => "May these moves count from where the axes stand now?",
        }
    }
}
