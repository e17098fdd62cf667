//! Vertices on top of each other look joined but are not.

use super::{Code, Design, Diagnostic, Limit, Place, Quantity, Severity};
use crate::units::Length;
use crate::wireframe::{VertexId, Welder};

pub(super) fn check(design: &Design, found: &mut Vec<Diagnostic>) {
    let mut welder = Welder::new(design.weld_tolerance);
    for (id, vertex) in design.wireframe.vertices() {
        let first = VertexId(welder.put(id.0, vertex.position));
        let Some(other) = design.wireframe.vertex(first).filter(|_| first != id) else { continue };
        let apart = Length::computed((vertex.position - other.position).norm());
        found.push(Diagnostic {
            code: Code::CoincidentVertices,
            severity: Severity::Warning,
            place: Place::at_vertices([id, first]),
            measured: Some(Quantity::Length(apart)),
            limit: Some(Limit {
                value: Quantity::Length(design.weld_tolerance),
                source: "the weld tolerance".to_owned(),
            }),
            message: format!("vertices {first} and {id} are {apart:.4} apart but not joined"),
            help: "merge them; where two wires are meant to touch there, leave them".to_owned(),
        });
    }
}
