//! Convex solids by their signed distance.

use nalgebra::{Point3, UnitVector3, Vector2, Vector3};

/// A convex solid about the origin of its own frame; sizes in mm, none below 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Solid {
    /// A box along the axes.
    Box {
        /// Half of its edges.
        half: Vector3<f64>,
    },
    /// A cylinder about z with flat ends.
    Cylinder {
        /// Its radius.
        radius: f64,
        /// Half of its length.
        half_length: f64,
    },
    /// A cylinder about z with half a ball on each end.
    Capsule {
        /// Its radius.
        radius: f64,
        /// Half of the length between the centres of its ends.
        half_length: f64,
    },
}

impl Solid {
    /// How far a point is from the surface: below 0 inside. A convex function that changes by no more than the point moves.
    ///
    /// ```
    /// use nalgebra::{Point3, Vector3};
    /// use wirebend_collide::Solid;
    /// let cube = Solid::Box { half: Vector3::new(1.0, 1.0, 1.0) };
    /// assert_eq!(cube.distance(&Point3::new(4.0, 5.0, 0.0)), 5.0);
    /// assert_eq!(cube.distance(&Point3::new(0.9, 0.0, 0.0)), -0.09999999999999998);
    /// ```
    #[must_use]
    pub fn distance(&self, at: &Point3<f64>) -> f64 {
        match *self {
            Self::Box { half } => {
                let beyond = at.coords.abs() - half;
                let inside = beyond.max();
                if inside <= 0.0 { inside } else { beyond.sup(&Vector3::zeros()).norm() }
            }
            Self::Cylinder { radius, half_length } => {
                let [across, along] = [at.xy().coords.norm() - radius, at.z.abs() - half_length];
                let inside = across.max(along);
                if inside <= 0.0 { inside } else { Vector2::new(across.max(0.0), along.max(0.0)).norm() }
            }
            Self::Capsule { radius, half_length } => {
                (at - Point3::new(0.0, 0.0, at.z.clamp(-half_length, half_length))).norm() - radius
            }
        }
    }

    /// How far it reaches from its centre along `way`, and against it.
    #[must_use]
    pub fn half_extent(&self, way: &UnitVector3<f64>) -> f64 {
        let across = way.x.hypot(way.y);
        match *self {
            Self::Box { half } => half.dot(&way.abs()),
            Self::Cylinder { radius, half_length } => radius * across + half_length * way.z.abs(),
            Self::Capsule { radius, half_length } => radius + half_length * way.z.abs(),
        }
    }

    /// No point of it is farther than this from the line through `origin` along `way`.
    pub(crate) fn max_distance_from(&self, origin: &Point3<f64>, way: &UnitVector3<f64>) -> f64 {
        let from_line = |at: Vector3<f64>| (at - origin.coords).cross(way).norm();
        match *self {
            Self::Box { half } => {
                let corner = |k: u8| {
                    let side = |bit: u8| if k & bit == 0 { 1.0 } else { -1.0 };
                    from_line(half.component_mul(&Vector3::new(side(1), side(2), side(4))))
                };
                (0..8).map(corner).fold(0.0, f64::max)
            }
            Self::Cylinder { radius, half_length } | Self::Capsule { radius, half_length } => {
                let end = |z: f64| from_line(Vector3::new(0.0, 0.0, z));
                end(half_length).max(end(-half_length)) + radius
            }
        }
    }

    /// The distance of a point, and by how much it grows for each mm along `way`: one of the slopes where there are several.
    #[must_use]
    pub(crate) fn distance_along(&self, at: &Point3<f64>, way: &Vector3<f64>) -> (f64, f64) {
        let distance = self.distance(at);
        (distance, self.outward(at).dot(way))
    }

    /// The way on which the distance of a point grows fastest.
    fn outward(&self, at: &Point3<f64>) -> Vector3<f64> {
        match *self {
            Self::Box { half } => {
                let beyond = at.coords.abs() - half;
                let nearest = beyond.imax();
                let out = if beyond[nearest] > 0.0 {
                    beyond.sup(&Vector3::zeros()).normalize()
                } else {
                    Vector3::ith(nearest, 1.0)
                };
                out.component_mul(&at.coords.map(f64::signum))
            }
            Self::Cylinder { radius, half_length } => {
                let from_axis = at.xy().coords.norm();
                let [across, along] = [from_axis - radius, at.z.abs() - half_length];
                let side = if from_axis > 0.0 {
                    Vector3::new(at.x / from_axis, at.y / from_axis, 0.0)
                } else {
                    Vector3::x()
                };
                let end = Vector3::z() * at.z.signum();
                match (across > 0.0, along > 0.0) {
                    (true, true) => (side * across + end * along).normalize(),
                    (true, false) => side,
                    (false, true) => end,
                    (false, false) => {
                        if across > along {
                            side
                        } else {
                            end
                        }
                    }
                }
            }
            Self::Capsule { half_length, .. } => {
                let out = at - Point3::new(0.0, 0.0, at.z.clamp(-half_length, half_length));
                out.try_normalize(0.0).unwrap_or_else(Vector3::x)
            }
        }
    }
}
