//! Vertices on top of each other look joined but are not.

use super::Design;
use crate::checks::{Diagnostic, Fact, Location, Remedy, Severity};
use crate::units::Length;
use crate::wireframe::{VertexId, Welder};

pub(super) fn check(design: &Design, found: &mut Vec<Diagnostic>) {
    let mut welder = Welder::new(design.weld_tolerance);
    for (id, vertex) in design.wireframe.vertices() {
        let first = VertexId(welder.put(id.0, vertex.position));
        let Some(other) = design.wireframe.vertex(first).filter(|_| first != id) else { continue };
        found.push(Diagnostic {
            severity: Severity::Warning,
            location: Location::at_vertices([id, first]),
            fact: Fact::CoincidentVertices {
                vertices: [first, id],
                distance: Length::computed((vertex.position - other.position).norm()),
                tolerance: design.weld_tolerance,
            },
            remedies: vec![Remedy::MergeVertices, Remedy::LeaveTouching],
        });
    }
}
