//! Where the output of a command goes.

/// Where contents go that the application did not write to a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Contents {
    /// Nowhere: they were written, or not asked for.
    Written,
    StandardOutput,
}
