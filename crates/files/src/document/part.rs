//! Parts of a design: struts that hang together. Their looks are kept by one edge of each.

use std::collections::{BTreeMap, BTreeSet};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::wireframe::{Delta, EdgeId, VertexId, Wireframe};

use super::look::Look;

/// How the part looks that an edge belongs to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PartLook {
    /// One edge of the part.
    pub edge: EdgeId,
    pub look: Look,
}

/// How the part of a wireframe looks that an edge belongs to: all struts that hang together with it.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Part")]
pub(crate) struct PartFile {
    /// One edge of it, by id.
    edge: u32,
    look: Look,
}

impl From<&PartLook> for PartFile {
    fn from(part: &PartLook) -> Self {
        Self { edge: part.edge.0, look: part.look.clone() }
    }
}

impl From<PartFile> for PartLook {
    fn from(part: PartFile) -> Self {
        Self { edge: EdgeId(part.edge), look: part.look }
    }
}

/// The looks of parts, with that of the part of `edge` replaced. A part that was joined from several had a look of each.
pub(super) fn with_look(
    parts: &[PartLook],
    wireframe: &Wireframe,
    edge: EdgeId,
    look: Look,
) -> Vec<PartLook> {
    let together = reached(wireframe, edge);
    let mut after: Vec<PartLook> =
        parts.iter().filter(|part| !together.contains(&part.edge)).cloned().collect();
    if look != Look::default() {
        after.push(PartLook { edge, look });
        after.sort_by_key(|part| part.edge);
    }
    after
}

/// The looks after an edit. One whose edge is gone goes to the nearest edge of its part that is left, or to one that was
/// drawn in its place; where nothing of the part is left, neither is its look.
pub(super) fn after_edit(parts: &[PartLook], before: &Wireframe, delta: &Delta) -> Vec<PartLook> {
    let is_gone = |edge: EdgeId| delta.edges.get(&edge).is_some_and(|change| change.after.is_none());
    let mut after: Vec<PartLook> = Vec::with_capacity(parts.len());
    for part in parts {
        let edge = if is_gone(part.edge) {
            let together = reached(before, part.edge);
            together.iter().copied().find(|edge| !is_gone(*edge)).or_else(|| drawn(before, &together, delta))
        } else {
            Some(part.edge)
        };
        after.extend(edge.map(|edge| PartLook { edge, look: part.look.clone() }));
    }
    after.sort_by_key(|part| part.edge);
    after
}

/// A new edge at a vertex of edges that are gone.
fn drawn(before: &Wireframe, gone: &[EdgeId], delta: &Delta) -> Option<EdgeId> {
    let ends: BTreeSet<VertexId> =
        gone.iter().filter_map(|edge| before.edge(*edge)).flat_map(|edge| [edge.a, edge.b]).collect();
    let made = delta.edges.iter().filter_map(|(id, change)| Some((id, change.after.as_ref()?)));
    made.filter(|(_, edge)| ends.contains(&edge.a) || ends.contains(&edge.b)).map(|(id, _)| *id).next()
}

/// All edges that hang together with one, the nearest first.
fn reached(wireframe: &Wireframe, from: EdgeId) -> Vec<EdgeId> {
    let mut at: BTreeMap<VertexId, Vec<EdgeId>> = BTreeMap::new();
    for (id, edge) in wireframe.edges() {
        at.entry(edge.a).or_default().push(id);
        at.entry(edge.b).or_default().push(id);
    }
    let (mut found, mut seen) = (vec![from], BTreeSet::from([from]));
    let mut next = 0;
    while let Some(edge) = found.get(next).and_then(|id| wireframe.edge(*id)) {
        next += 1;
        for end in [edge.a, edge.b] {
            // Each vertex is left once.
            for edge in at.remove(&end).unwrap_or_default() {
                if seen.insert(edge) {
                    found.push(edge);
                }
            }
        }
    }
    found
}
