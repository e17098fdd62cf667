//! The turtle that reads a program.

use nalgebra::{Matrix3, Point3, Rotation3, Unit, Vector3};

use crate::units::{Angle, Length};

/// Position (mm) and right-handed orthonormal axes of the turtle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Where it is.
    pub position: Point3<f64>,
    /// Columns t (tangent), n (the side that a positive bend turns to) and b = t × n.
    axes: Matrix3<f64>,
}

impl Default for Frame {
    /// At the origin with t = x, n = y, b = z.
    fn default() -> Self {
        Self { position: Point3::origin(), axes: Matrix3::identity() }
    }
}

impl Frame {
    /// A frame at `position` that looks along `tangent`, with n as close to `towards` as it can be.
    ///
    /// Where `towards` is (nearly) along the tangent, any n will do and a fixed one is chosen.
    /// `None` when the tangent has no length.
    #[must_use]
    pub fn looking(position: Point3<f64>, tangent: Vector3<f64>, towards: Vector3<f64>) -> Option<Self> {
        let t = tangent.try_normalize(0.0)?;
        let across = |v: Vector3<f64>| (v - t * t.dot(&v)).try_normalize(1e-9);
        let axis = t.iamin();
        let n = across(towards.try_normalize(0.0).unwrap_or(towards))
            .or_else(|| across(Vector3::ith(axis, 1.0)))?;
        Some(Self { position, axes: Matrix3::from_columns(&[t, n, t.cross(&n)]) })
    }

    /// The unit tangent.
    #[must_use]
    pub fn t(&self) -> Vector3<f64> {
        self.axes.column(0).into()
    }

    /// The unit normal: the side that a positive bend turns to.
    #[must_use]
    pub fn n(&self) -> Vector3<f64> {
        self.axes.column(1).into()
    }

    /// The unit binormal t × n: the axis of the bend.
    #[must_use]
    pub fn b(&self) -> Vector3<f64> {
        self.axes.column(2).into()
    }

    /// Moves along t.
    pub fn feed(&mut self, length: Length) {
        self.position += self.t() * length.mm();
    }

    /// Turns right-handed about t.
    pub fn rotate(&mut self, angle: Angle) {
        self.turn(self.t(), angle);
    }

    /// Turns right-handed about b: t towards n.
    pub fn bend(&mut self, angle: Angle) {
        self.turn(self.b(), angle);
    }

    fn turn(&mut self, axis: Vector3<f64>, angle: Angle) {
        if angle == Angle::ZERO {
            return;
        }
        let turned = Rotation3::from_axis_angle(&Unit::new_unchecked(axis), angle.rad()) * self.axes;
        // Gram-Schmidt keeps rounding from adding up over thousands of steps.
        let t: Vector3<f64> = turned.column(0).normalize();
        let n: Vector3<f64> = turned.column(1).into_owned();
        let n = (n - t * t.dot(&n)).normalize();
        self.axes = Matrix3::from_columns(&[t, n, t.cross(&n)]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_turns_are_right_handed() {
        let quarter = Angle::from_deg(90.0).unwrap();
        let mut frame = Frame::default();
        frame.rotate(quarter);
        assert!((frame.n() - Vector3::z()).norm() < 1e-15, "about t = x, y goes to z");
        let mut frame = Frame::default();
        frame.bend(quarter);
        assert!((frame.t() - Vector3::y()).norm() < 1e-15, "t goes to n");
        assert!((frame.b() - Vector3::z()).norm() < 1e-15);
    }
}
