//! What the readers of points, lines and faces have in common: from lists to an [`Imported`].

use std::collections::HashSet;

use nalgebra::Point3;
use wirebend_core::mesh::Stencil;
use wirebend_core::wireframe::{Edge, EdgeId, Vertex, VertexId, Welder, Wireframe};

use super::Imported;
use super::curves::CurveFacts;
use super::error::{Location, ReadError};
use super::format::Format;
use super::note::{NoteKind, Notes};
use super::options::{LengthUnit, ReadOptions};
use super::text::Source;

/// Points, edges and faces in the numbers and the order of a file; indices are in range.
#[derive(Debug, Default)]
pub(crate) struct Drawing {
    pub(crate) points: Vec<Point3<f64>>,
    /// The line of each point, from 1; empty where the file has no lines.
    pub(crate) point_lines: Vec<usize>,
    /// Points that are held, and how: along x, y and z, then about them.
    pub(crate) supports: Vec<(u32, [bool; 6])>,
    pub(crate) edges: Vec<(u32, u32)>,
    /// The line of each edge, as [`Drawing::point_lines`].
    pub(crate) edge_lines: Vec<usize>,
    /// What the file calls its points and edges, where it is not vertices and edges.
    pub(crate) names: Option<[&'static str; 2]>,
    /// Which of the edges are part of the ceiling, as their places in the list.
    pub(crate) ceilings: HashSet<u32>,
    pub(crate) faces: Vec<Vec<u32>>,
    /// Sides of faces that the file hides, lower index first: they become no edges.
    pub(crate) hidden_sides: HashSet<(u32, u32)>,
    /// How many millimetres the unit is that the file names.
    pub(crate) unit_mm: Option<f64>,
    pub(crate) layers: Vec<String>,
    /// What became of its curves, where edges of them have a least length.
    pub(crate) curves: Option<CurveFacts>,
    pub(crate) notes: Notes,
}

impl Drawing {
    /// Scales, builds the wireframe and the stencil, and welds. Vertex k of the file is
    /// `VertexId(k)`; what neither edges nor faces use is dropped and counted.
    ///
    /// # Errors
    /// [`ReadError::Wireframe`] for a position beyond a kilometre.
    pub(crate) fn finish(
        self,
        format: Format,
        source: Source<'_>,
        options: &ReadOptions,
    ) -> Result<Imported, ReadError> {
        self.finish_kept(format, source, options).map(|(imported, _)| imported)
    }

    /// As [`Drawing::finish`], and of each point the one that it was welded to, or itself.
    pub(crate) fn finish_kept(
        mut self,
        format: Format,
        source: Source<'_>,
        options: &ReadOptions,
    ) -> Result<(Imported, Vec<u32>), ReadError> {
        match (options.units.map(LengthUnit::mm), self.unit_mm) {
            (None, None) => self.notes.add(NoteKind::UnitsAssumed, 1),
            (Some(ours), Some(theirs)) if (ours - theirs).abs() > 1e-12 * theirs => {
                self.notes.add(NoteKind::UnitsOverridden, 1);
            }
            _ => {}
        }
        let factor = self.factor(options);
        for point in &mut self.points {
            point.coords *= factor;
        }
        let mut used = self.in_edges();
        for &k in self.faces.iter().flatten() {
            used[k as usize] = true;
        }
        for k in (0..used.len()).filter(|&k| !used[k]) {
            let held = self.supports.iter().any(|&(held, how)| held as usize == k && how.contains(&true));
            let kind = if held { NoteKind::SupportsUnused } else { NoteKind::VerticesUnused };
            self.notes.add_at(kind, self.named(self.place_of_point(k)));
        }

        let stencil = self.stencil(&used, source)?;
        if let Some(stencil) = &stencil {
            if options.face_edges {
                let sides = stencil.face_edges();
                let all = sides.len();
                let before = self.edges.len();
                self.edges.extend(sides.into_iter().filter(|side| !self.hidden_sides.contains(side)));
                self.notes.add(NoteKind::HiddenIgnored, all - (self.edges.len() - before));
            } else {
                if !self.edges.is_empty() {
                    self.notes.add(NoteKind::FacesToStencil, stencil.faces().len());
                }
                used = self.in_edges();
            }
        }
        if stencil.is_none() && self.edges.is_empty() {
            return Err(source.empty("edges and no faces", &self.notes));
        }
        let (wireframe, welded) = self.wireframe(&used, source, options)?;
        let imported = Imported {
            format,
            wireframe,
            stencil,
            program: None,
            frame: None,
            document: None,
            layers: self.layers,
            curves: self.curves,
            notes: self.notes.into_vec(),
        };
        Ok((imported, welded))
    }

