//! Jobs that survive anything: a journal of what was asked and done, what may be done after an interruption,
//! and the loop that runs a wire.
//!
//! Enter at [`Journal::create`] for a new wire and at [`Journal::open`] for one that was interrupted; a
//! [`JobRun`] takes a session and a journal and runs the wire step by step, at a pace that its caller gives by
//! calling [`JobRun::advance`]. Nothing in here waits, and nothing moves without a [`Permit`](crate::Permit).
//!
//! What is sent is written down first, and is on the disk before the driver hears of it; what is reported is
//! written down when it is heard. So whatever is cut off (the program, the cable, the power), the steps that were
//! sent and not reported are in doubt: it is not known whether they were done. [`Resume::decide`] says what
//! that means; nothing is bent again by itself.

mod clock;
mod entry;
mod error;
mod journal;
mod journal_state;
mod part;
mod progress;
mod record;
mod resume;
mod run;
mod time_estimator;
mod wire_job;
mod work_time;

pub use clock::{Clock, SystemClock, is_day, stamp_to_ms, stamped};
pub use entry::{Entry, EntryKind, Heading, Piece, ToldBy};
pub use error::JobError;
pub use journal::{Journal, JournalError, Written};
pub use journal_state::{JobState, JournalState};
pub use part::{Doubtful, Part, PartMade, StepOutcome};
pub use progress::{Overview, Progress};
pub use record::{ConfirmedPause, Decision, Interruption, Outcome, PartInWire, Record};
pub use resume::{Contradiction, ContradictionKind, Resume, Settled};
pub use run::JobRun;
pub use wire_job::{PauseAfter, StepTime, WireJob};

#[cfg(test)]
mod tests;
