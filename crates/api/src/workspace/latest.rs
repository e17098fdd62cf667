//! Which of several questions of a kind was asked last.

use std::sync::atomic::{AtomicU64, Ordering};

/// Which question of a kind was asked last: those of before are given up.
#[derive(Debug, Default)]
pub(super) struct Latest {
    last: AtomicU64,
}

impl Latest {
    /// Begins another one: those of before are stopped.
    pub(super) fn begin(&self) -> u64 {
        self.last.fetch_add(1, Ordering::Relaxed) + 1
    }

    pub(super) fn now(&self) -> u64 {
        self.last.load(Ordering::Relaxed)
    }

    pub(super) fn is_last(&self, asked: u64) -> bool {
        self.now() == asked
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A person who goes on dragging would wait for answers of places where nothing is any more.
    #[test]
    fn a_later_one_and_a_stop_end_the_one_before() {
        let checks = Latest::default();
        let first = checks.begin();
        assert!(checks.is_last(first));
        let search = checks.now();
        assert!(checks.is_last(search), "a search for fixes does not end the check that it is of");
        let second = checks.begin();
        assert!(!checks.is_last(first) && !checks.is_last(search) && checks.is_last(second));
    }
}
