//! Edges that come closer than the wire is thick where nothing joins them.
//!
//! No route and no machine is asked: what is too close here is too close in the finished part. Vertices within the weld
//! tolerance of each other, edges between the same vertices and folds have checks of their own.

mod close;

use std::collections::BTreeMap;

use close::{Close, Layout};

use super::Design;
use crate::checks::{Diagnostic, Fact, Location, Remedy, Severity};
use crate::units::Length;
use crate::wireframe::{EdgeId, VertexId};

/// Where two edges come close, on one of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Place {
    /// Within the diameter of a vertex: whatever edges it has, they are close there together.
    Vertex(VertexId),
    /// Between its vertices.
    Edge(EdgeId),
}

pub(super) fn check(design: &Design, found: &mut Vec<Diagnostic>) {
    find(design, GivesWay::FreeEnds, found);
}

/// The same of struts that are not bent: where they run through each other nothing gives way.
pub(super) fn check_rigid(design: &Design, found: &mut Vec<Diagnostic>) {
    find(design, GivesWay::Nothing, found);
}

/// What is pushed aside where two edges run through each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum GivesWay {
    /// The free end of a wire, and vertices that meet, which are passed like one.
    FreeEnds,
    Nothing,
}

fn find(design: &Design, gives_way: GivesWay, found: &mut Vec<Diagnostic>) {
    let diameter = design.diameter.mm();
    if diameter <= 0.0 {
        return;
    }
    let layout = Layout::of(design.wireframe, design.weld_tolerance);
    // One finding for each place, of the two edges that are closest there.
    let mut closest: BTreeMap<[Place; 2], Close> = BTreeMap::new();
    for close in layout.close(diameter) {
        let close = layout.middle(&close, diameter).unwrap_or(close);
        let mut places = [0, 1].map(|side| place(&layout, &close, side, diameter));
        places.sort_unstable();
        let kept = closest.entry(places).or_insert(close);
        if close.distance < kept.distance {
            *kept = close;
        }
    }
    let mut kept: Vec<Close> = closest.into_values().collect();
    kept.sort_by_key(|close| close.edges);
    found.extend(kept.iter().map(|close| finding(design, &layout, close, gives_way)));
}

fn place(layout: &Layout, close: &Close, side: usize, diameter: f64) -> Place {
    match layout.end_within(close, side, diameter) {
        Some(vertex) => Place::Vertex(vertex),
        None => Place::Edge(layout.ids[close.edges[side]]),
    }
}

fn finding(design: &Design, layout: &Layout, close: &Close, gives_way: GivesWay) -> Diagnostic {
    let reach = design.diameter.mm();
    let near = [0, 1].map(|side| layout.end_within(close, side, reach));
    // A wire through another cannot be.
    let gives_way = gives_way == GivesWay::FreeEnds
        && match [0, 1].map(|side| layout.edges_at_end(close, side, reach)) {
            [Some(_), Some(_)] => true,
            [Some(edges), None] | [None, Some(edges)] => edges < 2,
            [None, None] => false,
        };
    let through = close.distance < reach / 2.0;
    let severity = if through && !gives_way { Severity::Error } else { Severity::Warning };
    let join = if near.iter().all(Option::is_some) { Remedy::MergeVertices } else { Remedy::JoinEdges };
    let fasten = (severity == Severity::Warning).then_some(Remedy::FastenThere);
    let edges = close.edges.map(|edge| layout.ids[edge]);
    Diagnostic {
        severity,
        location: Location {
            vertices: near.into_iter().flatten().collect(),
            edges: edges.to_vec(),
            step: None,
        },
        fact: Fact::EdgesMeet {
            edges,
            near,
            from: close.edges.map(|edge| layout.first_vertex(edge)),
            along: [0, 1].map(|side| Length::computed(layout.along(close, side))),
            distance: Length::computed(close.distance),
            diameter: design.diameter,
            closing: None,
        },
        remedies: fasten.into_iter().chain([join, Remedy::MoveApart]).collect(),
    }
}

#[cfg(test)]
mod tests;
