//! The integration tests of this crate, one binary for all.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a test may stop at what cannot be

mod chains;
mod edits;
mod exact;
mod marks;
mod outcomes;
mod path_and_program;
mod physics;
mod routes;
mod shapes;
mod trusses;
