//! How far long work is.

/// Hears how far long work is. Called from the thread that does it.
pub trait Progress {
    /// A stage begins: a word or two for a person.
    fn stage(&self, name: &str);
    /// So many of so many things are done.
    fn advance(&self, done: u64, of: u64);
    /// A search begins, which may be ended with the best that it has; it is over when another stage begins.
    fn search(&self, name: &str) {
        self.stage(name);
    }
    /// Whether a search goes on; else it ends with the best that it has.
    fn goes_on(&self) -> bool {
        true
    }
}

/// Hears nothing.
#[derive(Debug, Clone, Copy, Default)]
pub struct NoProgress;

impl Progress for NoProgress {
    fn stage(&self, _name: &str) {}
    fn advance(&self, _done: u64, _of: u64) {}
}
