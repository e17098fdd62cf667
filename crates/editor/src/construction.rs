//! Construction lines of a design: made of edges, made edges of, and deleted.

use std::collections::BTreeSet;

use nalgebra::Point3;
use wirebend_core::units::Length;
use wirebend_core::wireframe::{Delta, EdgeId, Edit, VertexId, Wireframe};
use wirebend_files::document::{ConstructionLine, Document, DocumentChange};

use crate::{ConstructionChange, EditorError};

/// The difference that a change of construction lines makes; none where it changes nothing.
pub(super) fn changed(
    document: &Document,
    change: &ConstructionChange,
    weld: Length,
) -> Result<Option<DocumentChange>, EditorError> {
    match change {
        ConstructionChange::Lines { edges } => from_edges(document, edges),
        ConstructionChange::Edges { lines } => to_edges(document, lines, weld),
        ConstructionChange::Nothing { lines } => Ok(document.set_construction(taken(document, lines)?.1)),
    }
}

/// Edges become construction lines, and vertices without any other edge go.
fn from_edges(document: &Document, edges: &[u32]) -> Result<Option<DocumentChange>, EditorError> {
    let wireframe = &document.wireframe;
    let edges: BTreeSet<EdgeId> = edges.iter().copied().map(EdgeId).collect();
    let mut lines = document.construction.clone();
    let mut ends = BTreeSet::new();
    for &id in &edges {
        let edge = wireframe.edge(id).ok_or(EditorError::NoConstructionEdge(id.0))?;
        let at = |id| wireframe.vertex(id).map(|vertex| vertex.position);
        let (Some(a), Some(b)) = (at(edge.a), at(edge.b)) else { continue };
        lines.push(ConstructionLine { ends: [a, b] });
        ends.extend([edge.a, edge.b]);
    }
    let bare = |id: &VertexId| wireframe.incident(*id).iter().all(|edge| edges.contains(edge));
    let vertices = ends.into_iter().filter(bare).collect();
    let mut scratch = wireframe.clone();
    let delta = scratch.apply(&Edit::Delete { vertices, edges: edges.into_iter().collect() })?;
    let change = DocumentChange::of_edit(document, delta);
    Ok(document.set_construction(lines).map(|lines| change.and(lines)))
}

/// Construction lines become edges, joined to vertices that are there. One that an edge lies on already only goes.
fn to_edges(document: &Document, lines: &[u32], weld: Length) -> Result<Option<DocumentChange>, EditorError> {
    let (taken, left) = taken(document, lines)?;
    let mut scratch = document.wireframe.clone();
    let mut delta = Delta::none(&document.wireframe);
    for ConstructionLine { ends: [from, to] } in taken {
        let (first, last) = (vertex_at(&scratch, from, weld), vertex_at(&scratch, to, weld));
        let is_there = first.zip(last).is_some_and(|(a, b)| {
            a == b || scratch.edges().any(|(_, edge)| [(a, b), (b, a)].contains(&(edge.a, edge.b)))
        });
        if is_there {
            continue;
        }
        let new = [first.is_none().then_some(from), last.is_none().then_some(to)];
        let through = new.into_iter().flatten().collect();
        delta = delta.then(&scratch.apply(&Edit::Draw { from: first, through, to: last })?);
    }
    let change = DocumentChange::of_edit(document, delta);
    Ok(document.set_construction(left).map(|lines| change.and(lines)))
}

/// The lines at places of the list, and the rest.
fn taken(
    document: &Document,
    lines: &[u32],
) -> Result<(Vec<ConstructionLine>, Vec<ConstructionLine>), EditorError> {
    let all = &document.construction;
    let is_there = |line: &&u32| usize::try_from(**line).is_ok_and(|line| line < all.len());
    if let Some(&missing) = lines.iter().find(|line| !is_there(line)) {
        return Err(EditorError::NoConstructionLine { line: missing, count: all.len() });
    }
    let lines: BTreeSet<u32> = lines.iter().copied().collect();
    let (taken, left): (Vec<_>, Vec<_>) = (0..).zip(all).partition(|(place, _)| lines.contains(place));
    let alone = |lines: Vec<(u32, &ConstructionLine)>| lines.into_iter().map(|(_, line)| *line).collect();
    Ok((alone(taken), alone(left)))
}

/// The nearest vertex that is as good as there.
fn vertex_at(wireframe: &Wireframe, at: Point3<f64>, weld: Length) -> Option<VertexId> {
    let apart =
        |(id, vertex): (VertexId, wirebend_core::wireframe::Vertex)| ((vertex.position - at).norm(), id);
    let nearest = wireframe.vertices().map(apart).min_by(|a, b| a.0.total_cmp(&b.0))?;
    (nearest.0 <= weld.mm()).then_some(nearest.1)
}
