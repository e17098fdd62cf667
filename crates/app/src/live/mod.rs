//! Live machines: from a profile and a port to a machine that has answered, and a person's word before it moves.

mod connect;
mod head;
mod hearing;
mod news;
mod person;
mod problem;
mod standstill;
mod under_way;

pub(crate) use connect::{At, Connection, PAUSE, Unnamed, home, stop_of};
pub use head::HeadProblem;
pub(crate) use head::{HeadQuestion, QUESTION as HEAD_QUESTION};
pub(crate) use hearing::Hearing;
pub use news::{Decided, Decision, Doubt, News, PartOfStep};
pub(crate) use person::{Yes, Zero};
pub use problem::LiveProblem;
pub(crate) use problem::hard_stop;
pub(crate) use standstill::{StopWatch, await_standstill};
