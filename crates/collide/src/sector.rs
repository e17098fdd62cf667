//! In which directions from an axis something lies.

use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::{Isometry3, Point3, UnitVector3, Vector2, Vector3};

use crate::Solid;

/// What is so near to the axis has no direction from it, mm.
const ON_AXIS: f64 = 1e-6;

/// The directions from an axis in which a solid lies, to within a thickness of its own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sector {
    /// Radians from the first of the two directions across the axis towards the second.
    middle: f64,
    /// Radians to either side of it.
    half: f64,
    /// The solid goes so far beyond that, mm.
    thickness: f64,
}

impl Sector {
    /// The sector of a solid that is placed `at`; the axis goes through the origin, and `across` are the two directions across it. None
    /// where the axis goes through it; a round solid that only ends there may have one all the same.
    ///
    /// ```
    /// use nalgebra::{Isometry3, Vector2, Vector3};
    /// use wirebend_collide::{Sector, Solid};
    /// let pin = Solid::Cylinder { radius: 1.5, half_length: 10.0 };
    /// let at = Isometry3::translation(0.0, 3.0, 0.0);
    /// let sector = Sector::around(&pin, &at, [Vector3::x_axis(), Vector3::y_axis()]).unwrap();
    /// // It turns by a right angle, to where it is on the first of the two directions.
    /// let walls = sector.swept([0.0, -std::f64::consts::FRAC_PI_2]).unwrap();
    /// assert!((walls.distance(Vector2::new(7.0, -10.0)) - 8.5).abs() < 1e-5);
    /// ```
    #[must_use]
    pub fn around(solid: &Solid, at: &Isometry3<f64>, across: [UnitVector3<f64>; 2]) -> Option<Self> {
        let place = |corner: Vector3<f64>| {
            let corner = at * Point3::from(corner);
            Vector2::from(across.map(|across| corner.coords.dot(&across)))
        };
        let box_around = |half: Vector3<f64>| {
            let corner = |k: u8| {
                let side = |bit: u8| if k & bit == 0 { 1.0 } else { -1.0 };
                place(half.component_mul(&Vector3::new(side(1), side(2), side(4))))
            };
            Self::of(&[0, 1, 2, 3, 4, 5, 6, 7].map(corner), 0.0)
        };
        let (radius, half_length, half) = match *solid {
            Solid::Box { half } => return box_around(half),
            Solid::Cylinder { radius, half_length } => (radius, half_length, half_length),
            Solid::Capsule { radius, half_length } => (radius, half_length, half_length + radius),
        };
        let core = [half_length, -half_length].map(|z| place(Vector3::new(0.0, 0.0, z)));
        let thin = Self::of(&core, radius);
        let wide = box_around(Vector3::new(radius, radius, half));
        // The one that is narrower where the solid is farthest from the axis.
        let farthest = core[0].norm().max(core[1].norm());
        match (thin, wide) {
            (Some(thin), Some(wide)) if wide.half < thin.half + (radius / farthest).min(1.0).asin() => {
                Some(wide)
            }
            (thin, wide) => thin.or(wide),
        }
    }

    fn of(corners: &[Vector2<f64>], thickness: f64) -> Option<Self> {
        let centre = corners.iter().sum::<Vector2<f64>>();
        if centre.norm() < ON_AXIS {
            return None;
        }
        let (mut least, mut most) = (0.0_f64, 0.0_f64);
        for corner in corners.iter().filter(|corner| corner.norm() > ON_AXIS) {
            let angle = centre.perp(corner).atan2(centre.dot(corner));
            (least, most) = (least.min(angle), most.max(angle));
        }
        // What goes around the axis has corners on all sides of it.
        (most - least < PI).then(|| Self {
            middle: centre.y.atan2(centre.x) + f64::midpoint(least, most),
            half: (most - least) / 2.0,
            thickness: thickness + ON_AXIS,
        })
    }

    /// Between which walls it stays while it turns from one angle to another, radians. None where that is all around.
    #[must_use]
    pub fn swept(&self, [from, to]: [f64; 2]) -> Option<Walls> {
        let (middle, half) = (self.middle + f64::midpoint(from, to), self.half + (to - from).abs() / 2.0);
        (half < PI).then(|| {
            let outward = |side: f64| {
                let wall = middle + side * (half + FRAC_PI_2);
                Vector2::new(wall.cos(), wall.sin())
            };
            Walls {
                outward: [outward(1.0), outward(-1.0)],
                wide: half > FRAC_PI_2,
                thickness: self.thickness,
            }
        })
    }
}

/// Two half-planes that end in an axis, and the room between them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Walls {
    /// Away from the room.
    outward: [Vector2<f64>; 2],
    /// Whether there is more room between them than outside.
    wide: bool,
    /// How far beyond them the room goes.
    thickness: f64,
}

impl Walls {
    /// A bound below the distance of a point, as the vector to it from the axis, from all that is between the walls.
    #[must_use]
    pub fn distance(&self, at: Vector2<f64>) -> f64 {
        self.distance_of_piece([at, at])
    }

    /// The same for all points of a straight piece.
    #[must_use]
    pub fn distance_of_piece(&self, ends: [Vector2<f64>; 2]) -> f64 {
        let [one, other] = self.outward.map(|outward| outward.dot(&ends[0]).min(outward.dot(&ends[1])));
        let from_walls = if self.wide { one.min(other) } else { one.max(other) };
        // Around the axis of a wide room walls are nearer than what is in the room goes into it.
        if self.wide && from_walls <= 0.0 { f64::NEG_INFINITY } else { from_walls - self.thickness }
    }
}
