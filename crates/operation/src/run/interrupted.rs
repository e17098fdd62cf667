//! A wire that was begun and is not over.

use std::path::Path;

use wirebend_driver_host::jobs::Journal;

/// A wire that is not over, with its journal.
pub struct Interrupted {
    pub(super) wire: usize,
    pub(super) id: String,
    pub(super) journal: Journal,
}

impl Interrupted {
    /// What the machine calls the session in which it may still be.
    pub fn token(&self) -> Option<&str> {
        self.journal.state().token.as_deref()
    }

    /// Its journal, opened by this caller alone.
    pub fn journal(&self) -> &Path {
        self.journal.path()
    }

    /// The port at which it was begun.
    pub fn begun_at(&self) -> String {
        self.journal.state().heading.port.clone()
    }

    /// What the design was called when it was begun.
    pub fn name(&self) -> String {
        self.journal.state().heading.name.clone()
    }

    /// Whether all of it is known to be done.
    pub fn is_made(&self) -> bool {
        self.made() == self.journal.state().heading.steps
    }

    /// The last step that is known to be done.
    pub fn made(&self) -> u32 {
        self.journal.state().done
    }
}
