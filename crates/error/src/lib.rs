//! What front ends go by after an error: its code, and what can be done about it as data.
//!
//! An error states a fact. What a person does next is a [`ErrorRemedy`], which the command line words with its options and the
//! window with its buttons. All rooms share this one list, so that each of them can say what its own errors ask for.

mod code;
mod input;
mod remedy;
mod report;

pub use code::ErrorCode;
pub use input::InputName;
pub use remedy::{ErrorRemedy, RunTarget};
pub use report::ProblemReport;
