//! How accurate a frame of bent wire is once its joints are closed, and what it takes.
//!
//! A machine bends a wire whose lengths and angles are a little off. Its passes do not meet where the frame has its vertices: they are
//! pulled there and locked, and the frame keeps some of it as stress and some as a wrong shape. [`ClosingModel`] computes both, from
//! the errors of single motions ([`FrameWire`]), for one drawn wire or as the exact expectation over all. [`tolerance`] turns it round:
//! how good must a machine be? [`Continuum`] has the closed formulas for trusses of many rings, [`Resources`] the authors' reckoning of
//! energy and time.
//!
//! After Bend-Forming (Bhundiya and Cordero 2023, sections 4.1 to 4.3), linear: no residual stress of the bends, no slip, joints without
//! weight and rigid, doubled struts on one axis.

mod closing;
mod continuum;
mod draw;
mod expected;
mod misfits;
mod model;
mod resources;
mod surface;
#[cfg(test)]
mod tests;
mod tolerance;

pub use closing::{Closed, Closing};
pub use continuum::{BowedStrut, Continuum, axial_share};
pub use draw::{Draw, bows};
pub use expected::Expected;
pub use misfits::FrameWire;
pub use model::{ClosingError, ClosingModel, Prepared};
pub use resources::Resources;
pub use surface::Surface;
pub use tolerance::{Effects, NoLimit, Requirement, Responses, Tolerance, Vary, tolerance};
