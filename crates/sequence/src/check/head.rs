//! How near the head comes to a strut, by the distance from its surface.

use nalgebra::{Point3, Vector3};
use wirebend_core::wireframe::VertexId;

use crate::search::Task;
use crate::structure::Structure;

/// The way of the head at a joint.
pub(super) struct Way {
    from: Point3<f64>,
    /// To the other end of a strut; none where it stands.
    pub along: Option<Vector3<f64>>,
    /// The vertices at which a strut touches the tip by its nature.
    touched: Vec<VertexId>,
}

/// A strut that is met.
pub(super) struct Met {
    pub strut: usize,
    pub distance: f64,
    pub least: f64,
}

/// Two ways to compute the same differ by less, mm.
const ROUNDING_MM: f64 = 0.002;
/// So often a part is narrowed down to a little more than half: to less than a millionth.
const NARROWINGS: usize = 32;

/// Along a strut that is drawn from the vertex, or standing at it.
pub(super) fn way(structure: &Structure, drawn: Option<usize>, vertex: VertexId) -> Way {
    let at = |node: usize| structure.nodes()[node].at;
    if let Some(strut) = drawn {
        let ends = structure.struts()[strut].ends;
        let [a, b] = ends.map(|node| structure.nodes()[node].vertex);
        let [from, to] = if vertex == b { [ends[1], ends[0]] } else { ends };
        return Way { from: at(from), along: Some(at(to) - at(from)), touched: vec![a, b] };
    }
    let start = structure.nodes().iter().find(|node| node.vertex == vertex);
    Way { from: start.map_or_else(Point3::origin, |node| node.at), along: None, touched: vec![vertex] }
}

/// The first of the struts that stand, or of `own` that is placed, that the head meets.
pub(super) fn first_met(
    task: &Task<'_>,
    standing: &[usize],
    own: &[usize],
    way: &Way,
    axis: &Vector3<f64>,
) -> Option<Met> {
    standing.iter().chain(own).find_map(|&strut| {
        let ends = task.structure.struts()[strut].ends.map(|node| &task.structure.nodes()[node]);
        let least = if ends.iter().any(|end| way.touched.contains(&end.vertex)) {
            -task.builder.touch.mm()
        } else {
            task.builder.clearance.mm() + task.weight.section.radius
        };
        let distance = nearest(task.builder.head.outline(), axis, way, ends.map(|end| end.at), least);
        (distance < least - ROUNDING_MM).then_some(Met { strut, distance, least })
    })
}

/// The least distance from the moving head to a strut, or a bound below it where that is above `least` already.
fn nearest(outline: &[[f64; 2]], axis: &Vector3<f64>, way: &Way, strut: [Point3<f64>; 2], least: f64) -> f64 {
    let along = way.along.unwrap_or_else(Vector3::zeros);
    let direction = strut[1] - strut[0];
    let at = |s: f64, t: f64| {
        surface_distance(outline, axis, &(strut[0] + direction * t - (way.from + along * s)))
    };
    // Nothing moves faster than this over motion and strut.
    let bound = at(0.5, 0.5) - f64::midpoint(along.norm(), direction.norm());
    if bound > least {
        return bound;
    }
    let over_strut = |s: f64| narrowed(|t| at(s, t));
    if way.along.is_none() { over_strut(0.0) } else { narrowed(over_strut) }
}

/// The least value of a convex function between 0 and 1, by the golden section.
fn narrowed(value: impl Fn(f64) -> f64) -> f64 {
    let golden = (5.0_f64.sqrt() - 1.0) / 2.0;
    let (mut low, mut high) = (0.0, 1.0);
    let mut best = value(low).min(value(high));
    let [mut one, mut other] = [high - golden * (high - low), low + golden * (high - low)];
    let [mut at_one, mut at_other] = [value(one), value(other)];
    for _ in 0..NARROWINGS {
        best = best.min(at_one).min(at_other);
        if at_one < at_other {
            (high, other, at_other) = (other, one, at_one);
            one = high - golden * (high - low);
            at_one = value(one);
        } else {
            (low, one, at_one) = (one, other, at_other);
            other = low + golden * (high - low);
            at_other = value(other);
        }
    }
    best
}

/// The signed distance of a point, seen from the tip, from the surface of the head: the nearest line of its outline turned about the
/// axis.
fn surface_distance(outline: &[[f64; 2]], axis: &Vector3<f64>, from_tip: &Vector3<f64>) -> f64 {
    let z = from_tip.dot(axis);
    let rho = (from_tip - axis * z).norm();
    let [[_, bottom], [height, top]] = [outline[0], outline[outline.len() - 1]];
    let caps = [[[0.0, 0.0], [0.0, bottom]], [[height, top], [height, 0.0]]];
    let lines = outline.windows(2).map(|ends| [ends[0], ends[1]]).chain(caps);
    let mut nearest = f64::INFINITY;
    let mut inside = z > 0.0 && z < height;
    for [[from_z, from_r], [to_z, to_r]] in lines {
        let (dz, dr) = (to_z - from_z, to_r - from_r);
        let length = dz * dz + dr * dr;
        let part = if length > 0.0 {
            (((z - from_z) * dz + (rho - from_r) * dr) / length).clamp(0.0, 1.0)
        } else {
            0.0
        };
        nearest = nearest.min((z - from_z - part * dz).hypot(rho - from_r - part * dr));
        if dz > 0.0 && z >= from_z && z <= to_z {
            inside &= rho < from_r + dr * (z - from_z) / dz;
        }
    }
    if inside { -nearest } else { nearest }
}
