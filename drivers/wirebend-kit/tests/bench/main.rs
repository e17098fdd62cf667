//! The bench against published measurements, hand calculation and other ways to the same result.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a test may stop at what cannot be

mod comparing;
mod compensation;
mod hand;
mod mishaps;
mod noise;
mod pressing;
mod properties;
mod published;
mod shape;
