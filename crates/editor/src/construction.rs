//! Construction lines of a design: drawn, made of edges, made edges of, moved and copied beside vertices, and deleted.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::{Affine3, Point3};
use wirebend_core::units::Length;
use wirebend_core::wireframe::{Delta, EdgeId, Edit, EditError, Vertex, VertexId, Wireframe};
use wirebend_files::document::{ConstructionLine, Document, DocumentChange};

use crate::{ConstructionChange, EditRequest, EditorError};

/// The most places that are added at once, as of vertices.
const MAX_ADDED: usize = 1_000_000;

/// The difference that a change of construction lines makes; none where it changes nothing.
pub(super) fn changed(
    document: &Document,
    change: &ConstructionChange,
    weld: Length,
) -> Result<Option<DocumentChange>, EditorError> {
    match change {
        ConstructionChange::Draw { through_mm } => drawn(document, through_mm),
        ConstructionChange::Lines { edges } => from_edges(document, edges),
        ConstructionChange::Edges { lines } => to_edges(document, lines, weld),
        ConstructionChange::Nothing { lines } => Ok(document.set_construction(taken(document, lines)?.1)),
    }
}

/// What an edit of vertices does to construction lines that go with them.
#[derive(Debug, Clone, Copy)]
pub(super) enum LinesEdit {
    Delete,
    Place(Affine3<f64>),
    /// `step`: from each copy to the next.
    Copy {
        step: Affine3<f64>,
        count: u32,
    },
}

/// The difference that an edit makes to construction lines beside vertices; none where it has none, or changes none. Lines keep their places
/// in the list, and copies are appended.
pub(super) fn beside(
    document: &Document,
    request: &EditRequest,
    weld: Length,
) -> Result<Option<DocumentChange>, EditorError> {
    let Some((lines, edit)) = request.of_lines()? else { return Ok(None) };
    let (taken, left) = taken(document, lines)?;
    let after = match edit {
        LinesEdit::Delete => left,
        LinesEdit::Place(to) => {
            let mut all = document.construction.clone();
            let places = lines.iter().copied().collect::<BTreeSet<u32>>();
            for (place, line) in (0..).zip(&mut all) {
                if places.contains(&place) {
                    *line = placed(line, &to);
                }
            }
            all
        }
        LinesEdit::Copy { step, count } => {
            let mut all = document.construction.clone();
            all.extend(copies(taken, &step, count, weld)?);
            all
        }
    };
    check_places(&after)?;
    Ok(document.set_construction(after))
}

fn placed(line: &ConstructionLine, to: &Affine3<f64>) -> ConstructionLine {
    ConstructionLine { ends: line.ends.map(|end| to * end) }
}

/// Copies of lines, each a step from the one before. One that lies on that is none.
fn copies(
    mut last: Vec<ConstructionLine>,
    step: &Affine3<f64>,
    count: u32,
    weld: Length,
) -> Result<Vec<ConstructionLine>, EditorError> {
    let ends = last.len().saturating_mul(2);
    if usize::try_from(count).unwrap_or(usize::MAX).saturating_mul(ends) > MAX_ADDED {
        return Err(EditError::ArrayCount { copies: count, max: MAX_ADDED }.into());
    }
    let are_one = |one: Point3<f64>, other: Point3<f64>| (one - other).norm() <= weld.mm();
    let lies_on = |one: &ConstructionLine, other: &ConstructionLine| {
        let ([a, b], [c, d]) = (one.ends, other.ends);
        (are_one(a, c) && are_one(b, d)) || (are_one(a, d) && are_one(b, c))
    };
    let mut all = Vec::new();
    for _ in 0..count {
        let next: Vec<_> = last.iter().map(|line| (line, placed(line, step))).collect();
        let apart = next.into_iter().filter(|(line, copy)| !lies_on(line, copy));
        last = apart.map(|(_, copy)| copy).collect();
        all.extend_from_slice(&last);
    }
    Ok(all)
}

/// Lines from place to place, after those that are there.
fn drawn(document: &Document, through_mm: &[[f64; 3]]) -> Result<Option<DocumentChange>, EditorError> {
    if through_mm.len() < 2 {
        return Err(EditorError::ConstructionPlaces(through_mm.len()));
    }
    if through_mm.len() > MAX_ADDED {
        return Err(EditError::TooMuch { count: through_mm.len(), max: MAX_ADDED }.into());
    }
    let lines: Vec<_> = through_mm
        .windows(2)
        .filter_map(|pair| <[[f64; 3]; 2]>::try_from(pair).ok())
        .map(|ends| ConstructionLine { ends: ends.map(Point3::from) })
        .collect();
    if let Some(place) = lines.iter().position(|line| line.ends[0] == line.ends[1]) {
        return Err(EditorError::ConstructionLength(place + 1));
    }
    check_places(&lines)?;
    Ok(document.set_construction([document.construction.clone(), lines].concat()))
}

/// Refuses lines that lead out of where vertices may be.
fn check_places(lines: &[ConstructionLine]) -> Result<(), EditorError> {
    let mut places = Wireframe::new();
    for end in lines.iter().flat_map(|line| line.ends) {
        places.add_vertex(Vertex::at(end)).map_err(EditError::from)?;
    }
    Ok(())
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
