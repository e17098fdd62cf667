//! What to draw of a fix before it is made.

use std::collections::BTreeSet;

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_core::plan::WirePlan;
use wirebend_core::wireframe::{Edge, EdgeId, VertexId, Wireframe};
use wirebend_files::document::Document;

use super::super::{EditRequest, Moved};
use super::trials::Trial;

/// What a fix would change in the drawing. Positions in mm.
#[derive(Debug, Clone, PartialEq, Default, Serialize, JsonSchema)]
pub struct FixPreview {
    /// Vertices at their new places.
    pub moved: Vec<Moved>,
    /// Edges that would be laid twice.
    pub doubled: Vec<u32>,
    /// Edges that would go.
    pub gone_edges: Vec<u32>,
    /// Lines that would be new.
    pub new_edges: Vec<[[f64; 3]; 2]>,
    /// Edges that would be detached from the others, or bent from further wires.
    pub detached: Vec<Vec<u32>>,
}

impl FixPreview {
    pub(super) fn of(document: &Document, edit: &EditRequest, after: &Trial) -> Self {
        let (wireframe, change) = (&document.wireframe, &after.change);
        let mut preview = Self::default();
        for (id, change) in &change.wireframe.vertices {
            if let (Some(before), Some(after)) = (change.before, change.after)
                && before.position != after.position
            {
                preview.moved.push(Moved { vertex: id.0, at_mm: after.position.coords.into() });
            }
        }
        let was = |id: VertexId| wireframe.vertex(id).map(|vertex| vertex.position);
        let is = |id: VertexId| match change.wireframe.vertices.get(&id) {
            Some(change) => change.after.map(|vertex| vertex.position),
            None => was(id),
        };
        let drawn = |edge: Edge| Some([is(edge.a)?, is(edge.b)?]);
        for (id, change) in &change.wireframe.edges {
            match (change.before, change.after) {
                (Some(_), None) => preview.gone_edges.push(id.0),
                // An edge that only got vertices of its own is where it was.
                (before, Some(after)) => {
                    let before = before.and_then(|edge| Some([was(edge.a)?, was(edge.b)?]));
                    let line = drawn(after).filter(|line| Some(*line) != before);
                    preview.new_edges.extend(line.map(|line| line.map(|point| point.coords.into())));
                }
                (None, None) => {}
            }
        }
        if let Some(doublings) = &change.doublings {
            // An edge may be listed once for each further pass.
            let mut before = doublings.before.clone();
            let is_new = |id: &&EdgeId| match before.iter().position(|old| old == *id) {
                Some(at) => {
                    before.swap_remove(at);
                    false
                }
                None => true,
            };
            preview.doubled = doublings.after.iter().filter(is_new).map(|id| id.0).collect();
            preview.doubled.dedup();
        }
        preview.detached = detached(edit);
        if change.wires.is_some() && preview.detached.is_empty() {
            preview.detached = further_wires(wireframe, &after.wires);
        }
        preview
    }
}

/// The edges of each wire but the first of a part, where the parts are what they were.
fn further_wires(wireframe: &Wireframe, wires: &[WirePlan]) -> Vec<Vec<u32>> {
    let parts = wireframe.components();
    let mut begun = BTreeSet::new();
    let mut is_further = |wire: &&WirePlan| {
        let first = wire.component.edges.first();
        let part =
            parts.iter().position(|part| first.is_some_and(|edge| part.edges.binary_search(edge).is_ok()));
        !begun.insert(part)
    };
    let further = wires.iter().filter(&mut is_further);
    further.map(|wire| wire.component.edges.iter().map(|id| id.0).collect()).collect()
}

fn detached(edit: &EditRequest) -> Vec<Vec<u32>> {
    match edit {
        EditRequest::Detach { edges } => vec![edges.clone()],
        EditRequest::Several { edits, .. } => edits.iter().flat_map(detached).collect(),
        _ => Vec::new(),
    }
}
