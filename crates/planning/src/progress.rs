//! How far long work is.

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_core::search;

/// The best program without collisions that a search has found for a part of the design until now.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct BestSoFar {
    /// How many wires it has.
    pub wires: usize,
    /// What they run along twice, mm.
    pub doubled_mm: f64,
}

impl From<search::BestSoFar> for BestSoFar {
    fn from(search::BestSoFar { wires, added }: search::BestSoFar) -> Self {
        Self { wires, doubled_mm: added.mm() }
    }
}

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
    /// What the search would end with, where that is free of collisions, has changed: another part has none yet.
    fn best(&self, _best: Option<BestSoFar>) {}
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
