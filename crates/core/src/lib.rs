//! The pure pipeline of WireBend-kit: wireframe → route → program → schedule → compensated program.
//!
//! Each stage is a function from a value and its settings to a value; nothing here reads a file, knows the time or the
//! name of a machine. Positions are millimetres in a right-handed frame; tolerances are parameters.
//!
//! **Facts, not prose.** A finding of the checks is a [`Fact`](checks::Fact) with its figures and its
//! [remedies](checks::Remedy) as values; it has no words. An error is an enum or a struct with its figures; its `Display`
//! is one technical line that says what is wrong, for logs, for tests, and for the errors of later rooms that wrap it. It
//! has no advice and no word of a front end. What a person reads of a finding, or of an error that a person can do
//! something about, is worded in one place, `wirebend-planning`'s `text`, by a match without a wildcard. Hence there is no
//! `format!` here, and no text of more than one word outside `#[error(…)]`.

#![deny(missing_docs)]

pub mod bend;
pub mod calibrate;
pub mod checks;
pub mod clearance;
pub mod compensate;
pub mod curve;
pub mod estimate;
pub mod mesh;
pub mod motion;
pub mod plan;
pub mod route;
pub mod sag;
pub mod schedule;
pub mod search;
pub mod simulate;
#[cfg(test)]
mod testing;
pub mod units;
pub mod wireframe;
