//! The order in which struts are built, against what others published and what brute force finds.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a test may stop at what cannot be

mod brute;
mod confirm;
mod directions;
mod found;
mod frames;
mod groups;
mod held;
mod layers;
mod parts;
mod properties;
mod refused;
mod small;
