//! Smooth curves as few straight pieces and arcs, and arcs and splines as points, to a tolerance that the caller
//! gives.

mod arc_fit;
mod cut;
mod flatten;
mod simplify;

pub use arc_fit::{Piece, fit_arcs};
pub use cut::{CurveCut, CurveEnds, EdgeLimit, cut_curve};
pub use flatten::{EllipticArc, Spline, SplineError};
pub use simplify::simplify;

use nalgebra::{Point3, Vector3};

/// Distance from a point to a segment, all in mm; to the point itself where it has no length.
#[must_use]
pub fn distance_to_segment(point: &Point3<f64>, a: &Point3<f64>, b: &Point3<f64>) -> f64 {
    let along: Vector3<f64> = b - a;
    let length2 = along.norm_squared();
    let at = if length2 > 0.0 { ((point - a).dot(&along) / length2).clamp(0.0, 1.0) } else { 0.0 };
    (point - (a + along * at)).norm()
}
