//! What lies between two cylinders about one axis.

use nalgebra::{Isometry3, Point3, UnitVector3, Vector2};

use crate::{Solid, to_solid};

/// The room between two cylinders about one axis and two planes across it. What turns about that axis stays in its ring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ring {
    /// From where to where along the axis.
    pub along: [f64; 2],
    /// From how far to how far away from it.
    pub from_axis: [f64; 2],
}

/// How exact a ring is.
const EXACT: f64 = 1e-3;

impl Ring {
    /// A ring around a solid that is placed `at`; the axis goes through the origin.
    ///
    /// ```
    /// use nalgebra::{Isometry3, Vector3};
    /// use wirebend_collide::{Ring, Solid};
    /// let rod = Solid::Cylinder { radius: 2.0, half_length: 10.0 };
    /// let ring = Ring::around(&rod, &Isometry3::translation(5.0, 0.0, 3.0), &Vector3::z_axis());
    /// assert_eq!(ring.along, [-7.0, 13.0]);
    /// assert!((ring.from_axis[0] - 3.0).abs() < 0.01 && (ring.from_axis[1] - 7.0).abs() < 0.01);
    /// ```
    #[must_use]
    pub fn around(solid: &Solid, at: &Isometry3<f64>, axis: &UnitVector3<f64>) -> Self {
        let (way, origin) = (at.inverse() * axis, at.inverse() * Point3::origin());
        let (middle, half) = (at.translation.vector.dot(axis), solid.half_extent(&way));
        let along = [middle - half, middle + half];
        let [from, to] = along.map(|along| origin + way.into_inner() * along);
        let nearest = to_solid([&from, &to], solid, EXACT).distance - EXACT;
        let farthest = solid.max_distance_from(&origin, &way);
        Self { along, from_axis: [nearest.max(0.0), farthest] }
    }

    /// The signed distance of a point, by where it is along the axis and how far away from it. What is in the ring is no nearer.
    #[must_use]
    pub fn distance(&self, along: f64, from_axis: f64) -> f64 {
        self.from([along, along], [from_axis, from_axis])
    }

    /// A bound below that of any point of a straight piece, its ends as places along the axis and vectors away from it.
    #[must_use]
    pub fn distance_of_piece(&self, [from, to]: [(f64, Vector2<f64>); 2]) -> f64 {
        let way = to.1 - from.1;
        let length = way.norm_squared();
        let part = if length > 0.0 { (-from.1.dot(&way) / length).clamp(0.0, 1.0) } else { 0.0 };
        let farthest = from.1.norm_squared().max(to.1.norm_squared()).sqrt();
        self.from([from.0.min(to.0), from.0.max(to.0)], [(from.1 + way * part).norm(), farthest])
    }

    /// From what is between these places along the axis, and as far away from it.
    fn from(&self, along: [f64; 2], from_axis: [f64; 2]) -> f64 {
        let beyond = |[from, to]: [f64; 2], [low, high]: [f64; 2]| (low - to).max(from - high);
        // Without a hole there is no inner side.
        let hole = if self.from_axis[0] > 0.0 { self.from_axis[0] } else { f64::NEG_INFINITY };
        let (along, across) = (beyond(along, self.along), beyond(from_axis, [hole, self.from_axis[1]]));
        let (beside, above) = (along.max(0.0), across.max(0.0));
        if along.max(across) <= 0.0 { along.max(across) } else { (beside * beside + above * above).sqrt() }
    }
}
