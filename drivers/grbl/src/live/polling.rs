//! When the machine is asked for a report, and what the answers are worth.

use std::time::Duration;

/// At most five times a second: more often grbl's own work suffers.
const OFTEN: Duration = Duration::from_millis(200);
/// While nothing happens.
const SELDOM: Duration = Duration::from_secs(1);
/// An answer takes 5 to 20 ms, and a dwell delays it by 50 ms at most.
const PATIENCE: Duration = Duration::from_secs(1);
/// So many answers may be missing in a row.
const MAX_MISSING: u32 = 3;

/// The question that is under way, and those that were not answered.
#[derive(Debug, Default)]
pub(crate) struct StatusPoller {
    asked_at: Option<Duration>,
    /// Whether the question that is under way has not been answered.
    open: bool,
    /// Whether no line was under way when it was asked, and none has been sent since.
    fresh: bool,
    missing: u32,
    /// Answers that may be late ones.
    late: u32,
}

/// What is to be done now.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PollAction {
    Ask,
    Wait,
    /// The machine does not answer any more.
    Silent,
}

impl StatusPoller {
    /// Looks at the clock. `busy`: something is under way. `at_rest`: no line is waiting to be answered.
    pub fn next_action(&mut self, now: Duration, busy: bool, at_rest: bool) -> PollAction {
        let since = self.asked_at.map_or(SELDOM, |asked| now.saturating_sub(asked));
        if self.open {
            if since < PATIENCE {
                return PollAction::Wait;
            }
            self.open = false;
            self.missing += 1;
            self.late += 1;
            if self.missing >= MAX_MISSING {
                return PollAction::Silent;
            }
        }
        if since < if busy { OFTEN } else { SELDOM } {
            return PollAction::Wait;
        }
        (self.asked_at, self.open, self.fresh) = (Some(now), true, at_rest);
        PollAction::Ask
    }

    /// A report has come. Whether it is the answer to a question that was asked when every line had been
    /// answered. Any other may show the state before a line that was taken since.
    pub fn answered(&mut self) -> bool {
        let counts = self.open && self.fresh && self.late == 0;
        self.late = self.late.saturating_sub(1);
        self.open = false;
        self.missing = 0;
        counts
    }

    /// A line is sent, or the state changes otherwise: the answer under way is of the time before.
    pub const fn outdated(&mut self) {
        self.fresh = false;
    }

    /// The machine has begun anew, and with it the questions. The next one is asked at once.
    pub fn restart(&mut self) {
        *self = Self::default();
    }

    /// No question can be answered for a while: none is missing.
    pub fn pause(&mut self, now: Duration) {
        *self = Self { asked_at: Some(now), ..Self::default() };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const fn ms(ms: u64) -> Duration {
        Duration::from_millis(ms)
    }

    #[test]
    fn it_asks_five_times_a_second_at_most() {
        let mut poller = StatusPoller::default();
        let mut asked = 0;
        for now in 0..1000 {
            if poller.next_action(ms(now), true, true) == PollAction::Ask {
                asked += 1;
                poller.answered();
            }
        }
        assert_eq!(asked, 5);
        assert_eq!(poller.next_action(ms(1700), false, true), PollAction::Wait);
        assert_eq!(poller.next_action(ms(1800), false, true), PollAction::Ask);
    }

    #[test]
    fn an_answer_counts_only_when_it_was_asked_for_at_rest() {
        let mut poller = StatusPoller::default();
        assert_eq!(poller.next_action(ms(0), true, false), PollAction::Ask);
        assert!(!poller.answered());
        assert_eq!(poller.next_action(ms(200), true, true), PollAction::Ask);
        assert!(poller.answered());
        // It was not asked for.
        assert!(!poller.answered());
        assert_eq!(poller.next_action(ms(400), true, true), PollAction::Ask);
        poller.outdated();
        assert!(!poller.answered());
    }

    #[test]
    fn an_answer_after_a_missing_one_may_be_the_late_one() {
        let mut poller = StatusPoller::default();
        assert_eq!(poller.next_action(ms(0), true, true), PollAction::Ask);
        assert_eq!(poller.next_action(ms(1000), true, true), PollAction::Ask);
        assert!(!poller.answered());
        assert_eq!(poller.next_action(ms(1200), true, true), PollAction::Ask);
        assert!(poller.answered());
    }

    #[test]
    fn three_missing_answers_are_silence() {
        let mut poller = StatusPoller::default();
        let turns: Vec<PollAction> = (0..=3000).map(|now| poller.next_action(ms(now), true, true)).collect();
        assert_eq!(turns.iter().filter(|turn| **turn == PollAction::Ask).count(), 3);
        assert_eq!(turns[3000], PollAction::Silent);
    }
}
