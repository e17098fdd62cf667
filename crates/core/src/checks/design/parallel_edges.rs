//! Two edges between the same vertices are two wires on top of each other.

use std::collections::BTreeMap;

use super::Design;
use crate::checks::{Diagnostic, Fact, Location, Remedy, Severity};

pub(super) fn check(design: &Design, found: &mut Vec<Diagnostic>) {
    let mut first = BTreeMap::new();
    for (id, edge) in design.wireframe.edges() {
        if let Some(&earlier) = first.get(&edge.ends()) {
            found.push(Diagnostic {
                severity: Severity::Warning,
                location: Location::at_edges([id, earlier]),
                fact: Fact::ParallelEdges { edges: [earlier, id], ends: [edge.a, edge.b] },
                remedies: vec![Remedy::DeleteParallelEdge],
            });
        } else {
            first.insert(edge.ends(), id);
        }
    }
}
