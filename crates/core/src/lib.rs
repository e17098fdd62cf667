//! The pure pipeline of WireBend-kit: wireframe → route → program → schedule → compensated program.
//!
//! Each stage is a function from a value and its settings to a value; nothing here reads a file,
//! knows the time or the name of a machine. Positions are millimetres in a right-handed frame.

pub mod bend;
pub mod checks;
pub mod compensate;
pub mod curve;
pub mod estimate;
pub mod mesh;
pub mod plan;
pub mod route;
pub mod schedule;
pub mod simulate;
#[cfg(test)]
mod testing;
pub mod units;
pub mod wireframe;
