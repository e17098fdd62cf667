//! Lines and curves of a drawing, before and after they are made straight edges.

use nalgebra::{Affine3, Point3};
use wirebend_core::curve::{EdgeLimit, EllipticArc, Spline};
use wirebend_core::units::{Angle, Length};
use wirebend_core::wireframe::{Vertex, VertexId, Wireframe};

use super::curves::{CurveFacts, CurveRadius, tightest};
use super::drawing::Drawing;
use super::error::{Location, ReadError};
use super::note::NoteKind;
use super::options::ReadOptions;
use super::stroke::{Cutter, Part};
use super::text::{LIMIT, Source};

/// Curves that are cut to a least length of edges are looked at so much closer than the tolerance.
const CLOSER: f64 = 50.0;

/// One stroke: from a point along pieces, each of which starts where the one before it ends.
#[derive(Debug, Clone)]
pub(super) struct Outline {
    pub(super) start: Point3<f64>,
    pub(super) pieces: Vec<Piece>,
    /// Whether it goes straight on to its start.
    pub(super) closed: bool,
}

/// A part of an outline.
#[derive(Debug, Clone)]
pub(super) enum Piece {
    Line(Point3<f64>),
    /// An arc, and the point where it ends as the file says it.
    Arc(EllipticArc, Point3<f64>),
    Spline(Spline),
}

impl Outline {
    pub(super) fn new(start: Point3<f64>) -> Self {
        Self { start, pieces: Vec::new(), closed: false }
    }

    pub(super) fn polyline(points: impl IntoIterator<Item = Point3<f64>>, closed: bool) -> Option<Self> {
        let mut points = points.into_iter();
        let start = points.next()?;
        Some(Self { start, pieces: points.map(Piece::Line).collect(), closed })
    }

    /// A whole ellipse, or a part of one.
    pub(super) fn arc(arc: EllipticArc) -> Self {
        let end = arc.start.rad() + arc.sweep.rad();
        let end = arc.point(Angle::from_rad(end).unwrap_or_default());
        Self { start: arc.point(arc.start), pieces: vec![Piece::Arc(arc, end)], closed: false }
    }

    pub(super) fn mapped(&self, map: &Affine3<f64>) -> Self {
        let piece = |piece: &Piece| match piece {
            Piece::Line(to) => Piece::Line(map * to),
            Piece::Arc(arc, to) => Piece::Arc(arc.mapped(map), map * to),
            Piece::Spline(spline) => Piece::Spline(spline.mapped(map)),
        };
        Self { start: map * self.start, pieces: self.pieces.iter().map(piece).collect(), closed: self.closed }
    }
}

/// Puts outlines into a drawing, in the numbers of the file.
pub(super) struct Pen<'a> {
    pub(super) source: Source<'a>,
    pub(super) drawing: Drawing,
    /// In the unit of the file.
    tolerance: Length,
    weld: f64,
    /// To millimetres.
    factor: f64,
    /// How short edges of curves may be, in the unit of the file; none where that is left open.
    limit: Option<EdgeLimit>,
    /// What waits to be cut, since curves may go on in what is drawn later.
    parts: Vec<Part>,
    /// How many points these have.
    waiting: usize,
}

impl<'a> Pen<'a> {
    /// The unit of `drawing` is known, since the tolerance is one of millimetres.
    pub(super) fn new(source: Source<'a>, drawing: Drawing, options: &ReadOptions) -> Self {
        let factor = drawing.factor(options);
        // A scale that leaves the finite numbers is refused with the first position.
        let tolerance = Length::from_mm(options.tolerance.mm() / factor).unwrap_or(options.tolerance);
        let in_file = |length: Length| Length::from_mm(length.mm() / factor).ok();
        let limit = options.shortest_edge.and_then(in_file).map(|shortest| EdgeLimit {
            shortest,
            bend_radius: in_file(options.bend_radius).unwrap_or_default(),
        });
        let weld = options.weld.mm() / factor;
        Self { source, drawing, tolerance, weld, factor, limit, parts: Vec::new(), waiting: 0 }
    }

