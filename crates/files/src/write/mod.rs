//! Writers: values in, text out. One file a format; nothing here opens a file.
//!
//! Programs are steps with feeds from corner to corner in the signs of the canonical program; the
//! convention of a layout says how the machine counts. Lengths are mm, angles degrees.

mod centreline;
mod kit;
mod number;
mod obj;
mod svg;

pub use centreline::{Centreline, centreline};
pub use kit::{KitLayout, kit};
pub use obj::{Tube, obj};
pub use svg::{Mark, MarkAt, Picture, PictureWire, Severity, View, svg};
