//! Frames to be measured with, those of the tests among them, and what others say of the same frames.

#![allow(clippy::unwrap_used, clippy::panic)] // a benchmark may stop at what cannot be
#![allow(missing_docs, clippy::must_use_candidate, clippy::missing_panics_doc, clippy::missing_errors_doc)] // of tests, and for the benchmarks alone

#[path = "../../../crates/sequence/tests/all/brute.rs"]
pub mod brute;
#[path = "../../../crates/sequence/tests/all/frames.rs"]
pub mod built;
pub mod models;
pub mod peer;
#[path = "../../../crates/accuracy/tests/all/truss.rs"]
pub mod truss;