    /// Adds the vertices and edges of an outline, at [`Pen::finish`] at the latest; `place` is where it stands.
    pub(super) fn draw(&mut self, place: &Location, outline: &Outline) -> Result<(), ReadError> {
        if self.limit.is_some() {
            return self.take(place, outline);
        }
        let first = self.drawing.points.len();
        self.point(place, outline.start)?;
        for piece in &outline.pieces {
            let (points, end) = match piece {
                Piece::Line(to) => {
                    self.point(place, *to)?;
                    continue;
                }
                curve => {
                    self.curve_within(place, curve)?;
                    let end = if let Piece::Arc(_, to) = curve { Some(*to) } else { None };
                    (self.flat(place, curve, self.tolerance)?, end)
                }
            };
            self.drawing.notes.add(NoteKind::CurvesFlattened, 1);
            let (inner, last) = points.split_at(points.len().saturating_sub(1));
            for point in inner.iter().skip(1) {
                self.point(place, *point)?;
            }
            if let Some(point) = end.as_ref().or(last.first()) {
                self.point(place, *point)?;
            }
        }
        self.join(place, first, outline.closed)
    }

    /// Keeps an outline until all are known.
    fn take(&mut self, place: &Location, outline: &Outline) -> Result<(), ReadError> {
        let mut at = outline.start;
        self.within(place, &at)?;
        for piece in &outline.pieces {
            let part = if let Piece::Line(to) = piece {
                self.within(place, to)?;
                Part::line(place.clone(), at, *to)
            } else {
                self.curve_within(place, piece)?;
                self.curve(place, at, piece)?
            };
            // Both ends of a piece of no length would count at its place, where nothing would go on then.
            if part.length() <= self.weld {
                self.drawing.notes.add(NoteKind::EdgesCollapsed, 1);
                continue;
            }
            at = part.dense[part.dense.len() - 1];
            self.keep(place, part)?;
        }
        if outline.closed && (at - outline.start).norm() > self.weld {
            self.keep(place, Part::line(place.clone(), at, outline.start))?;
        }
        Ok(())
    }

    /// Keeps a part, as long as there is room for its points.
    fn keep(&mut self, place: &Location, part: Part) -> Result<(), ReadError> {
        self.waiting += part.dense.len() + part.plain.len();
        self.source.room(place.clone(), self.waiting, "points of lines and curves")?;
        self.parts.push(part);
        Ok(())
    }

    fn curve(&self, place: &Location, start: Point3<f64>, piece: &Piece) -> Result<Part, ReadError> {
        let close = Length::from_mm(self.tolerance.mm() / CLOSER).unwrap_or(self.tolerance);
        let mut dense = self.flat(place, piece, close)?;
        let mut plain = self.flat(place, piece, self.tolerance)?;
        // The file says where an arc ends; its centre and its angles may be rounded.
        let end = if let Piece::Arc(_, to) = piece { Some(*to) } else { None };
        for points in [&mut dense, &mut plain] {
            points[0] = start;
            if let (Some(last), Some(end)) = (points.last_mut(), end) {
                *last = end;
            }
        }
        let (ways, radius) = match piece {
            Piece::Arc(arc, _) => (arc.ways(), tightest(&dense)),
            Piece::Spline(spline) => (spline.ways(), tightest(&dense)),
            Piece::Line(_) => ([dense[dense.len() - 1] - start; 2], None),
        };
        // Of so few points nothing can be said: a curve that is as good as straight.
        let radius = radius.unwrap_or(CurveRadius { radius_mm: f64::MAX, at: start });
        Ok(Part { place: place.clone(), dense, plain, ways, radius: Some(radius) })
    }

    /// The points of a curve for a tolerance.
    fn flat(
        &self,
        place: &Location,
        piece: &Piece,
        tolerance: Length,
    ) -> Result<Vec<Point3<f64>>, ReadError> {
        let flat = match piece {
            Piece::Line(to) => Ok(vec![*to]),
            Piece::Arc(arc, _) => Ok(arc.flatten(tolerance)),
            Piece::Spline(spline) => {
                spline.flatten(tolerance, LIMIT.saturating_sub(self.drawing.points.len() + self.waiting))
            }
        };
        flat.or_else(|_| self.source.room(place.clone(), LIMIT, "vertices").map(|()| Vec::new()))
    }

