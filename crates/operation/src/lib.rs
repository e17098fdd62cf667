//! A connected machine: wires, moves by hand, recordings, resuming, and the records of what was bent.
//!
//! A client of the session of `wirebend-driver-host`. The caller is a [`FrontEnd`]: it hears what happens, asks a person,
//! and can stop the machine at any time.

#![allow(clippy::missing_errors_doc, clippy::must_use_candidate, reason = "not published")]

pub mod by_hand;
pub mod calibrate;
pub mod console;
mod error;
mod event;
mod front_end;
pub mod live;
pub mod machine_settings;
pub mod operator;
mod order;
mod pieces;
pub mod ports;
pub mod run;
pub mod runs;
pub mod simulate;

pub use by_hand::MovesFile;
pub use error::{HeadProblem, LiveProblem, OperationError, OperatorError};
pub use event::{Decided, Decision, Doubt, MachineEvent};
pub use front_end::{Cancellation, FrontEnd, Observer, Prompt, Wait, Wish};
pub use live::Answers;
pub use operator::{
    ConnectRequest, HeadAsked, MachineState, Operator, OperatorEvent, OperatorListener, Question,
    QuestionKind, Unfinished, WireState,
};
pub use order::{Answer, Move, Order};
pub use pieces::{PiecesReport, Repeat};
pub use run::{LeftBecause, RunHow, RunOutcome, RunRequest, RunResponse, StoppedIn, WireRun};
pub use runs::{Outcome, PartInWire, Record, ToldBy};
pub use wirebend_driver_host::jobs::Piece;
pub use wirebend_driver_host::{Because, OrderName, Phase, RefusedOrder};
