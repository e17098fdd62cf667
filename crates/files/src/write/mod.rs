//! Writers: values in, text out. One file a format; nothing here opens a file.
//!
//! Programs of machines are written by their drivers. Lengths are mm, angles degrees.

mod centreline;
mod coupon_sheet;
mod drawing;
pub mod frame;
mod glb;
mod job_sheet;
mod labels;
mod obj;
mod pdf;
mod plane;
mod sheet;
mod svg;
mod template;
mod tube;
mod wireframe_obj;

pub use centreline::{Centreline, centreline};
pub use coupon_sheet::{CouponSheet, PrintedCoupon, PrintedReading, coupon_sheet};
pub use glb::glb;
pub use job_sheet::{Figure, Finding, JobSheet, SheetStep, SheetWire, job_sheet};
pub use labels::LabelStep;
pub use obj::obj;
pub use pdf::{Paper, Pdf};
pub use svg::{Mark, MarkAt, Picture, PictureWire, Severity, View, svg};
pub use template::{
    Drawing, Layer, Shape, Template, TooManyPages, template, template_dxf, template_pdf, template_svg,
};
pub use tube::Tube;
pub use wireframe_obj::wireframe_obj;