    /// From numbers of the file to millimetres: the person's unit, else the file's, else none; and the scale.
    pub(crate) fn factor(&self, options: &ReadOptions) -> f64 {
        options.units.map(LengthUnit::mm).or(self.unit_mm).unwrap_or(1.0) * options.scale
    }

    /// Where a point is in the file.
    fn place_of_point(&self, k: usize) -> Location {
        let name = self.names.map_or("vertex", |[point, _]| point);
        self.point_lines.get(k).map_or(Location::Item(name, k), |&line| Location::Line(line))
    }

    fn place_of_edge(&self, k: usize) -> Location {
        let name = self.names.map_or("edge", |[_, edge]| edge);
        self.edge_lines.get(k).map_or(Location::Item(name, k), |&line| Location::Line(line))
    }

    /// A place that somebody finds in the file: one of its lines, or an entry of a list that it has.
    fn named(&self, place: Location) -> Option<Location> {
        Some(place).filter(|place| matches!(place, Location::Line(_)) || self.names.is_some())
    }

    /// Of each point whether an edge ends at it.
    fn in_edges(&self) -> Vec<bool> {
        let mut used = vec![false; self.points.len()];
        for &(a, b) in &self.edges {
            used[a as usize] = true;
            used[b as usize] = true;
        }
        used
    }

    /// The faces with all points, so that indices stay those of the file; a point that nothing
    /// uses is put on one that is, where it cannot stretch the view.
    fn stencil(&mut self, used: &[bool], source: Source<'_>) -> Result<Option<Stencil>, ReadError> {
        let Some(&anchor) = self.faces.first().and_then(|face| face.first()) else {
            return Ok(None);
        };
        let mut points = self.points.clone();
        let anchor = points[anchor as usize];
        for (point, used) in points.iter_mut().zip(used) {
            if !used {
                *point = anchor;
            }
        }
        let stencil = Stencil::new(points, std::mem::take(&mut self.faces));
        stencil.map(Some).map_err(|error| ReadError::Stencil { file: source.name.to_owned(), error })
    }

    /// Vertex k and edge k of the file keep k as their id; what is merged goes into the lowest.
    fn wireframe(
        &mut self,
        used: &[bool],
        source: Source<'_>,
        options: &ReadOptions,
    ) -> Result<(Wireframe, Vec<u32>), ReadError> {
        let refuse = |place, error| ReadError::Wireframe { file: source.name.to_owned(), place, error };
        let mut welder = Welder::new(options.weld);
        let mut fixed = vec![[false; 6]; self.points.len()];
        for &(k, how) in &self.supports {
            fixed[k as usize] = how;
        }
        let mut welded: Vec<u32> = (0..).take(self.points.len()).collect();
        for (k, &position) in self.points.iter().enumerate().filter(|&(k, _)| used[k]) {
            welded[k] = welder.put(welded[k], position);
            // What is welded together is held as each was.
            let (onto, own) = (fixed[welded[k] as usize], fixed[k]);
            fixed[welded[k] as usize] = std::array::from_fn(|axis| onto[axis] || own[axis]);
        }
        let mut wireframe = Wireframe::new();
        for (k, &position) in self.points.iter().enumerate().filter(|&(k, _)| used[k]) {
            if welded[k] as usize != k {
                self.notes.add_at(NoteKind::VerticesMerged, self.named(self.place_of_point(k)));
                continue;
            }
            let place = self.place_of_point(k);
            let support = fixed[k].contains(&true);
            let free = fixed[k].map(|fixed| support && !fixed);
            let vertex = Vertex { support, free, ..Vertex::at(position) };
            wireframe.insert_vertex(VertexId(welded[k]), vertex).map_err(|error| refuse(place, error))?;
        }
        let mut joined = HashSet::new();
        for (id, &(a, b)) in (0..).zip(&self.edges) {
            let place = self.place_of_edge(id as usize);
            let ceiling = self.ceilings.contains(&id);
            let (a, b) = (VertexId(welded[a as usize]), VertexId(welded[b as usize]));
            let edge = Edge { a, b, ceiling };
            if edge.a == edge.b {
                self.notes.add_at(NoteKind::EdgesCollapsed, self.named(place));
            } else if !joined.insert(edge.ends()) {
                self.notes.add_at(NoteKind::EdgesMerged, self.named(place));
            } else {
                wireframe.insert_edge(EdgeId(id), edge).map_err(|error| refuse(place, error))?;
            }
        }
        Ok((wireframe, welded))
    }
}
