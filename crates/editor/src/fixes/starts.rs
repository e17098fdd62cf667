//! For what depends on where the wire begins: another start.

use wirebend_core::checks::Remedy;
use wirebend_core::plan::WirePlan;
use wirebend_core::route::doubling;
use wirebend_core::wireframe::VertexId;
use wirebend_files::document::Document;

use super::super::EditRequest;
use super::trials::Trials;
use super::{Candidate, Finding, wires};

/// The most starts that are tried of a wire that may begin anywhere.
const MAX_STARTS: usize = 24;

/// No start, where the chosen one is refused.
pub(super) fn anywhere(finding: Finding, document: &Document) -> Vec<Candidate> {
    let here = |start: VertexId| {
        finding.wire.is_some_and(|wire| wire.component.vertices.binary_search(&start).is_ok())
    };
    let clear =
        Candidate { title: "Start point: automatic".to_owned(), edit: EditRequest::Start { vertex: None } };
    document.start.filter(|&start| here(start)).map(|_| clear).into_iter().collect()
}

/// The vertex of a bend that every route from elsewhere makes, with the edges that are doubled for a wire from there. Without a route
/// the start alone: which edges are doubled is asked next.
pub(super) fn there(finding: Finding, trials: &Trials) -> Option<Candidate> {
    let wire = finding.wire.filter(|wire| is_free_for(wire, trials))?;
    let vertex = *finding.diagnostic.location.vertices.first()?;
    let added = finding.diagnostic.remedies.iter().find_map(|remedy| match remedy {
        Remedy::StartAtVertex { added } => *added,
        _ => None,
    })?;
    let start = at(vertex);
    let document = trials.document();
    let edges = doubling(&document.wireframe, &wire.component, Some(vertex), false).ok()?.edges;
    if wire.route.is_none() || edges.is_empty() && wire.doubled.is_empty() {
        return Some(start);
    }
    let title = format!(
        "{}, run along {} instead of {}",
        start.title,
        wires::twice_changed(&edges, added, trials),
        wire.doubled.len()
    );
    let mut doubled = wires::doublings_elsewhere(document, &wire.component);
    doubled.extend(&edges);
    doubled.sort_unstable();
    let edits = vec![start.edit, wires::doublings(&doubled)];
    Some(Candidate {
        title,
        edit: EditRequest::Several { label: format!("start at vertex {vertex}"), edits },
    })
}

/// There is one start: that of another wire is not taken away.
fn is_free_for(wire: &WirePlan, trials: &Trials) -> bool {
    trials.document().start.is_none_or(|start| wire.component.vertices.binary_search(&start).is_ok())
}

fn at(start: VertexId) -> Candidate {
    Candidate {
        title: format!("Start at vertex {start}"),
        edit: EditRequest::Start { vertex: Some(start.0) },
    }
}

/// The same wire from its other end.
pub(super) fn reversed(document: &Document) -> Candidate {
    let edit = EditRequest::Reversed { reversed: !document.reversed };
    Candidate { title: "Bend from the other end".to_owned(), edit }
}

/// The start with the fewest errors, where that is fewer than there are; of collisions, which may be warnings, with the fewest findings.
pub(super) fn elsewhere(finding: Finding, trials: &mut Trials) -> Option<Candidate> {
    let wire = finding.wire.filter(|wire| is_free_for(wire, trials))?;
    let mut best: Option<((usize, usize), Candidate)> = None;
    for start in possible(trials.document(), wire, finding.diagnostic.location.vertices.first().copied()) {
        let candidate = at(start);
        let Some(trial) = trials.of(&candidate.edit) else { continue };
        let trouble = trials.trouble(&trial);
        if best.as_ref().is_none_or(|(least, _)| trouble < *least) {
            best = Some((trouble, candidate));
        }
    }
    let (trouble, candidate) = best?;
    (trouble < trials.trouble_now()).then_some(candidate)
}

/// Where a wire may begin: at an odd vertex, and where there is none at any.
fn possible(document: &Document, wire: &WirePlan, foremost: Option<VertexId>) -> Vec<VertexId> {
    let odd = document.wireframe.odd_vertices(&wire.component, &wire.doubled);
    let Some(route) = &wire.route else { return Vec::new() };
    let walk = route.vertices();
    let first = walk.first().copied();
    let mut starts: Vec<VertexId> = if odd.is_empty() {
        let every = walk.len().div_ceil(MAX_STARTS - 1).max(1);
        foremost.into_iter().chain(walk.into_iter().step_by(every)).collect()
    } else {
        odd
    };
    let mut seen = std::collections::BTreeSet::new();
    starts.retain(|id| Some(*id) != first && seen.insert(*id));
    starts.truncate(MAX_STARTS);
    starts
}
