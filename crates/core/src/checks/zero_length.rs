//! Edges without length have no direction, so no program can follow them.

use super::{Code, Design, Diagnostic, Place, Quantity, Severity};

pub(super) fn check(design: &Design, found: &mut Vec<Diagnostic>) {
    for (id, edge) in design.wireframe.edges() {
        let length = design.wireframe.edge_length(id);
        // A thousandth of what counts as one place cannot be told from rounding.
        if length.mm() > design.weld_tolerance.mm() * 1e-3 {
            continue;
        }
        found.push(Diagnostic {
            code: Code::ZeroLengthEdge,
            severity: Severity::Error,
            place: Place { vertices: vec![edge.a, edge.b], edges: vec![id], step: None },
            measured: Some(Quantity::Length(length)),
            limit: None,
            message: format!("edge {id} from vertex {} to vertex {} has no length", edge.a, edge.b),
            help: "delete the edge, or merge its two vertices".to_owned(),
        });
    }
}
