//! Construction lines of a design: made of edges, made edges of, and deleted.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::Point3;
use wirebend_core::units::Length;
use wirebend_core::wireframe::{Delta, EdgeId, Edit, Vertex, VertexId};
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

/// Construction lines become edges, joined to vertices that are there. One that an edge lies on already only goes; one that is shorter than
/// what is joined stays.
fn to_edges(document: &Document, lines: &[u32], weld: Length) -> Result<Option<DocumentChange>, EditorError> {
    let (taken, mut left) = taken(document, lines)?;
    let wireframe = &document.wireframe;
    let mut places = Places::new(weld);
    for (id, vertex) in wireframe.vertices() {
        places.add(vertex.position, End::Old(id));
    }
    let old = wireframe.edges().map(|(_, edge)| pair(End::Old(edge.a), End::Old(edge.b)));
    let mut drawn: BTreeSet<(End, End)> = old.collect();
    let (mut new, mut among_new, mut joining) = (Vec::new(), Vec::new(), Vec::new());
    for line in taken {
        let [a, b] = line.ends.map(|at| {
            places.find(at).unwrap_or_else(|| {
                let end = End::New(new.len());
                new.push(Vertex::at(at));
                places.add(at, end);
                end
            })
        });
        if a == b {
            left.push(line);
        } else if drawn.insert(pair(a, b)) {
            match (a, b) {
                (End::New(a), End::New(b)) => among_new.push((a, b)),
                ends => joining.push(ends),
            }
        }
    }
    let mut scratch = wireframe.clone();
    let first = wireframe.next_ids().vertex;
    let mut delta = Delta::none(wireframe);
    if !new.is_empty() {
        delta = delta.then(&scratch.apply(&Edit::Paste { vertices: new, edges: among_new })?);
    }
    let id = |end| match end {
        End::Old(id) => id,
        End::New(place) => VertexId(first.saturating_add(u32::try_from(place).unwrap_or(u32::MAX))),
    };
    for (a, b) in joining {
        delta = delta.then(&scratch.apply(&Edit::Connect { a: id(a), b: id(b) })?);
    }
    let change = DocumentChange::of_edit(document, delta);
    Ok(document.set_construction(left).map(|lines| change.and(lines)))
}

/// An end of a line: a vertex that is there, or one of those that are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum End {
    Old(VertexId),
    New(usize),
}

/// An edge by its ends, whichever way it was drawn.
fn pair(a: End, b: End) -> (End, End) {
    if a <= b { (a, b) } else { (b, a) }
}

/// Ends by where they are, in cells as wide as what is joined.
struct Places {
    weld: Length,
    cells: BTreeMap<[i64; 3], Vec<(Point3<f64>, End)>>,
}

impl Places {
    const fn new(weld: Length) -> Self {
        Self { weld, cells: BTreeMap::new() }
    }

    fn cell(&self, at: Point3<f64>) -> [i64; 3] {
        #[allow(clippy::cast_possible_truncation)] // within a kilometre, in parts of a millimetre
        let cell = |mm: f64| (mm / self.weld.mm().max(1e-9)).floor() as i64;
        [cell(at.x), cell(at.y), cell(at.z)]
    }

    fn add(&mut self, at: Point3<f64>, end: End) {
        self.cells.entry(self.cell(at)).or_default().push((at, end));
    }

    /// The nearest end that is as good as there.
    fn find(&self, at: Point3<f64>) -> Option<End> {
        let [x, y, z] = self.cell(at);
        let near =
            (-1..=1).flat_map(|i| (-1..=1).flat_map(move |j| (-1..=1).map(move |k| [x + i, y + j, z + k])));
        let ends = near.filter_map(|cell| self.cells.get(&cell)).flatten();
        let apart = ends
            .map(|(place, end)| ((place - at).norm(), *end))
            .filter(|(apart, _)| *apart <= self.weld.mm());
        apart.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, end)| end)
    }
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
