//! What further wires would save, beyond one for each part of the design.

use wirebend_core::route::Share;
use wirebend_core::wireframe::Component;
use wirebend_files::document::Document;
use wirebend_planning::plan::wires_of_parts;

/// More further wires than these are no answer.
const MAX_FURTHER: usize = 5;

/// The shares of the parts with one further wire, with two, and so on while they are of use.
pub(super) fn with_further_wires(document: &Document) -> Vec<Vec<Share>> {
    let parts = document.wireframe.components();
    let parts: Vec<&Component> = parts.iter().filter(|part| !part.edges.is_empty()).collect();
    let shared_out = |wires: usize| {
        let shares = wires_of_parts(document, &parts, document.start, wires);
        let used: usize = shares.iter().map(|share| share.wires).sum();
        (used == wires).then_some(shares)
    };
    (1..=MAX_FURTHER).map_while(|further| shared_out(parts.len() + further)).collect()
}
