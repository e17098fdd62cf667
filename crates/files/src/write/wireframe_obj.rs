//! OBJ of a wireframe, for another program: a vertex for each vertex, a line for each edge.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use wirebend_core::wireframe::{VertexId, Wireframe};

/// Writes a wireframe, mm. Coordinates have all their digits, so that what reads them back has the same ones; a vertex
/// without an edge is a point.
#[must_use]
pub fn wireframe_obj(wireframe: &Wireframe) -> String {
    let mut text = "# wireframe, mm\n".to_owned();
    let mut numbers: BTreeMap<VertexId, usize> = BTreeMap::new();
    for (number, (id, vertex)) in (1..).zip(wireframe.vertices()) {
        let p = vertex.position;
        let _ = writeln!(text, "v {} {} {}", p.x, p.y, p.z);
        numbers.insert(id, number);
    }
    for (_, edge) in wireframe.edges() {
        let _ = writeln!(text, "l {} {}", numbers[&edge.a], numbers[&edge.b]);
    }
    for (id, number) in &numbers {
        if wireframe.incident(*id).is_empty() {
            let _ = writeln!(text, "p {number}");
        }
    }
    text
}
