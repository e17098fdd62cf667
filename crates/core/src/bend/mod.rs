//! From a path to a program of feeds, rotations and bends, and back.
//!
//! A program is read by a turtle with the right-handed frame (t, n, b): feed along t, rotate the
//! frame right-handed about t, bend it right-handed about b (t towards n). Every step does these
//! three in that order, so the rotation sets the plane of the bend of its own step.

mod frame;
mod from_path;
mod program;
mod replay;
mod tangent;

pub use frame::Frame;
pub use from_path::{PathError, program_of_path};
pub use program::{Convention, NominalProgram, Sign, Step};
pub use replay::replay;
pub use tangent::{TangentError, intersection_lengths, straight_lengths};
