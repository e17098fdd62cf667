//! Distances as a person would measure them: point by point.

use nalgebra::{Isometry3, IsometryMatrix3, Point3, Rotation3, Translation3, Vector3};
use proptest::prelude::*;
use wirebend_collide::{Motion, Solid};

/// How far a point is from a solid, by the nearest point of its surface or, inside, the nearest of its faces.
pub fn distance(solid: &Solid, at: &Point3<f64>) -> f64 {
    match *solid {
        Solid::Box { half } => {
            let clamped = Point3::new(
                at.x.max(-half.x).min(half.x),
                at.y.max(-half.y).min(half.y),
                at.z.max(-half.z).min(half.z),
            );
            let faces =
                [half.x - at.x, half.x + at.x, half.y - at.y, half.y + at.y, half.z - at.z, half.z + at.z];
            let depth = faces.into_iter().fold(f64::INFINITY, f64::min);
            if depth > 0.0 { -depth } else { (at - clamped).norm() }
        }
        Solid::Cylinder { radius, half_length } => {
            let from_axis = (at.x * at.x + at.y * at.y).sqrt();
            let depth = (radius - from_axis).min(half_length - at.z).min(half_length + at.z);
            if depth > 0.0 {
                return -depth;
            }
            let shrink = if from_axis > radius { radius / from_axis } else { 1.0 };
            let nearest = Point3::new(at.x * shrink, at.y * shrink, at.z.max(-half_length).min(half_length));
            (at - nearest).norm()
        }
        Solid::Capsule { radius, half_length } => {
            let ends = [-half_length, half_length].map(|z| (at - Point3::new(0.0, 0.0, z)).norm());
            let beside = if at.z.abs() <= half_length { at.x.hypot(at.y) } else { f64::INFINITY };
            ends.into_iter().fold(beside, f64::min) - radius
        }
    }
}

/// The least distance of points of a piece so many of which are looked at; the exact one is less by `step` at most.
pub struct Sampled {
    pub least: f64,
    pub step: f64,
}

pub fn piece(solid: &Solid, [from, to]: [Point3<f64>; 2], points: u32) -> Sampled {
    let at = |k: u32| from + (to - from) * (f64::from(k) / f64::from(points));
    let least = (0..=points).map(|k| distance(solid, &at(k))).fold(f64::INFINITY, f64::min);
    Sampled { least, step: (to - from).norm() / f64::from(points) / 2.0 }
}

/// A turn about an axis while moving straight.
#[derive(Debug, Clone)]
pub struct Screw {
    pub begin: Isometry3<f64>,
    pub turn: Vector3<f64>,
    pub shift: Vector3<f64>,
}

impl Motion for Screw {
    fn pose(&self, time: f64) -> IsometryMatrix3<f64> {
        let turn = Rotation3::from_scaled_axis(self.turn * time);
        let begin = nalgebra::convert::<_, IsometryMatrix3<f64>>(self.begin);
        IsometryMatrix3::from_parts(Translation3::from(self.shift * time), turn) * begin
    }

    fn max_travel(&self, centre: &Point3<f64>, radius: f64) -> f64 {
        // The frame's origin is on the axis.
        let reach = (self.begin * centre).coords.norm() + radius;
        self.turn.norm() * reach + self.shift.norm()
    }
}

fn vector(size: f64) -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-size..size).prop_map(Vector3::from)
}

pub fn points(count: impl Into<prop::collection::SizeRange>) -> impl Strategy<Value = Vec<Point3<f64>>> {
    prop::collection::vec(vector(60.0).prop_map(Point3::from), count)
}

pub fn solid() -> impl Strategy<Value = Solid> {
    prop_oneof![
        prop::array::uniform3(0.0..20.0_f64).prop_map(|half| Solid::Box { half: Vector3::from(half) }),
        (0.0..20.0_f64, 0.0..20.0_f64)
            .prop_map(|(radius, half_length)| Solid::Cylinder { radius, half_length }),
        (0.0..20.0_f64, 0.0..20.0_f64)
            .prop_map(|(radius, half_length)| Solid::Capsule { radius, half_length }),
    ]
}

pub fn screw() -> impl Strategy<Value = Screw> {
    (vector(40.0), vector(3.0), vector(3.0), vector(60.0)).prop_map(|(at, lie, turn, shift)| Screw {
        begin: Isometry3::new(at, lie),
        turn,
        shift,
    })
}
