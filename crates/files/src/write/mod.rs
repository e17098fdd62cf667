//! Writers: values in, text out. One file a format; nothing here opens a file.
//!
//! Programs of machines are written by their drivers. Lengths are mm, angles degrees.

mod centreline;
mod number;
mod obj;
mod svg;

pub use centreline::{Centreline, centreline};
pub use obj::{Tube, obj};
pub use svg::{Mark, MarkAt, Picture, PictureWire, Severity, View, svg};
