//! A person's permit to move the machine by hand.

use std::time::{Duration, Instant};

use wirebend_driver_host::Permit;

/// How long after the last move a permit still holds. A user who jogs a machine looks at it, and each jog confirms that;
/// after a minute without one they may have left, or have their hands in it.
const HOLDS: Duration = Duration::from_mins(1);

/// A person has said that the machine may be moved by hand. It is taken out for each move and put back when that was
/// finished: so a stop and a failure end it, and a wire does, after which a person has their hands in the
/// machine.
pub(super) struct JogPermit<P = Permit> {
    permit: P,
    since: Instant,
}

impl<P> JogPermit<P> {
    pub fn new(permit: P, now: Instant) -> Self {
        Self { permit, since: now }
    }

    /// The permit, if it still holds.
    pub fn holds(self, now: Instant) -> Option<P> {
        (now.saturating_duration_since(self.since) < HOLDS).then_some(self.permit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Were it to hold for longer, a click by mistake would move a machine in which the user has their hands.
    #[test]
    fn a_jog_permit_holds_for_a_minute() {
        let begun = Instant::now();
        let permit = || JogPermit::new((), begun);
        assert!(permit().holds(begun + Duration::from_secs(59)).is_some());
        assert!(permit().holds(begun + Duration::from_mins(1)).is_none());
    }
}
