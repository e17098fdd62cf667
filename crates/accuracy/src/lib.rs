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
//!
//! Where their figures are others: the forces of their Fig. 8 are half of the mean of |N|, and not the RMS that is given here; forces of
//! 0.39 to 0.46 N and surfaces of 0.4 to 0.7 µm from angles are what rounding their coordinates to 1 µm does, and not the effect of
//! angles, which at 0.2° is 0.017 N here, and 0.04 N with the second order of bowing. The RMS of forces is 0.87 to 1.37 times E A of a
//! bowed strut by the strain error; the figure halves it for one ring alone. Their wire is 0.9 mm in every number.

#![deny(missing_docs)]

mod closing;
mod continuum;
mod draw;
mod expected;
mod misfits;
mod model;
mod resources;
mod surface;
#[cfg(test)]
mod testing;
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
