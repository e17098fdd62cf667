//! For what one wire cannot do: two or more that touch where it was cut.

use std::collections::BTreeMap;

use wirebend_core::checks::{Code, Quantity};
use wirebend_core::plan::WirePlan;
use wirebend_core::route::Traversal;
use wirebend_core::wireframe::{EdgeId, Wireframe};
use wirebend_files::document::Document;

use super::super::EditRequest;
use super::trials::Trials;
use super::{Candidate, Finding};

/// More wires than these are no answer.
const MAX_PARTS: usize = 12;

/// Two wires that meet at the bend of a step.
pub(super) fn at_step(finding: Finding, document: &Document) -> Option<Candidate> {
    let wire = finding.wire?;
    let span = wire.nominal.as_ref()?.spans.get(finding.diagnostic.location.step?)?;
    cut(document, wire, &[span.end])
}

/// Wires of about the same length, as few as fit the stock.
pub(super) fn into_equal_parts(finding: Finding, trials: &mut Trials) -> Option<Candidate> {
    let wire = finding.wire?;
    let (Quantity::Length(needed), Quantity::Length(limit)) =
        (finding.diagnostic.measured()?, finding.diagnostic.limit()?.value)
    else {
        return None;
    };
    let feed = wire.compensated.as_ref()?.feed_total();
    let room = (limit - (needed - feed)).mm();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // saturates
    let parts = (feed.mm() / room).ceil().max(2.0) as usize;
    if room <= 0.0 || parts > MAX_PARTS {
        return None;
    }
    // Where vertices are far apart, one more may be needed.
    (parts..=parts + 1).find_map(|parts| {
        let document = trials.document();
        let candidate = cut(document, wire, &near_fractions(&document.wireframe, wire, parts))?;
        let trial = trials.of(&candidate.edit)?;
        let all_fit = trial.diagnostics().all(|diagnostic| diagnostic.code() != Code::StockTooLong);
        all_fit.then_some(candidate)
    })
}

/// Two wires that meet in the middle of a straight part: between its edges, or on its only one, which is split.
pub(super) fn within_step(finding: Finding, document: &Document) -> Option<Candidate> {
    let wire = finding.wire?;
    let span = wire.nominal.as_ref()?.spans.get(finding.diagnostic.location.step?)?.clone();
    let traversals = &wire.route.as_ref()?.traversals;
    let length =
        |of: &[Traversal]| -> f64 { of.iter().map(|t| document.wireframe.edge_length(t.edge).mm()).sum() };
    let straight = traversals.get(span.clone())?;
    if let [only] = straight {
        return split(document, wire, span.start, only);
    }
    let half = length(straight) / 2.0;
    let off_middle = |at: &usize| (length(&straight[..at - span.start]) - half).abs();
    let at = (span.start + 1..span.end).min_by(|a, b| off_middle(a).total_cmp(&off_middle(b)))?;
    cut(document, wire, &[at])
}

fn split(document: &Document, wire: &WirePlan, at: usize, only: &Traversal) -> Option<Candidate> {
    let traversals = &wire.route.as_ref()?.traversals;
    let (head, tail) = (traversals.get(..at)?, traversals.get(at + 1..)?);
    if !apart(head, tail) || !apart(head, &[*only]) || !apart(&[*only], tail) {
        return None;
    }
    let next = document.wireframe.next_ids();
    // The part from the edge's first vertex on keeps its id.
    let forward = document.wireframe.edge(only.edge)?.a == only.from;
    let behind = if forward { next.edge } else { only.edge.0 };
    let rest = tail.iter().map(|t| t.edge.0);
    let mut edges: Vec<u32> = std::iter::once(behind).chain(rest).collect();
    edges.sort_unstable();
    edges.dedup();
    let mut edits = vec![EditRequest::Split { edge: only.edge.0, at: 0.5 }, EditRequest::Detach { edges }];
    edits.extend(more_wires(document, 1));
    Some(Candidate {
        title: format!("Split edge {} in the middle, into two wires", only.edge),
        edit: together(edits, "split into 2 wires".to_owned())?,
    })
}

