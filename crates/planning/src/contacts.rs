//! The search for contacts of a wire, shared by the processors of the computer, and how far a wire has to stay from what it could
//! hit.

use std::collections::BTreeMap;
use std::num::NonZero;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use wirebend_core::clearance::{Clearance, FirstContact};
use wirebend_error::InputName;
use wirebend_files::document;

use crate::PlanningError;
use crate::report::NoteReport;

/// So many steps are looked at in one go: few, so that all are done at about the same time.
const STEPS: usize = 12;
/// More do not help: what is shared out has to be set up by each.
const MAX_THREADS: usize = 4;

/// A person who arms a machine, or writes a file, waits no longer for the search.
pub(crate) const PATIENCE: Duration = Duration::from_secs(10);

/// How far a wire has to stay from what it could hit, given in mm.
pub fn collision_margin(mm: f64) -> Result<document::Clearance, PlanningError> {
    document::Clearance::try_from(mm).map_err(|_| PlanningError::Value {
        input: Some(InputName::Clearance),
        name: "the clearance",
        value: format!("{mm} mm"),
        expected: "zero or more",
    })
}

/// A search that was not ended is no clean bill.
pub(crate) fn not_searched(done: usize, of: usize) -> NoteReport {
    NoteReport {
        code: "collisions-not-searched".into(),
        count: of.saturating_sub(done),
        message: not_searched_text(done, of),
        remedies: Vec::new(),
    }
}

pub(crate) fn not_searched_text(done: usize, of: usize) -> String {
    format!("collisions not fully searched: {done} of {of} steps in {} s", PATIENCE.as_secs())
}

/// What a search found, and whether it came to its end.
pub struct Searched {
    pub contacts: Vec<FirstContact>,
    pub whole: bool,
}

/// The first contacts of a wire, as [`Clearance::first_contacts`] has them. `goes_on` is asked again and again, with how many steps are
/// done; where it does not, the contacts are those of the parts of the wire that were looked at by then.
pub fn first_contacts(clearance: &Clearance, mut goes_on: impl FnMut(usize) -> bool) -> Searched {
    let search = Search::default();
    let parts = clearance.steps().div_ceil(STEPS);
    let others = std::thread::available_parallelism().map_or(1, NonZero::get).min(MAX_THREADS).min(parts);
    std::thread::scope(|scope| {
        for _ in 1..others {
            scope.spawn(|| search.take(clearance, || true));
        }
        // The caller's own thread asks whether it goes on.
        search.take(clearance, || goes_on(search.done.load(Ordering::Relaxed)));
    });
    let found = search.found.into_inner().unwrap_or_else(PoisonError::into_inner);
    Searched { contacts: clearance.merged(found.into_values()), whole: !search.stopped.into_inner() }
}

/// What the threads share.
#[derive(Default)]
struct Search {
    next: AtomicUsize,
    done: AtomicUsize,
    stopped: AtomicBool,
    /// By part of the wire, in its order.
    found: Mutex<BTreeMap<usize, Vec<FirstContact>>>,
}

impl Search {
    /// Looks at one part after the other until none is left.
    fn take(&self, clearance: &Clearance, mut goes_on: impl FnMut() -> bool) {
        let mut clearance = clearance.clone();
        loop {
            let part = self.next.fetch_add(1, Ordering::Relaxed);
            let from = part * STEPS;
            if from >= clearance.steps() {
                return;
            }
            let found = clearance.first_contacts_in(from..clearance.steps().min(from + STEPS), |_| {
                let goes_on = goes_on() && !self.stopped.load(Ordering::Relaxed);
                self.done.fetch_add(1, Ordering::Relaxed);
                goes_on
            });
            let Some(found) = found else {
                self.stopped.store(true, Ordering::Relaxed);
                return;
            };
            self.found.lock().unwrap_or_else(PoisonError::into_inner).insert(part, found);
        }
    }
}
