//! What is done with profiles themselves: checked, explained, written.

pub mod check;
pub mod explain;
pub mod new;
pub mod set;
pub mod springback;
