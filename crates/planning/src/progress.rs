//! How far long work is.

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_core::search;

/// What a search for programs without collisions has found until now, for the part of the design that it searches.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct FoundSoFar {
    /// Which part it is, from 1.
    pub part: usize,
    /// How many parts the design has.
    pub parts: usize,
    /// The best program; null where none without collisions is found.
    pub best: Option<BestSoFar>,
}

/// A program for a part of the design.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct BestSoFar {
    /// How many wires it has.
    pub wires: usize,
    /// The length of the edges that the wires run along again, mm.
    pub doubled_mm: f64,
}

impl From<search::BestSoFar> for BestSoFar {
    fn from(search::BestSoFar { wires, doubled }: search::BestSoFar) -> Self {
        Self { wires, doubled_mm: doubled.mm() }
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
    /// A search for programs without collisions has begun with a part, or has found a better one for it. What it says is over when
    /// another stage or search begins.
    fn found(&self, _found: FoundSoFar) {}
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