    /// The drawing with all that waited for it.
    pub(super) fn finish(mut self) -> Result<Drawing, ReadError> {
        let Some(limit) = self.limit else { return Ok(self.drawing) };
        let parts = std::mem::take(&mut self.parts);
        let weld = Length::from_mm(self.weld).unwrap_or_default();
        let (tolerance, facts) = (self.tolerance, CurveFacts::default());
        let mut cutter = Cutter { tolerance, limit, weld, facts };
        for row in cutter.rows(parts) {
            let first = self.drawing.points.len();
            let Some((place, _)) = row.vertices.first().cloned() else { continue };
            for (place, point) in &row.vertices {
                self.point(place, *point)?;
            }
            self.join(&place, first, row.closed)?;
        }
        let within = cutter.facts.radii.len() - cutter.facts.coarser;
        self.drawing.notes.add(NoteKind::CurvesFlattened, within);
        self.drawing.curves = Some(cutter.facts.scaled(self.factor, tolerance.mm() / CLOSER));
        Ok(self.drawing)
    }

    /// Adds a corner of faces, and gives its index.
    pub(super) fn corner(&mut self, place: &Location, point: Point3<f64>) -> Result<u32, ReadError> {
        self.within(place, &point)?;
        self.point(place, point)?;
        Ok(index(self.drawing.points.len()) - 1)
    }

    /// Refuses a curve that goes where no wireframe has room.
    fn curve_within(&self, place: &Location, piece: &Piece) -> Result<(), ReadError> {
        match piece {
            Piece::Line(to) => self.within(place, to),
            Piece::Arc(arc, _) => [0.25, 0.5, 0.75, 1.0].into_iter().try_for_each(|part| {
                let at = Angle::from_rad(arc.start.rad() + part * arc.sweep.rad()).unwrap_or_default();
                self.within(place, &arc.point(at))
            }),
            Piece::Spline(spline) => spline.control().iter().try_for_each(|point| self.within(place, point)),
        }
    }

    /// Refuses what no wireframe has room for before a curve that goes there is cut into any number of pieces.
    fn within(&self, place: &Location, point: &Point3<f64>) -> Result<(), ReadError> {
        let vertex = Vertex::at(point * self.factor);
        Wireframe::new().insert_vertex(VertexId(0), vertex).map_err(|error| ReadError::Wireframe {
            file: self.source.name.to_owned(),
            place: place.clone(),
            error,
        })
    }

    fn point(&mut self, place: &Location, point: Point3<f64>) -> Result<(), ReadError> {
        self.source.room(place.clone(), self.drawing.points.len(), "vertices")?;
        if let Some(bad) = point.coords.iter().find(|c| !c.is_finite()) {
            return Err(ReadError::Number {
                file: self.source.name.to_owned(),
                place: place.clone(),
                found: bad.to_string(),
                expected: "finite number",
            });
        }
        self.drawing.points.push(point);
        if let Location::Line(line) = place {
            self.drawing.point_lines.push(*line);
        }
        Ok(())
    }

    /// Edges from each point to the next, from number `first` on. A last point on the first one is that one.
    fn join(&mut self, place: &Location, first: usize, closed: bool) -> Result<(), ReadError> {
        let points = &mut self.drawing.points;
        let returns =
            points.len() - first > 2 && (points[points.len() - 1] - points[first]).norm() <= self.weld;
        if returns {
            points.pop();
            self.drawing.point_lines.truncate(points.len());
        }
        let (begin, end) = (index(first), index(points.len()));
        self.drawing.edges.extend((begin + 1..end).map(|k| (k - 1, k)));
        if (closed || returns) && end - begin > 1 {
            self.drawing.edges.push((end - 1, begin));
        }
        self.source.room(place.clone(), self.drawing.edges.len(), "edges")
    }
}

/// There are fewer points than the limit.
fn index(count: usize) -> u32 {
    u32::try_from(count).unwrap_or(u32::MAX)
}
