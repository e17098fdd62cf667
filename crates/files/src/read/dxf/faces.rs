//! Faces: 3DFACE, and the meshes that are polylines by name.

use super::super::error::ReadError;
use super::super::note::NoteKind;
use super::super::text::LIMIT;
use super::record::Record;
use super::shape::{Face, Faces, Shape};

/// Four corners, of which a triangle repeats the last; a bit of 70 hides the side that its corner begins.
pub(super) fn face(record: &Record<'_>) -> Result<Shape, ReadError> {
    let mut points = vec![record.point(10)?, record.point(11)?, record.point(12)?];
    // Some programs leave the last corner of a triangle away.
    if record.find(13).is_some() {
        points.push(record.point(13)?);
    }
    let hidden = record.whole(70)?.unwrap_or_default();
    let corners = (0_u32..).zip(&points).map(|(k, _)| (k, hidden & (1 << k) == 0)).collect();
    Ok(Shape::Faces(Faces { points, faces: vec![Face { corners }] }))
}

/// The kinds of meshes that a polyline can be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// Any faces over a list of points.
    Polyface,
    /// Rows of as many points each, `closed` from the last row, and the last point of each, to the first.
    Grid { rows: usize, columns: usize, closed: [bool; 2], smooth: bool },
}

/// A mesh whose vertices follow.
#[derive(Debug)]
pub(super) struct Mesh {
    kind: Kind,
    faces: Faces,
}

impl Mesh {
    /// Of a polyline with a flag of 16 or 64; none for any other.
    pub(super) fn of(record: &Record<'_>) -> Result<Option<Self>, ReadError> {
        let kind = if record.flag(64)? {
            Kind::Polyface
        } else if record.flag(16)? {
            let smooth = record.flag(4)?;
            let count = |code| -> Result<usize, ReadError> {
                let count = record.whole(code)?.unwrap_or_default();
                Ok(usize::try_from(count).unwrap_or_default())
            };
            // The counts of a smoothed mesh stand behind those of what steers it.
            let [rows, columns] = if smooth { [count(73)?, count(74)?] } else { [count(71)?, count(72)?] };
            Kind::Grid { rows, columns, closed: [record.flag(1)?, record.flag(32)?], smooth }
        } else {
            return Ok(None);
        };
        Ok(Some(Self { kind, faces: Faces::default() }))
    }

    /// A point has a flag of 64, also in a polyface; there a flag of 128 alone is a face.
    pub(super) fn vertex(&mut self, record: &Record<'_>) -> Result<(), ReadError> {
        match self.kind {
            Kind::Polyface if !record.flag(64)? => self.face(record),
            // Of a smoothed mesh the points of 16 steer it.
            Kind::Grid { smooth: true, .. } if record.flag(16)? => Ok(()),
            _ => {
                self.faces.points.push(record.point(10)?);
                Ok(())
            }
        }
    }

    /// Indices from 1 into the points before; a negative one hides the side that it begins, 0 is none.
    fn face(&mut self, record: &Record<'_>) -> Result<(), ReadError> {
        let have = self.faces.points.len();
        let mut corners = Vec::with_capacity(4);
        for pair in record.pairs.iter().filter(|pair| (71..=74).contains(&pair.code)) {
            let index = pair.whole(record.source)?;
            if index == 0 {
                continue;
            }
            let at = usize::try_from(index.unsigned_abs()).ok().filter(|at| *at <= have);
            let Some(at) = at.and_then(|at| u32::try_from(at - 1).ok()) else {
                return Err(ReadError::Index {
                    file: record.source.name.to_owned(),
                    place: pair.place.clone(),
                    found: index.to_string(),
                    what: "vertex",
                    have: format!("the mesh has {have} before this face"),
                });
            };
            corners.push((at, index > 0));
        }
        self.faces.faces.push(Face { corners });
        Ok(())
    }

    /// The faces, once all vertices are there.
    ///
    /// # Errors
    /// [`ReadError::Truncated`] for a grid with fewer points than rows and columns need.
    pub(super) fn finish(mut self, record: &Head<'_>) -> Result<Shape, ReadError> {
        if let Kind::Grid { rows, columns, closed, .. } = self.kind {
            let (needed, have) = (rows.saturating_mul(columns), self.faces.points.len());
            if needed > have || needed > LIMIT {
                let announced = format!("a mesh of {rows} times {columns} vertices is announced");
                return Err(record.source.truncated(
                    record.place.clone(),
                    announced,
                    format!("there are {have}"),
                ));
            }
            self.faces.faces = grid(rows, columns, closed);
        }
        if self.faces.faces.is_empty() {
            return Ok(Shape::Ignored(NoteKind::SurfacesIgnored));
        }
        Ok(Shape::Faces(self.faces))
    }
}

/// Where the polyline of a mesh stands.
pub(super) struct Head<'a> {
    pub(super) source: super::Source<'a>,
    pub(super) place: super::Location,
}

fn grid(rows: usize, columns: usize, closed: [bool; 2]) -> Vec<Face> {
    let mut faces = Vec::new();
    let ends = |count: usize, closed: bool| if closed { count } else { count.saturating_sub(1) };
    for row in 0..ends(rows, closed[0]) {
        for column in 0..ends(columns, closed[1]) {
            let (below, right) = ((row + 1) % rows, (column + 1) % columns);
            let corners = [(row, column), (row, right), (below, right), (below, column)];
            let at = |(row, column): (usize, usize)| {
                (u32::try_from(row * columns + column).unwrap_or(u32::MAX), true)
            };
            faces.push(Face { corners: corners.map(at).to_vec() });
        }
    }
    faces
}
