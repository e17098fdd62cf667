//! Where the bends and the edges of a program are in space.

use std::collections::BTreeSet;

use nalgebra::{Point3, Vector3};

/// As far from a vertex along the wire, in mm, a step ends at it: sums of feeds are not exact.
const AT_VERTEX: f64 = 1e-3;

/// A step of a program as it stands beside the wire.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LabelStep {
    /// How far it feeds, as designed.
    pub feed_mm: f64,
    /// How far it bends, as designed.
    pub bend_deg: f64,
}

/// A bend of a wire.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::write) struct Bend {
    /// The number of its step, from 1.
    pub number: usize,
    pub at: Point3<f64>,
    /// To the bends before and after it.
    pub sides: [Vector3<f64>; 2],
    pub angle_deg: f64,
}

/// A straight part of a wire.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::write) struct Edge {
    pub ends: [Point3<f64>; 2],
    pub length_mm: f64,
}

#[derive(Debug, Clone, PartialEq, Default)]
pub(in crate::write) struct Spots {
    pub bends: Vec<Bend>,
    /// Once each, however often the wire runs along it.
    pub edges: Vec<Edge>,
}

/// Where the steps of a program are along a path in mm: a step ends where so much of the path is fed. Points that are not
/// finite are passed over.
pub(in crate::write) fn spots(path: &[Point3<f64>], steps: &[LabelStep]) -> Spots {
    let path: Vec<Point3<f64>> =
        path.iter().copied().filter(|point| point.coords.iter().all(|c| c.is_finite())).collect();
    let Some(&first) = path.first() else { return Spots::default() };
    let mut places = vec![first];
    let (mut segment, mut before, mut fed) = (0, 0.0, 0.0);
    for step in steps {
        fed += step.feed_mm.max(0.0);
        let mut at = None;
        while let [from, to, ..] = path[segment..] {
            let length = (to - from).norm();
            if fed < before + length - AT_VERTEX {
                at = Some(from + (to - from) * ((fed - before) / length).max(0.0));
                break;
            }
            if fed <= before + length + AT_VERTEX {
                at = Some(to);
                break;
            }
            before += length;
            segment += 1;
        }
        // Steps beyond the end of the path are of another wire.
        let Some(at) = at else { break };
        places.push(at);
    }
    let mut found = Spots::default();
    let mut known = BTreeSet::new();
    for (index, (step, ends)) in steps.iter().zip(places.windows(2)).enumerate() {
        let (from, at) = (ends[0], ends[1]);
        if step.feed_mm > AT_VERTEX && known.insert(key(from, at)) {
            found.edges.push(Edge { ends: [from, at], length_mm: step.feed_mm });
        }
        if step.bend_deg != 0.0 && step.bend_deg.is_finite() {
            let after = places.get(index + 2).copied().unwrap_or(at);
            let sides = [from - at, after - at];
            found.bends.push(Bend { number: index + 1, at, sides, angle_deg: step.bend_deg });
        }
    }
    found
}

/// The same for an edge whichever way the wire runs along it.
fn key(a: Point3<f64>, b: Point3<f64>) -> [[i64; 3]; 2] {
    #[allow(clippy::cast_possible_truncation)] // micrometres; what is farther away saturates
    let whole = |point: Point3<f64>| [point.x, point.y, point.z].map(|c| (c / AT_VERTEX).round() as i64);
    let mut ends = [whole(a), whole(b)];
    ends.sort_unstable();
    ends
}
