//! The deformed shape of a frame as a model.

use nalgebra::{Point3, Vector3};

use super::super::centreline::Centreline;
use super::super::glb::glb;
use super::super::tube::Tube;
use super::FrameResult;

/// Straight pieces of a bent strut.
const PIECES: u32 = 8;

/// Writes the frame with its displacements and rotations times `scale`, each strut as a tube of its own. A strut runs between its ends as
/// a beam without load on it does: a cubic that leaves them in the direction that they have turned to.
#[must_use]
pub fn deformed_glb(frame: &FrameResult, scale: f64, tube: Tube) -> Vec<u8> {
    let strut = |ends: [usize; 2]| {
        let [a, b] = ends.map(|end| &frame.nodes[end]);
        let along = b.position - a.position;
        let [from, to] = [a, b].map(|node| node.position + node.displacement * scale);
        let [leaving, arriving] = [a, b].map(|node| along + (node.rotation * scale).cross(&along));
        let points =
            (0..=PIECES).map(|k| cubic(f64::from(k) / f64::from(PIECES), from, leaving, to, arriving));
        Centreline { points: points.collect(), tightened: Vec::new() }
    };
    let struts: Vec<Centreline> = frame.members.iter().map(|member| strut(member.ends)).collect();
    glb(&struts, tube)
}

/// Hermite's cubic between two points with their tangents.
fn cubic(
    t: f64,
    from: Point3<f64>,
    leaving: Vector3<f64>,
    to: Point3<f64>,
    arriving: Vector3<f64>,
) -> Point3<f64> {
    let (t2, t3) = (t * t, t * t * t);
    from + (to - from) * (3.0 * t2 - 2.0 * t3) + leaving * (t3 - 2.0 * t2 + t) + arriving * (t3 - t2)
}
