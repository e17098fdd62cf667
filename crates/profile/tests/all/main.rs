//! The integration tests of this crate, one binary for all.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a test may stop at what cannot be

mod any_text;
mod authoring;
mod inheritance;
mod refusals;
mod schema_files;
mod shipped;
mod strut_builders;
