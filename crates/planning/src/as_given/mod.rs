//! What is run as it is given: the wires of a job as they were planned, and programs as they stand.

mod program;
mod wires;

pub use program::{ProgramMachine, job_of_file, job_of_moves};
pub use wires::GivenWires;
