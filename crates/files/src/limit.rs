//! How much a file may hold.

/// The most vertices, faces, edges or steps that a file may hold.
pub(crate) const LIMIT: usize = 5_000_000;
