//! What is done with profiles themselves: checked, explained, written, changed and passed on.

mod bodies;
pub mod check;
pub mod explain;
pub mod head;
pub mod history;
pub mod new;
mod own;
pub mod revert;
pub mod set;
pub mod share;
pub mod springback;
pub mod torque;

pub(crate) use own::OwnProfile;
