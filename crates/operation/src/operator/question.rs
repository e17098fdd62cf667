//! What a person is asked.

use schemars::JsonSchema;
use serde::Serialize;

use crate::Doubt;

/// What a person is asked.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Question {
    /// Its number, for the answer.
    pub id: u64,
    /// What it is about.
    pub kind: QuestionKind,
    /// What they have to know: lines to read.
    pub lines: Vec<String>,
    pub question: String,
    /// The step that it is about, where it is not known whether that was done.
    pub doubt: Option<Doubt>,
    /// What can be said of where the head stands, where it is about that.
    pub head: Option<HeadAsked>,
}

/// What can be said of where the head stands, degrees from where its cable is unwound.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct HeadAsked {
    /// The least and the most.
    pub range_deg: [f64; 2],
    /// Where it was left; null where that is not known.
    pub left_at_deg: Option<f64>,
}

/// What a question is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum QuestionKind {
    /// Whether the machine may home or be moved by hand.
    Move,
    /// Whether a wire may be bent once it is started.
    Arm,
    /// Whether the next of several pieces may be bent: the one before has to be cut off.
    Piece,
    /// Whether a machine that holds, or a wire that was interrupted, may resume.
    #[serde(rename = "go-on")]
    Resume,
    /// Whether what is to be done at a pause point is done, and the machine may go on.
    Pause,
    /// Whether a step was done.
    Doubt,
    /// Whether what was said of an interrupted wire before is so.
    Said,
    Head,
    /// Whether settings may be written to the machine, for good.
    Settings,
    /// Whether a typed line may be sent that may move or change something.
    Console,
}
