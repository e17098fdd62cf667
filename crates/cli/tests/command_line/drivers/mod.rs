//! Drivers on the command line: found, checked, trusted, refused, with their settings and limits.

mod in_c;
mod inherited;
pub(crate) mod limits;
mod own;
mod refused;
mod settings;
