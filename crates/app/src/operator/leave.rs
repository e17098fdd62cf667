//! A person's leave to move the machine by hand.

use std::time::{Duration, Instant};

use crate::live::Yes;

/// How long after the last move a leave still holds. Who jogs a machine looks at it, and each jog is a word of theirs;
/// after a minute without one they may have gone away, or have their hands in it.
const HOLDS: Duration = Duration::from_mins(1);

/// A person has said that the machine may be moved by hand. It is taken out for each move and put back when that was
/// made to its end: so a stop and a failure end it, and a wire does, after which a person has their hands in the
/// machine.
pub(super) struct Leave {
    yes: Yes,
    since: Instant,
}

impl Leave {
    pub fn new(yes: Yes, now: Instant) -> Self {
        Self { yes, since: now }
    }

    /// The yes, if it still holds.
    pub fn holds(self, now: Instant) -> Option<Yes> {
        (now.saturating_duration_since(self.since) < HOLDS).then_some(self.yes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Were it to hold for longer, a click by mistake would move a machine in which somebody has their hands.
    #[test]
    fn a_leave_holds_for_a_minute() {
        let begun = Instant::now();
        let leave = || Leave::new(Yes::where_nothing_moves(), begun);
        assert!(leave().holds(begun + Duration::from_secs(59)).is_some());
        assert!(leave().holds(begun + Duration::from_mins(1)).is_none());
    }
}
