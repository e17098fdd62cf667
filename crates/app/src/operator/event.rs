//! What an operator tells.

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_driver_host::StoppedBy;

use super::order::Answer;
use super::state::MachineState;
use crate::{Doubt, Move, News, RunResponse};

/// Hears what an operator tells.
pub trait OperatorListener: Send + Sync {
    /// Called from the operator's thread, which waits for it: it has to come back at once. It may give orders.
    fn hear(&self, event: &OperatorEvent);
}

impl<F: Fn(&OperatorEvent) + Send + Sync> OperatorListener for F {
    fn hear(&self, event: &OperatorEvent) {
        self(event);
    }
}

/// Something that an operator tells.
#[derive(Debug, Clone, Serialize, JsonSchema)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum OperatorEvent {
    /// How everything stands. Sent when anything of it has changed but the position and the figures of the wire,
    /// which come as news and are in the next state besides.
    State(Box<MachineState>),
    /// Something that happened on the machine.
    News(News),
    /// A person is asked; nothing moves before they have answered.
    Question(Question),
    /// A question is not open any more.
    Answered {
        /// Which.
        id: u64,
        /// What counts as the answer: no, where it was withdrawn.
        answer: Answer,
    },
    /// A move by hand was made to its end.
    Jogged {
        /// The move.
        made: Move,
    },
    /// What became of a wire.
    RunEnded(Box<RunResponse>),
    /// A stop that was asked for is over.
    Stopped {
        /// Who brought it about.
        by: StoppedBy,
        /// Whether the driver was ended for it, or had ended before: then the machine has to be connected anew.
        driver_ended: bool,
        /// From the call to its end, ms.
        took_ms: u64,
    },
    /// Something failed, or was refused.
    Problem {
        /// A name that stays.
        code: String,
        /// What happened and what to do.
        message: String,
    },
}

/// What a person is asked.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Question {
    /// Its number, for the answer.
    pub id: u64,
    /// What it is about.
    pub kind: QuestionKind,
    /// What they have to know: lines to read.
    pub lines: Vec<String>,
    /// The question.
    pub question: String,
    /// The step that it is about, where nobody knows whether that was made.
    pub doubt: Option<Doubt>,
    /// What can be said of where the head stands, where it is about that.
    pub head: Option<HeadAsked>,
}

/// What can be said of where the head stands, degrees from where its cable is unwound.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct HeadAsked {
    /// The least and the most.
    pub range_deg: [f64; 2],
    /// Where it was left; null where nobody knows.
    pub left_at_deg: Option<f64>,
}

/// What a question is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum QuestionKind {
    /// Whether the machine may home or be moved by hand.
    Move,
    /// Whether a wire may be made once it is started.
    Arm,
    /// Whether a machine that holds, or a wire that was interrupted, may go on.
    GoOn,
    /// Whether a step was made.
    Doubt,
    /// Whether what was said of an interrupted wire before is so.
    Said,
    /// Where the head stands.
    Head,
    /// Whether settings may be written to the machine, for good.
    Settings,
}
