//! Two edges between the same vertices are two wires on top of each other.

use std::collections::BTreeMap;

use super::{Code, Design, Diagnostic, Place, Severity};

pub(super) fn check(design: &Design, found: &mut Vec<Diagnostic>) {
    let mut first = BTreeMap::new();
    for (id, edge) in design.wireframe.edges() {
        if let Some(&earlier) = first.get(&edge.ends()) {
            found.push(Diagnostic {
                code: Code::ParallelEdges,
                severity: Severity::Warning,
                place: Place::at_edges([id, earlier]),
                measured: None,
                limit: None,
                message: format!("edges {earlier} and {id} both join vertices {} and {}", edge.a, edge.b),
                help: "delete one of them; an edge that has to be travelled twice is doubled by the route"
                    .to_owned(),
            });
        } else {
            first.insert(edge.ends(), id);
        }
    }
}
