//! OBJ of the bent wire: its centreline as `l` lines, and a tube around it.

use std::fmt::Write as _;

use nalgebra::Point3;

use super::centreline::Centreline;
use super::tube::{Swept, Tube};
use crate::number::fixed;

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
            let swept = Swept::new(&wire.points, tube);
            let _ = writeln!(text, "o tube{}", k + 1);
            vertices(&mut text, &swept.points);
            for face in swept.faces() {
                let ids: Vec<String> = face.iter().map(|corner| (next + corner).to_string()).collect();
                let _ = writeln!(text, "f {}", ids.join(" "));
            }
            next += swept.points.len();
        }
    }
    text
}

fn vertices(text: &mut String, points: &[Point3<f64>]) {
    for p in points {
        let _ = writeln!(text, "v {} {} {}", fixed(p.x, 4), fixed(p.y, 4), fixed(p.z, 4));
    }
}
