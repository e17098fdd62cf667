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
    let together = Neighbours::of(wireframe).reached(wireframe, edge);
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
    if parts.is_empty() {
        return Vec::new();
    }
    let neighbours = Neighbours::of(before);
    let is_gone = |edge: EdgeId| delta.edges.get(&edge).is_some_and(|change| change.after.is_none());
    let mut after: Vec<PartLook> = Vec::with_capacity(parts.len());
    for part in parts {
        let edge = if is_gone(part.edge) {
            let together = neighbours.reached(before, part.edge);
            together.iter().copied().find(|edge| !is_gone(*edge)).or_else(|| drawn(before, &together, delta))
        } else {
            Some(part.edge)
        };
        after.extend(edge.map(|edge| PartLook { edge, look: part.look.clone() }));
    }
    if after.iter().any(|part| part.look.hidden) {
        show_joined(&mut after, before, delta);
    }
    after.sort_by_key(|part| part.edge);
    after
}

/// Shows a hidden part that was joined to one that is seen: that would vanish otherwise.
fn show_joined(parts: &mut [PartLook], before: &Wireframe, delta: &Delta) {
    let mut joined = before.clone();
    if joined.commit(delta).is_err() {
        return;
    }
    let (was, is) = (Neighbours::of(before), Neighbours::of(&joined));
    let hidden: Vec<EdgeId> = parts.iter().filter(|part| part.look.hidden).map(|part| part.edge).collect();
    let unseen: BTreeSet<EdgeId> = hidden.iter().flat_map(|edge| was.reached(before, *edge)).collect();
    for part in parts.iter_mut().filter(|part| part.look.hidden) {
        let together = is.reached(&joined, part.edge);
        part.look.hidden =
            !together.iter().any(|edge| before.edge(*edge).is_some() && !unseen.contains(edge));
    }
}

/// A new edge at a vertex of edges that are gone.
fn drawn(before: &Wireframe, gone: &[EdgeId], delta: &Delta) -> Option<EdgeId> {
    let ends: BTreeSet<VertexId> =
        gone.iter().filter_map(|edge| before.edge(*edge)).flat_map(|edge| [edge.a, edge.b]).collect();
    let made = delta.edges.iter().filter_map(|(id, change)| Some((id, change.after.as_ref()?)));
    made.filter(|(_, edge)| ends.contains(&edge.a) || ends.contains(&edge.b)).map(|(id, _)| *id).next()
}

/// The edges at each vertex.
struct Neighbours(BTreeMap<VertexId, Vec<EdgeId>>);

impl Neighbours {
    fn of(wireframe: &Wireframe) -> Self {
        let mut at: BTreeMap<VertexId, Vec<EdgeId>> = BTreeMap::new();
        for (id, edge) in wireframe.edges() {
            at.entry(edge.a).or_default().push(id);
            at.entry(edge.b).or_default().push(id);
        }
        Self(at)
    }

    /// All edges that hang together with one, the nearest first.
    fn reached(&self, wireframe: &Wireframe, from: EdgeId) -> Vec<EdgeId> {
        let (mut found, mut seen) = (vec![from], BTreeSet::from([from]));
        let mut left = BTreeSet::new();
        let mut next = 0;
        while let Some(edge) = found.get(next).and_then(|id| wireframe.edge(*id)) {
            next += 1;
            for end in [edge.a, edge.b] {
                if left.insert(end) {
                    found.extend(self.0.get(&end).into_iter().flatten().filter(|edge| seen.insert(**edge)));
                }
            }
        }
        found
    }
}
