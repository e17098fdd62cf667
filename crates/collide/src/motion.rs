//! How a solid moves past a chain.

use nalgebra::{Isometry3, Point3};

/// How a solid moves past a chain, over a time from 0 to 1.
pub trait Motion {
    /// From the frame of the chain to that of the solid.
    fn pose(&self, time: f64) -> Isometry3<f64>;

    /// How far any point of the chain in a ball moves at most, seen from the solid, in the time from 0 to 1 if it always moved
    /// as fast as it ever does.
    fn most(&self, centre: &Point3<f64>, radius: f64) -> f64;
}
