//! Whether the wireframe is connected: what is not connected takes a wire of its own.

use super::{Code, Design, Diagnostic, Place, Quantity, Severity};

pub(super) fn check(design: &Design, found: &mut Vec<Diagnostic>) {
    let wires: Vec<_> = design.components.iter().filter(|component| !component.edges.is_empty()).collect();
    if wires.is_empty() {
        found.push(Diagnostic {
            code: Code::NoEdges,
            severity: Severity::Error,
            place: Place::default(),
            measured: Some(Quantity::Count(0)),
            limit: None,
            message: "the wireframe has no edges: there is nothing to bend".to_owned(),
            help: "draw edges, or take the edges of a model's faces".to_owned(),
        });
    }
    if wires.len() > 1 {
        found.push(Diagnostic {
            code: Code::SeveralWires,
            severity: Severity::Info,
            place: Place::at_vertices(
                wires.iter().filter_map(|component| component.vertices.first().copied()),
            ),
            measured: Some(Quantity::Count(wires.len())),
            limit: None,
            message: format!("the wireframe is not connected: it takes {} wires", wires.len()),
            help: "connect the parts to bend them from one wire, or bend one wire for each".to_owned(),
        });
    }
    for component in design.components.iter().filter(|component| component.edges.is_empty()) {
        found.push(Diagnostic {
            code: Code::IsolatedVertex,
            severity: Severity::Warning,
            place: Place::at_vertices(component.vertices.iter().copied()),
            measured: None,
            limit: None,
            message: format!("vertex {} has no edge and will not be made", component.vertices[0]),
            help: "connect it or delete it".to_owned(),
        });
    }
}