/// Wires of a route, cut before some of its traversals. None where an edge would belong to two.
fn cut(document: &Document, wire: &WirePlan, before: &[usize]) -> Option<Candidate> {
    let traversals = &wire.route.as_ref()?.traversals;
    if before.is_empty() || !before.iter().all(|&at| divides(traversals, at)) {
        return None;
    }
    let ends: Vec<usize> = before.iter().copied().skip(1).chain([traversals.len()]).collect();
    let mut edits = Vec::new();
    for (&from, &to) in before.iter().zip(&ends) {
        let mut edges: Vec<u32> = traversals.get(from..to)?.iter().map(|t| t.edge.0).collect();
        edges.sort_unstable();
        edges.dedup();
        edits.push(EditRequest::Detach { edges });
    }
    edits.extend(more_wires(document, before.len()));
    let vertices: Vec<String> =
        before.iter().filter_map(|&at| traversals.get(at)).map(|t| t.from.to_string()).collect();
    let title = match vertices.as_slice() {
        [only] => format!("Split at vertex {only} into two wires"),
        [first @ .., last] => {
            format!("Split at vertices {} and {last} into {} wires", first.join(", "), vertices.len() + 1)
        }
        [] => return None,
    };
    // A start that a person has chosen stays with the first wire, which keeps its vertices.
    let label = format!("split into {} wires", vertices.len() + 1);
    Some(Candidate { title, edit: together(edits, label)? })
}

/// A wire for each piece that is cut off, where a design is bent from several: the others keep theirs.
fn more_wires(document: &Document, pieces: usize) -> Option<EditRequest> {
    let wires = document.wires.get();
    let all = u32::try_from(wires + pieces).ok()?;
    (wires > 1).then_some(EditRequest::Wires { wires: all })
}

/// Whether a route can be cut before a traversal: something is on both sides, and no edge on both.
fn divides(traversals: &[Traversal], at: usize) -> bool {
    let (head, tail) = traversals.split_at(at.min(traversals.len()));
    !head.is_empty() && apart(head, tail)
}

/// Whether no edge is travelled in both parts of a route.
fn apart(head: &[Traversal], tail: &[Traversal]) -> bool {
    tail.iter().all(|t| !t.again || head.iter().all(|h| h.edge != t.edge))
}

/// The places nearest to equal parts of a route at which it can be cut.
fn near_fractions(wireframe: &Wireframe, wire: &WirePlan, parts: usize) -> Vec<usize> {
    let Some(route) = &wire.route else { return Vec::new() };
    let mut last_of: BTreeMap<EdgeId, usize> = BTreeMap::new();
    for (k, traversal) in route.traversals.iter().enumerate() {
        last_of.insert(traversal.edge, k);
    }
    // Every place with the length up to there, where no edge before it comes again.
    let (mut places, mut length, mut open_until) = (Vec::new(), 0.0, 0);
    for (k, traversal) in route.traversals.iter().enumerate() {
        if k > 0 && open_until < k {
            places.push((k, length));
        }
        length += wireframe.edge_length(traversal.edge).mm();
        open_until = open_until.max(last_of.get(&traversal.edge).copied().unwrap_or(k));
    }
    let mut cuts = Vec::new();
    for part in 1..parts {
        #[allow(clippy::cast_precision_loss)] // a dozen at most
        let wanted = length * part as f64 / parts as f64;
        let off = |place: &&(usize, f64)| (place.1 - wanted).abs();
        let nearest = places.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
        cuts.extend(nearest.map(|place| place.0).filter(|at| cuts.last() < Some(at)));
    }
    cuts
}

/// One edit as it is, several as one.
fn together(mut edits: Vec<EditRequest>, label: String) -> Option<EditRequest> {
    match edits.len() {
        0 => None,
        1 => edits.pop(),
        _ => Some(EditRequest::Several { label, edits }),
    }
}
