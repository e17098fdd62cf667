//! What became of the curves of a drawing that were cut to edges of a least length.

use nalgebra::Point3;

/// What was made of curves, in mm. Empty where there are none.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CurveFacts {
    /// The largest distance between the drawing and its edges.
    pub deviation_mm: f64,
    /// Where that is.
    pub at: Point3<f64>,
    /// How many curves are farther off than the tolerance, since edges that follow them closer would be too short.
    pub coarser: usize,
    /// How many edges are too short all the same, since their curves have no room for longer ones.
    pub too_short: usize,
    /// How tight each curve is.
    pub radii: Vec<CurveRadius>,
}

/// The tightest place of a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurveRadius {
    /// Radius of curvature, mm.
    pub radius_mm: f64,
    pub at: Point3<f64>,
}

impl CurveFacts {
    pub(super) fn far(&mut self, distance: f64, at: Point3<f64>) {
        if distance > self.deviation_mm {
            (self.deviation_mm, self.at) = (distance, at);
        }
    }

    /// Adds what was made of other curves.
    pub(super) fn add(&mut self, other: Self) {
        self.far(other.deviation_mm, other.at);
        self.coarser += other.coarser;
        self.too_short += other.too_short;
        self.radii.extend(other.radii);
    }

    /// From numbers of a file to millimetres; `slack` is how far curves are from the points that they were measured by.
    pub(super) fn scaled(mut self, factor: f64, slack: f64) -> Self {
        let at = |point: Point3<f64>| Point3::from(point.coords * factor);
        if !self.radii.is_empty() {
            self.deviation_mm = (self.deviation_mm + slack) * factor;
        }
        self.at = at(self.at);
        for radius in &mut self.radii {
            *radius = CurveRadius { radius_mm: radius.radius_mm * factor, at: at(radius.at) };
        }
        self
    }
}

/// The tightest place of close points; none of fewer than three, and a radius without end of a straight line.
pub(super) fn tightest(points: &[Point3<f64>]) -> Option<CurveRadius> {
    let radii = points.windows(3).map(|three| {
        let (a, b) = (three[1] - three[0], three[2] - three[1]);
        let across = a.cross(&b).norm();
        // The circle through three points: a·b·c/(4·area).
        let radius_mm =
            if across > 0.0 { a.norm() * b.norm() * (a + b).norm() / (2.0 * across) } else { f64::MAX };
        CurveRadius { radius_mm, at: three[1] }
    });
    radii.min_by(|one, other| one.radius_mm.total_cmp(&other.radius_mm))
}
