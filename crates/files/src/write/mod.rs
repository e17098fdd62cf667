//! Writers: values in, text out. One file a format; nothing here opens a file.
//!
//! Programs are steps with feeds from corner to corner in the signs of the canonical program; the
//! convention of a layout says how the machine counts. Lengths are mm, angles degrees.

mod centreline;
mod kit;
mod lra;
mod number;
mod obj;
mod pensa;
mod svg;
mod table;
mod xyz;

pub use centreline::{Centreline, centreline};
pub use kit::{KitLayout, kit};
pub use lra::{Lengths, LraLayout, LraNames, lra};
pub use obj::{Tube, obj};
pub use pensa::{Case, PensaLayout, pensa};
pub use svg::{Mark, MarkAt, Picture, PictureWire, Severity, View, svg};
pub use table::{DecimalMark, Separator, TableStyle};
pub use xyz::xyz;
