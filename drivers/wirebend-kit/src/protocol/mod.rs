//! The wire protocol, from the host's side: frames, their codes, and what they say.

mod codes;
mod frame;
mod reply;

pub use codes::{Alarm, Command, Machine, Refusal, Reply, Reset, SETTINGS, Setting, State};
pub use frame::{Line, Lines, NO_SESSION, STOP, sealed};
pub use reply::{ReplyFrame, Status, Versions};

/// The version of the protocol that this driver speaks.
pub const VERSION: u32 = 1;
