//! Jobs that survive anything: a journal of what was asked and made, what may be done after an interruption,
//! and the loop that makes a wire.
//!
//! Enter at [`Journal::create`] for a new wire and at [`Journal::open`] for one that was interrupted; a
//! [`JobRun`] takes a session and a journal and makes the wire step by step, at a pace that its caller gives by
//! calling [`JobRun::advance`]. Nothing in here waits, and nothing moves without a [`Confirmed`](crate::Confirmed).
//!
//! What is sent is written down first, and is on the disk before the driver hears of it; what is reported is
//! written down when it is heard. So whatever is cut off (the program, the cable, the power), the steps that were
//! sent and not reported are those of which nobody knows whether they were made. [`Resume::decide`] says what
//! that means; nothing is made again by itself.

mod account;
mod clock;
mod ending;
mod error;
mod feed;
mod journal;
mod pace;
mod part;
mod progress;
mod record;
mod resume;
mod run;
mod work;

pub use account::{Account, Part, PartMade, Standing};
pub use clock::{Clock, SystemClock, stamped};
pub use error::JobError;
pub use journal::{Entry, Heading, Journal, JournalError, ToldBy, What, Written};
pub use part::{Doubtful, Verdict};
pub use progress::{Overview, Progress};
pub use record::{Decision, Interruption, Outcome, PartInWire, Record};
pub use resume::{Contradiction, ContradictionKind, Resume, Settled};
pub use run::JobRun;
pub use work::Work;

#[cfg(test)]
mod tests;
