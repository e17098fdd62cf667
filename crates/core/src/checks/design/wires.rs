//! Whether the wireframe is connected: each part that is not takes a wire of its own.

use super::Design;
use crate::checks::{Diagnostic, Fact, Location, Remedy, Severity};

pub(super) fn check(design: &Design, found: &mut Vec<Diagnostic>) {
    let wires: Vec<_> = design.components.iter().filter(|component| !component.edges.is_empty()).collect();
    if wires.is_empty() {
        found.push(Diagnostic {
            severity: Severity::Error,
            location: Location::default(),
            fact: Fact::NoEdges,
            remedies: vec![Remedy::DrawEdges, Remedy::TakeFaceEdges],
        });
    }
    if wires.len() > 1 {
        found.push(Diagnostic {
            severity: Severity::Info,
            location: Location::at_vertices(
                wires.iter().filter_map(|component| component.vertices.first().copied()),
            ),
            fact: Fact::SeveralWires { wires: wires.len() },
            remedies: vec![Remedy::ConnectParts, Remedy::BendEachPart],
        });
    }
    let lone = design.components.iter().filter(|component| component.edges.is_empty());
    for &vertex in lone.filter_map(|component| component.vertices.first()) {
        found.push(Diagnostic {
            severity: Severity::Warning,
            location: Location::at_vertices([vertex]),
            fact: Fact::IsolatedVertex { vertex },
            remedies: vec![Remedy::ConnectVertex, Remedy::DeleteVertex],
        });
    }
}
