//! How a window hears how far long work is.

use std::cell::{Cell, RefCell};

use wirebend_operation::{Cancellation, Observer, Prompt};

use super::{WindowEvent, Work, Workspace};
use crate::{BestSoFar, Progress};

impl Workspace {
    pub(crate) fn reporter(&self, word: &'static str) -> ProgressReporter<'_> {
        ProgressReporter { workspace: self, word, stage: RefCell::default(), best: Cell::default() }
    }
}

/// Passes on how far long work is.
pub(crate) struct ProgressReporter<'a> {
    workspace: &'a Workspace,
    word: &'static str,
    stage: RefCell<String>,
    best: Cell<Option<BestSoFar>>,
}

impl ProgressReporter<'_> {
    fn report(&self, done: u64, of: u64) {
        let (ask, stage) = (self.word.to_owned(), self.stage.borrow().clone());
        self.workspace.emit(&WindowEvent::Work(Work { ask, stage, done, of, best: self.best.get() }));
    }
}

impl Progress for ProgressReporter<'_> {
    fn stage(&self, name: &str) {
        // What is asked while a person drags is over before it could be shown.
        if self.word != "check" {
            name.clone_into(&mut self.stage.borrow_mut());
            self.report(0, 0);
        }
    }

    fn advance(&self, done: u64, of: u64) {
        if self.word != "check" {
            self.report(done, of);
        }
    }

    // It is told with how far the search is.
    fn best(&self, best: Option<BestSoFar>) {
        self.best.set(best);
    }
}

// The user is not asked here: a machine that is connected has an operator for that.
impl Observer for ProgressReporter<'_> {}
impl Prompt for ProgressReporter<'_> {}
impl Cancellation for ProgressReporter<'_> {}
