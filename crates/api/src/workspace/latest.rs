//! Which of several questions of a kind was asked last.

use std::cell::Cell;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use wirebend_planning::report::DiagnosticCode;

use crate::{FoundSoFar, Progress};

/// From one report to the next.
const BETWEEN: Duration = Duration::from_millis(100);

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

/// How far what was asked is, until a person has had enough, or asks again.
pub(super) struct Search<'a> {
    pub progress: &'a dyn Progress,
    pub searches: &'a Latest,
    pub own: u64,
    /// When the next report is due.
    pub next: Cell<Option<Instant>>,
}

impl Progress for Search<'_> {
    fn stage(&self, name: &str) {
        self.progress.stage(name);
    }

    fn advance(&self, done: u64, of: u64) {
        let now = Instant::now();
        if self.next.get().is_none_or(|next| now >= next) {
            self.next.set(Some(now + BETWEEN));
            self.progress.advance(done, of);
        }
    }

    fn found(&self, found: FoundSoFar) {
        self.progress.found(found);
    }

    fn goes_on(&self) -> bool {
        self.searches.is_last(self.own)
    }
}

/// The same for each kind of finding: a search for another kind goes on.
#[derive(Debug, Default)]
pub(super) struct LatestByCode {
    of: Mutex<BTreeMap<DiagnosticCode, Arc<Latest>>>,
}

impl LatestByCode {
    pub(super) fn of(&self, code: DiagnosticCode) -> Arc<Latest> {
        let mut of = self.of.lock().unwrap_or_else(PoisonError::into_inner);
        Arc::clone(of.entry(code).or_default())
    }

    /// Stops all.
    pub(super) fn stop(&self) {
        for latest in self.of.lock().unwrap_or_else(PoisonError::into_inner).values() {
            latest.begin();
        }
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

    #[test]
    fn a_search_for_one_kind_leaves_that_for_another() {
        let searches = LatestByCode::default();
        let (short, sharp) = (DiagnosticCode::EdgeTooShort, DiagnosticCode::BendTooSharp);
        let (first, other) = (searches.of(short).begin(), searches.of(sharp).begin());
        let again = searches.of(short).begin();
        assert!(!searches.of(short).is_last(first) && searches.of(short).is_last(again));
        assert!(searches.of(sharp).is_last(other));
        searches.stop();
        assert!(!searches.of(short).is_last(again) && !searches.of(sharp).is_last(other));
    }
}
