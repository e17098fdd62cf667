//! How a solid moves past a chain.

use nalgebra::{IsometryMatrix3, Point3};

/// How a solid moves past a chain, over a time from 0 to 1.
pub trait Motion {
    /// From the frame of the chain to that of the solid.
    fn pose(&self, time: f64) -> IsometryMatrix3<f64>;

    /// How far any point of the chain in a ball moves at most, seen from the solid, in the time from 0 to 1 if it always moved
    /// as fast as it ever does.
    fn max_travel(&self, centre: &Point3<f64>, radius: f64) -> f64;

    /// A bound below the signed distance of a point of the chain from the solid over the whole motion, by what the motion leaves
    /// as it is, such as how far the point is from the axis about which everything turns. It need not be a close one.
    fn min_distance(&self, _at: &Point3<f64>) -> f64 {
        f64::NEG_INFINITY
    }

    /// [`Motion::min_distance`] of all points of a straight piece.
    fn min_distance_of_piece(&self, _ends: [&Point3<f64>; 2]) -> f64 {
        f64::NEG_INFINITY
    }
}
