//! Edges without length have no direction, so no program can follow them.

use super::Design;
use crate::checks::{Diagnostic, Fact, Location, Remedy, Severity};

pub(super) fn check(design: &Design, found: &mut Vec<Diagnostic>) {
    for (id, edge) in design.wireframe.edges() {
        let length = design.wireframe.edge_length(id);
        // A thousandth of the weld tolerance cannot be told from rounding.
        if length.mm() > design.weld_tolerance.mm() * 1e-3 {
            continue;
        }
        found.push(Diagnostic {
            severity: Severity::Error,
            location: Location { vertices: vec![edge.a, edge.b], edges: vec![id], step: None },
            fact: Fact::ZeroLengthEdge { edge: id, ends: [edge.a, edge.b], length },
            remedies: vec![Remedy::DeleteEdge, Remedy::MergeVertices],
        });
    }
}
