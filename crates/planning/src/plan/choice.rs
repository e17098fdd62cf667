//! What a plan is made with: the request's choices, and the document's where it has none.

use wirebend_core::plan::DoublingChoice;
use wirebend_core::route::{Share, doublings, share_out};
use wirebend_core::wireframe::{Component, EdgeId, VertexId};
use wirebend_files::document::Document;

use crate::choices::PlanChoices;

/// What was chosen of the wires: in the request, else in the document.
pub(super) struct WireChoice {
    pub wires: usize,
    pub closed: bool,
    pub reversed: bool,
}

impl WireChoice {
    pub fn of(document: &Document, choices: &PlanChoices) -> Self {
        // A closed wire is the only one of its part.
        let closed = choices.closed || document.closed && choices.wires.is_none();
        let wires = choices.wires.map_or(document.wires.get(), |wires| wires as usize);
        Self { wires: if closed { 1 } else { wires }, closed, reversed: choices.reverse != document.reversed }
    }
}

/// The wanted start, where it is in this part of the design.
pub(super) fn start_in(part: &Component, start: Option<VertexId>) -> Option<VertexId> {
    start.filter(|vertex| part.vertices.binary_search(vertex).is_ok())
}

/// How the wires of a design are shared out to its parts, and what is doubled then at least: one wire for each part, and each
/// further one where it saves most.
pub fn wires_of_parts(
    document: &Document,
    parts: &[&Component],
    start: Option<VertexId>,
    wires: usize,
) -> Vec<Share> {
    let further = wires.saturating_sub(parts.len());
    if further == 0 {
        return parts.iter().map(|_| Share::default()).collect();
    }
    let curves = parts.iter().map(|part| {
        // Why there is no doubling, the plan of the part says.
        doublings(&document.wireframe, part, start_in(part, start), further + 1).unwrap_or_default()
    });
    share_out(curves.collect(), further)
}

/// The doublings that the document has accepted, where they make a route possible from the wanted start or nothing
/// else was asked for; else the cheapest. Counts accepted ones that are not used.
pub(super) fn doubling_choice(
    document: &Document,
    component: &Component,
    choices: &PlanChoices,
    chosen: &WireChoice,
    (start, wires): (Option<VertexId>, usize),
    replaced: &mut usize,
) -> DoublingChoice {
    let here = |edge: &EdgeId| component.edges.binary_search(edge).is_ok();
    let accepted: Vec<EdgeId> = document.doublings.iter().copied().filter(here).collect();
    let odd = document.wireframe.odd_vertices(component, &accepted);
    // An open wire whose ends are odd begins at one of them.
    let begins = start.is_none_or(|start| odd.is_empty() || odd.contains(&start));
    if choices.double && (!begins || odd.len() > if chosen.closed { 0 } else { 2 * wires }) {
        *replaced += accepted.len();
        return DoublingChoice::Cheapest;
    }
    DoublingChoice::Accepted(accepted)
}
