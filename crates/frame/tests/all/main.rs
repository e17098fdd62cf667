//! Frames against figures of other programs, theory, and what has to hold for any frame.

#![allow(clippy::expect_used, clippy::panic, reason = "tests")]

mod element;
mod flexibility;
mod frames;
mod modes;
mod properties;
mod published;
mod refusals;
mod trusses;
