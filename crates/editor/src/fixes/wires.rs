//! For odd vertices: edges laid twice, or several wires; for bends that no route avoids: a detour.

use wirebend_core::checks::Remedy;
use wirebend_core::plan::WirePlan;
use wirebend_core::route::Share;
use wirebend_core::units::Length;
use wirebend_core::wireframe::{Component, EdgeId};
use wirebend_files::document::Document;

use super::super::EditRequest;
use super::trials::Trials;
use super::{Candidate, Finding, shown_mm};

/// The cheapest edges twice, or some more wires, as far as they save something.
pub(super) fn candidates(finding: Finding, trials: &Trials) -> Vec<Candidate> {
    let Some(wire) = finding.wire else { return Vec::new() };
    let mut found: Vec<Candidate> = doubled(wire, trials).into_iter().collect();
    found.extend(trials.further_wires().iter().map(|shares| several(shares, trials)));
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
    Some(Candidate {
        title: format!("Run the wire along {}", twice_priced(&proposal.edges, proposal.added, trials)),
        edit: doublings(&edges),
    })
}

/// "3 edges twice (+90.0 mm, +$0.18)".
pub(super) fn twice_priced(edges: &[EdgeId], length: Length, trials: &Trials) -> String {
    let cost = trials.price(length).map_or_else(String::new, |price| format!(", +{price}"));
    twice(edges, length, &cost)
}

/// The same where it takes the place of others: by how much the length and its price change.
pub(super) fn twice_changed(edges: &[EdgeId], change: Length, trials: &Trials) -> String {
    if change.mm().abs() < NO_LENGTH_MM {
        return format!("{} twice (no more length)", count(edges));
    }
    let sign = if change > Length::ZERO { '+' } else { '\u{2212}' };
    let cost = trials.price(change.abs()).map_or_else(String::new, |price| format!(", {sign}{price}"));
    format!("{} twice ({sign}{}{cost})", count(edges), shown_mm(change.abs().mm()))
}

/// Less is none, mm.
const NO_LENGTH_MM: f64 = 0.05;

fn twice(edges: &[EdgeId], length: Length, cost: &str) -> String {
    format!("{} twice (+{}{cost})", count(edges), shown_mm(length.mm()))
}

fn count(edges: &[EdgeId]) -> String {
    match edges.len() {
        1 => "1 edge".to_owned(),
        count => format!("{count} edges"),
    }
}

pub(super) fn doublings(edges: &[EdgeId]) -> EditRequest {
    EditRequest::Doublings { edges: edges.iter().map(|id| id.0).collect() }
}

pub(super) fn doublings_elsewhere(document: &Document, component: &Component) -> Vec<EdgeId> {
    let elsewhere = |edge: &&EdgeId| component.edges.binary_search(edge).is_err();
    document.doublings.iter().filter(elsewhere).copied().collect()
}

fn several(shares: &[Share], trials: &Trials) -> Candidate {
    let wires: usize = shares.iter().map(|share| share.wires).sum();
    let doubled = shares.iter().filter_map(|share| share.doubling.as_ref());
    let length: Length = doubled.clone().map(|doubling| doubling.added).sum();
    let edges: Vec<EdgeId> = doubled.flat_map(|doubling| doubling.edges.iter().copied()).collect();
    let less = match edges.as_slice() {
        [] => "no doubled edges".to_owned(),
        // What the tails of more wires cost is in the totals beside it.
        edges => format!("run along {}", twice(edges, length, "")),
    };
    let kind = if trials.document().closed { "open wires" } else { "wires" };
    Candidate {
        title: format!("Split into {wires} {kind}, {less}"),
        edit: EditRequest::Several {
            label: format!("split into {wires} wires"),
            edits: vec![
                EditRequest::Wires { wires: u32::try_from(wires).unwrap_or(u32::MAX) },
                doublings(&edges),
            ],
        },
    }
}

/// As many wires as it takes to double no edge.
pub(super) fn none_doubled(trials: &Trials) -> Option<Candidate> {
    let shares = trials.further_wires().last()?;
    let is_none = |share: &Share| share.doubling.as_ref().is_none_or(|doubling| doubling.edges.is_empty());
    shares.iter().all(is_none).then(|| several(shares, trials))
}

/// Edges laid twice so that the wire comes back to a vertex another way.
pub(super) fn detour(finding: Finding, trials: &Trials) -> Option<Candidate> {
    let wire = finding.wire?;
    let (around, length) = finding.diagnostic.remedies.iter().find_map(|remedy| match remedy {
        Remedy::Detour { edges, added } => Some((edges, added)),
        _ => None,
    })?;
    let document = trials.document();
    let mut edges = if wire.route.is_some() {
        document.doublings.clone()
    } else {
        // It goes around what is proposed.
        [doublings_elsewhere(document, &wire.component), wire.proposal.edges.clone()].concat()
    };
    edges.extend(around);
    edges.sort_unstable();
    let title = format!("Take a detour: run along {}", twice_priced(around, *length, trials));
    Some(Candidate { title, edit: doublings(&edges) })
}
