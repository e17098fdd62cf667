//! Live machines: from a profile and a port to a machine that has answered, and a person's word before it moves.

mod connect;
mod connection;
mod head;
mod observer;
mod person;
mod refused;
mod settle_head;
mod standstill;
mod under_way;

pub use connect::{At, Reattached, Unnamed, connect};
pub use connection::{Connection, home};
pub use head::{HeadQuestion, QUESTION as HEAD_QUESTION};
pub use observer::MachineObserver;
pub use person::{Answers, Zero, ask_permit};
pub(crate) use refused::refused;
pub use refused::{PAUSE, stop_of};
pub use standstill::{StopWatch, await_standstill};
