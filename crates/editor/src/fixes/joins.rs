//! For edges that come too close: a vertex that joins them where they meet, or room between them.

use nalgebra::{Point3, Vector3};
use wirebend_core::checks::Fact;
use wirebend_core::wireframe::{EdgeId, VertexId, Wireframe};
use wirebend_files::document::Document;

use super::super::{EditRequest, MergePlace};
use super::drawing::merged;
use super::lengths::move_vertex;
use super::{Candidate, Finding, shown_mm};

/// How much farther apart than the wire is thick, so that rounding does not let them touch again; mm.
const MARGIN_MM: f64 = 0.05;

/// What parts or joins two edges.
pub(super) fn candidates(finding: Finding, document: &Document) -> Vec<Candidate> {
    let Fact::EdgesMeet { edges, near, along, distance, diameter, .. } = finding.diagnostic.fact else {
        return Vec::new();
    };
    let wireframe = &document.wireframe;
    let lengths = edges.map(|edge| wireframe.edge_length(edge).mm());
    let parts = [along[0].mm() / lengths[0], along[1].mm() / lengths[1]];
    let joined = match near {
        [Some(one), Some(other)] => (one != other).then(|| merged(one.0.min(other.0), one.0.max(other.0))),
        [Some(vertex), None] => Some(onto_vertex(wireframe, vertex, edges[1], parts[1])),
        [None, Some(vertex)] => Some(onto_vertex(wireframe, vertex, edges[0], parts[0])),
        [None, None] => Some(at_crossing(wireframe, edges, parts)),
    };
    let missing = diameter.mm() - distance.mm() + MARGIN_MM;
    let away = way_apart(wireframe, edges, parts).map(|way| way * missing);
    let apart = away.into_iter().flat_map(|away| {
        // The second lies ahead, the first one behind.
        [(1, away), (0, -away)].into_iter().filter_map(move |(side, by)| match near[side] {
            Some(vertex) => moved_vertex(wireframe, vertex, by),
            None => moved_edge(wireframe, edges[side], by),
        })
    });
    joined.into_iter().chain(apart).collect()
}

/// An edge split where a vertex lies on it, and drawn to the vertex.
fn onto_vertex(wireframe: &Wireframe, vertex: VertexId, edge: EdgeId, at: f64) -> Candidate {
    let new = wireframe.next_ids().vertex;
    Candidate {
        title: format!("Join edge {edge} to vertex {vertex}"),
        edit: EditRequest::Several {
            label: format!("join edge {edge} to vertex {vertex}"),
            edits: vec![
                EditRequest::Split { edge: edge.0, at },
                EditRequest::Merge { vertices: vec![vertex.0, new], at: MergePlace::First },
            ],
        },
    }
}

/// Two edges split where they cross, with one vertex for both.
fn at_crossing(wireframe: &Wireframe, edges: [EdgeId; 2], parts: [f64; 2]) -> Candidate {
    let new = wireframe.next_ids().vertex;
    let [one, other] = edges;
    let split = |side: usize| EditRequest::Split { edge: edges[side].0, at: parts[side] };
    Candidate {
        title: format!("Join edges {one} and {other} with a vertex"),
        edit: EditRequest::Several {
            label: format!("join edges {one} and {other}"),
            edits: vec![
                split(0),
                split(1),
                EditRequest::Merge { vertices: vec![new, new.saturating_add(1)], at: MergePlace::Centre },
            ],
        },
    }
}

/// The direction from the place on the first edge to that on the second; across both where they go through each other.
fn way_apart(wireframe: &Wireframe, edges: [EdgeId; 2], parts: [f64; 2]) -> Option<Vector3<f64>> {
    let [one, other] = [0, 1].map(|side| ends(wireframe, edges[side]));
    let ([a, b], [c, d]) = (one?, other?);
    let (along, across) = (b - a, d - c);
    let between = (c + across * parts[1]) - (a + along * parts[0]);
    let normal = along.cross(&across);
    let side = if normal.dot(&between) < 0.0 { -normal } else { normal };
    [between, side].into_iter().find_map(|way| way.try_normalize(1e-6))
}

fn ends(wireframe: &Wireframe, edge: EdgeId) -> Option<[Point3<f64>; 2]> {
    let edge = wireframe.edge(edge)?;
    Some([wireframe.vertex(edge.a)?.position, wireframe.vertex(edge.b)?.position])
}

/// A vertex moved away. What the design holds fixed is not moved.
fn moved_vertex(wireframe: &Wireframe, id: VertexId, by: Vector3<f64>) -> Option<Candidate> {
    wireframe.vertex(id).is_some_and(|vertex| !vertex.support).then(|| move_vertex(id, by))
}

fn moved_edge(wireframe: &Wireframe, id: EdgeId, by: Vector3<f64>) -> Option<Candidate> {
    let edge = wireframe.edge(id)?;
    let free = |end| wireframe.vertex(end).is_some_and(|vertex| !vertex.support);
    (free(edge.a) && free(edge.b)).then(|| Candidate {
        title: format!("Move edge {id} by {}", shown_mm(by.norm())),
        edit: EditRequest::Move { vertices: vec![edge.a.0, edge.b.0], lines: Vec::new(), by_mm: by.into() },
    })
}
