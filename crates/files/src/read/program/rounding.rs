//! How far off the corners of a program are because its figures have few digits.

use nalgebra::Point3;

/// What the last digits of a program's figures stand for; 0 where they are exact.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Rounding {
    pub(crate) length_mm: f64,
    pub(crate) angle_deg: f64,
}

/// No corners are taken for one that are farther apart, mm: no wire is as thin.
const MOST_MM: f64 = 0.2;
/// So many standard deviations a path may be off.
const DEVIATIONS: f64 = 4.0;
/// Variance of what is rounded, as a share of the square of its last digit.
const VARIANCE: f64 = 1.0 / 12.0;

impl Rounding {
    /// How far a path (mm) may miss a corner to which it comes back, mm: each feed is off by up to half of its last digit, and each turn
    /// and bend moves what is farthest from it as far as its angle is off.
    pub(super) fn misses(self, path: &[Point3<f64>]) -> f64 {
        let steps: f64 = path.windows(2).map(|_| 1.0).sum();
        let [low, high] = [Point3::inf, Point3::sup].map(|of| path.iter().copied().reduce(|a, b| of(&a, &b)));
        let across = low.zip(high).map_or(0.0, |(low, high)| (high - low).norm());
        let turned = self.angle_deg.to_radians() * across;
        let variance = VARIANCE * steps * (self.length_mm.powi(2) + 2.0 * turned.powi(2));
        (DEVIATIONS * variance.sqrt()).min(MOST_MM)
    }
}
