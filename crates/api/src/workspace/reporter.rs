//! How a window hears how far long work is.

use std::cell::{Cell, RefCell};

use wirebend_operation::{Cancellation, Observer, Prompt};

use super::{WindowEvent, Work, Workspace};
use crate::{FoundSoFar, Progress};

impl Workspace {
    pub(crate) fn reporter(&self, word: &'static str) -> ProgressReporter<'_> {
        ProgressReporter { workspace: self, word, stage: RefCell::default(), found: Cell::default() }
    }
}

/// Passes on how far long work is.
pub(crate) struct ProgressReporter<'a> {
    workspace: &'a Workspace,
    word: &'static str,
    stage: RefCell<String>,
    found: Cell<Option<FoundSoFar>>,
}

impl ProgressReporter<'_> {
    fn report(&self, done: u64, of: u64) {
        let (ask, stage) = (self.word.to_owned(), self.stage.borrow().clone());
        self.workspace.emit(&WindowEvent::Work(Work { ask, stage, done, of, found: self.found.get() }));
    }
}

impl Progress for ProgressReporter<'_> {
    fn stage(&self, name: &str) {
        // What is asked while a person drags is over before it could be shown.
        if self.word != "check" {
            name.clone_into(&mut self.stage.borrow_mut());
            self.found.set(None);
            self.report(0, 0);
        }
    }

    fn advance(&self, done: u64, of: u64) {
        if self.word != "check" {
            self.report(done, of);
        }
    }

    // Sent with the next report of how far the search is.
    fn found(&self, found: FoundSoFar) {
        self.found.set(Some(found));
    }
}

// The user is not asked here: a machine that is connected has an operator for that.
impl Observer for ProgressReporter<'_> {}
impl Prompt for ProgressReporter<'_> {}
impl Cancellation for ProgressReporter<'_> {}

#[cfg(test)]
mod tests {
    use std::sync::{Arc, Mutex};

    use super::*;
    use crate::{EventSink, Places};

    #[derive(Default)]
    struct Heard(Mutex<Vec<Work>>);

    impl EventSink for Heard {
        fn emit(&self, event: &WindowEvent) {
            if let WindowEvent::Work(work) = event {
                self.0.lock().unwrap().push(work.clone());
            }
        }
    }

    #[test]
    fn what_a_search_has_found_is_told_until_something_else_begins() {
        let heard = Arc::new(Heard::default());
        let workspace = Workspace::new(Places::default(), heard.clone()).unwrap();
        let reporter = workspace.reporter("avoid-collisions");
        let found = FoundSoFar { part: 1, parts: 2, best: None };
        reporter.search("searching");
        reporter.found(found);
        reporter.advance(1, 9);
        reporter.advance(2, 9);
        reporter.search("trying changes");
        reporter.advance(1, 4);
        reporter.stage("checking");
        let told: Vec<_> = heard.0.lock().unwrap().iter().map(|work| (work.done, work.found)).collect();
        let searching = [(0, None), (1, Some(found)), (2, Some(found))];
        assert_eq!(told, [&searching[..], &[(0, None), (1, None), (0, None)]].concat());
    }
}
