//! The integration tests of this crate, one binary for all.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a test may stop at what cannot be

mod joins;
mod pairs;
