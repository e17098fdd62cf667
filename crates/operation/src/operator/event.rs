//! What an operator reports.

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_driver_host::StoppedBy;
use wirebend_error::ProblemReport;

use super::question::Question;
use super::state::MachineState;
use crate::order::Answer;
use crate::{MachineEvent, Move, RunResponse};

/// Hears what an operator reports.
pub trait OperatorListener: Send + Sync {
    /// Called from the operator's thread, which waits for it: it has to come back at once. It may give orders.
    fn hear(&self, event: &OperatorEvent);
}

impl<F: Fn(&OperatorEvent) + Send + Sync> OperatorListener for F {
    fn hear(&self, event: &OperatorEvent) {
        self(event);
    }
}

/// Something that an operator reports.
#[derive(Debug, Clone, Serialize, JsonSchema)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum OperatorEvent {
    /// How everything stands. Sent when anything of it has changed but the position and the figures of the wire,
    /// which come as news and are in the next state besides.
    State(Box<MachineState>),
    /// Something that happened on the machine.
    #[serde(rename = "news")]
    Machine(MachineEvent),
    /// A person is asked; nothing moves before they have answered.
    Question(Question),
    /// A question is not open any more.
    Answered {
        id: u64,
        /// What counts as the answer: no, where it was withdrawn.
        answer: Answer,
    },
    /// A move by hand is done.
    Jogged { made: Move },
    /// What became of a wire.
    RunEnded(Box<RunResponse>),
    /// A stop that was asked for is over.
    Stopped {
        /// What caused it.
        by: StoppedBy,
        /// Whether the driver was ended for it, or had ended before: then the machine has to be connected anew.
        driver_ended: bool,
        /// From the call to its end, ms.
        took_ms: u64,
    },
    /// Something failed, or was refused.
    Problem(ProblemReport),
}
