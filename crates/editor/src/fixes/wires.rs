//! For odd vertices: edges laid twice, or several wires.

use std::collections::BTreeSet;

use wirebend_core::plan::WirePlan;
use wirebend_core::route::{RouteOptions, route};
use wirebend_core::wireframe::{Component, EdgeId, VertexId};
use wirebend_files::document::Document;

use super::super::EditRequest;
use super::trials::Trials;
use super::{Candidate, Finding, shown_mm};

/// More wires than these are no answer.
const MAX_WIRES: usize = 6;

/// The cheapest edges twice, or as many wires as it takes to lay none twice.
pub(super) fn candidates(finding: Finding, trials: &Trials) -> Vec<Candidate> {
    let Some(wire) = finding.wire else { return Vec::new() };
    let mut found: Vec<Candidate> = doubled(wire, trials).into_iter().collect();
    found.extend(apart(finding, trials.document()));
    found
}

fn doubled(wire: &WirePlan, trials: &Trials) -> Option<Candidate> {
    let proposal = &wire.proposal;
    if proposal.edges.is_empty() {
        return None;
    }
    // What is accepted for other wires stays accepted.
    let mut edges: Vec<EdgeId> = doublings_elsewhere(trials.document(), &wire.component);
    edges.extend(&proposal.edges);
    edges.sort_unstable();
    let count = match proposal.edges.len() {
        1 => "1 edge".to_owned(),
        count => format!("{count} edges"),
    };
    let cost = trials.price(proposal.added).map_or_else(String::new, |price| format!(", +{price}"));
    Some(Candidate {
        title: format!("Double {count} (+{}{cost})", shown_mm(proposal.added.mm())),
        edit: EditRequest::Doublings { edges: edges.iter().map(|id| id.0).collect() },
    })
}

fn doublings_elsewhere(document: &Document, component: &Component) -> Vec<EdgeId> {
    let elsewhere = |edge: &&EdgeId| component.edges.binary_search(edge).is_err();
    document.doublings.iter().filter(elsewhere).copied().collect()
}

/// A wire for every two odd vertices, each of which begins or ends one. No edge is laid twice.
pub(super) fn apart(finding: Finding, document: &Document) -> Option<Candidate> {
    let component = &finding.wire?.component;
    let trails = trails(document, component)?;
    let (_, off) = trails.split_first()?;
    let mut edits = Vec::new();
    let elsewhere = doublings_elsewhere(document, component);
    if elsewhere.len() < document.doublings.len() {
        edits.push(EditRequest::Doublings { edges: elsewhere.iter().map(|id| id.0).collect() });
    }
    if document.start.is_some_and(|start| component.vertices.binary_search(&start).is_ok()) {
        edits.push(EditRequest::Start { vertex: None });
    }
    edits.extend(off.iter().map(|trail| EditRequest::Detach { edges: trail.clone() }));
    let count = trails.len();
    Some(Candidate {
        title: format!("Divide it into {count} wires, none doubled"),
        edit: together(edits, format!("split into {count} wires"))?,
    })
}

/// One edit as it is, several as one.
pub(super) fn together(mut edits: Vec<EditRequest>, label: String) -> Option<EditRequest> {
    match edits.len() {
        0 => None,
        1 => edits.pop(),
        _ => Some(EditRequest::Several { label, edits }),
    }
}

/// The edges of a component as trails that begin and end at odd vertices, each edge in one of them; none where one is
/// enough, or too many are needed.
///
/// With lines between odd vertices that are none of the design, one walk covers everything. Where it runs along such a
/// line, one trail ends and the next begins.
fn trails(document: &Document, component: &Component) -> Option<Vec<Vec<u32>>> {
    let odd = document.wireframe.odd_vertices(component, &[]);
    if odd.len() < 4 || odd.len() / 2 > MAX_WIRES {
        return None;
    }
    let mut joined = document.wireframe.clone();
    let mut whole = component.clone();
    let mut lines = BTreeSet::new();
    for (a, b) in nearest_pairs(document, &odd) {
        let line = joined.add_edge(a, b).ok()?;
        whole.edges.push(line);
        lines.insert(line);
    }
    let walk = route(&joined, &whole, &RouteOptions::default()).ok()?;
    let parts = walk.traversals.split(|traversal| lines.contains(&traversal.edge));
    let trails: Vec<Vec<u32>> = parts
        .map(|part| part.iter().map(|traversal| traversal.edge.0).collect())
        .filter(|trail: &Vec<u32>| !trail.is_empty())
        .collect();
    Some(trails)
}

/// Pairs of odd vertices, nearest first, until two are left.
fn nearest_pairs(document: &Document, odd: &[VertexId]) -> Vec<(VertexId, VertexId)> {
    let at = |id: VertexId| document.wireframe.vertex(id).map(|vertex| vertex.position);
    let mut left = odd.to_vec();
    let mut pairs = Vec::new();
    while left.len() > 2 {
        let apart = |a: VertexId, b: VertexId| match (at(a), at(b)) {
            (Some(a), Some(b)) => (a - b).norm(),
            _ => f64::INFINITY,
        };
        let all = (0..left.len()).flat_map(|j| (0..j).map(move |k| (k, j)));
        let Some((k, j)) =
            all.min_by(|&(a, b), &(c, d)| apart(left[a], left[b]).total_cmp(&apart(left[c], left[d])))
        else {
            break;
        };
        pairs.push((left[k], left[j]));
        left.remove(j);
        left.remove(k);
    }
    pairs
}
