//! The surface of a wire along its centreline.

use nalgebra::{Point3, Rotation3, Vector3};
use wirebend_core::units::Length;

/// The wire as a solid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tube {
    /// Radius of the wire.
    pub radius: Length,
    /// How many sides the cross section has; 3 at least.
    pub sides: usize,
}

/// Rings of corners along the points, all of as many sides.
pub(super) struct Swept {
    pub points: Vec<Point3<f64>>,
    sides: usize,
}

impl Swept {
    /// An n-gon that is swept along two points or more by parallel transport.
    pub fn new(centreline: &[Point3<f64>], tube: Tube) -> Self {
        let sides = tube.sides.max(3);
        let mut points = Vec::with_capacity(centreline.len() * sides);
        let mut tangent = direction(centreline, 0);
        let mut normal = tangent.cross(&Vector3::ith(tangent.iamin(), 1.0)).normalize();
        for (k, point) in centreline.iter().enumerate() {
            let next = direction(centreline, k);
            if let Some(turn) = Rotation3::rotation_between(&tangent, &next) {
                normal = turn * normal;
            }
            tangent = next;
            let across = tangent.cross(&normal);
            points.extend((0..sides).map(|side| {
                #[allow(clippy::cast_precision_loss)] // a count of sides
                let angle = std::f64::consts::TAU * side as f64 / sides as f64;
                point + (normal * angle.cos() + across * angle.sin()) * tube.radius.mm()
            }));
        }
        Self { points, sides }
    }

    /// Its faces as indices of points: an n-gon, quads between the rings, an n-gon. Outside is counter-clockwise.
    pub fn faces(&self) -> impl Iterator<Item = Vec<usize>> {
        let sides = self.sides;
        let last = self.points.len() / sides - 1;
        let at = move |ring: usize, side: usize| ring * sides + side % sides;
        let quads = (0..last).flat_map(move |ring| {
            (0..sides).map(move |side| {
                vec![at(ring, side), at(ring, side + 1), at(ring + 1, side + 1), at(ring + 1, side)]
            })
        });
        let first = std::iter::once((0..sides).rev().map(|side| at(0, side)).collect());
        let end = std::iter::once((0..sides).map(|side| at(last, side)).collect());
        first.chain(quads).chain(end)
    }
}

/// The direction at a point: halfway between the sides that meet there; x where there is none.
fn direction(points: &[Point3<f64>], k: usize) -> Vector3<f64> {
    let side = |from: usize, to: usize| (points[to] - points[from]).try_normalize(0.0);
    let before = if k > 0 { side(k - 1, k) } else { None };
    let after = if k + 1 < points.len() { side(k, k + 1) } else { None };
    let mean = before.unwrap_or_default() + after.unwrap_or_default();
    mean.try_normalize(1e-9).or(before).or(after).unwrap_or_else(Vector3::x)
}
