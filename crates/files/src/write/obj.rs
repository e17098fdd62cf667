//! OBJ of the bent wire: its centreline as `l` lines, and a tube around it.

use std::fmt::Write as _;

use nalgebra::{Point3, Rotation3, Vector3};
use wirebend_core::units::Length;

use super::centreline::Centreline;
use super::number::fixed;

/// The wire as a solid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tube {
    /// Radius of the wire.
    pub radius: Length,
    /// How many sides the cross section has; 3 at least.
    pub sides: usize,
}

/// Writes wires (mm), each as a polyline and with `tube` also as an n-gon that is swept along it
/// by parallel transport and closed by its two ends. Wires of less than two points are left out.
#[must_use]
pub fn obj(wires: &[Centreline], tube: Option<Tube>) -> String {
    let mut text = "# bent wire, mm\n".to_owned();
    let mut next = 1;
    for (k, wire) in wires.iter().enumerate().filter(|(_, wire)| wire.points.len() > 1) {
        let _ = writeln!(text, "o wire{}", k + 1);
        vertices(&mut text, &wire.points);
        let ids: Vec<String> = (next..next + wire.points.len()).map(|id| id.to_string()).collect();
        let _ = writeln!(text, "l {}", ids.join(" "));
        next += wire.points.len();
        if let Some(tube) = tube {
            let _ = writeln!(text, "o tube{}", k + 1);
            next = sweep(&mut text, &wire.points, tube, next);
        }
    }
    text
}

fn vertices(text: &mut String, points: &[Point3<f64>]) {
    for p in points {
        let _ = writeln!(text, "v {} {} {}", fixed(p.x, 4), fixed(p.y, 4), fixed(p.z, 4));
    }
}

/// Rings of vertices along the points, quads between them, an n-gon at either end; outside is
/// counter-clockwise. Gives the next free vertex.
fn sweep(text: &mut String, points: &[Point3<f64>], tube: Tube, first: usize) -> usize {
    let sides = tube.sides.max(3);
    let last = points.len() - 1;
    let mut tangent = direction(points, 0);
    let mut normal = tangent.cross(&Vector3::ith(tangent.iamin(), 1.0)).normalize();
    for (k, point) in points.iter().enumerate() {
        let next = direction(points, k);
        if let Some(turn) = Rotation3::rotation_between(&tangent, &next) {
            normal = turn * normal;
        }
        tangent = next;
        let across = tangent.cross(&normal);
        let ring: Vec<Point3<f64>> = (0..sides)
            .map(|side| {
                #[allow(clippy::cast_precision_loss)] // a count of sides
                let angle = std::f64::consts::TAU * side as f64 / sides as f64;
                point + (normal * angle.cos() + across * angle.sin()) * tube.radius.mm()
            })
            .collect();
        vertices(text, &ring);
    }
    let at = |ring: usize, side: usize| first + ring * sides + side % sides;
    let cap = |ring: usize| (0..sides).map(move |side| at(ring, side).to_string());
    let _ = writeln!(text, "f {}", cap(0).rev().collect::<Vec<_>>().join(" "));
    for ring in 0..last {
        for side in 0..sides {
            let quad = [at(ring, side), at(ring, side + 1), at(ring + 1, side + 1), at(ring + 1, side)];
            let _ = writeln!(text, "f {} {} {} {}", quad[0], quad[1], quad[2], quad[3]);
        }
    }
    let _ = writeln!(text, "f {}", cap(last).collect::<Vec<_>>().join(" "));
    first + (last + 1) * sides
}

/// The direction at a point: halfway between the sides that meet there; x where there is none.
fn direction(points: &[Point3<f64>], k: usize) -> Vector3<f64> {
    let side = |from: usize, to: usize| (points[to] - points[from]).try_normalize(0.0);
    let before = if k > 0 { side(k - 1, k) } else { None };
    let after = if k + 1 < points.len() { side(k, k + 1) } else { None };
    let mean = before.unwrap_or_default() + after.unwrap_or_default();
    mean.try_normalize(1e-9).or(before).or(after).unwrap_or_else(Vector3::x)
}
