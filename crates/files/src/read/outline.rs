//! Lines and curves of a drawing, before and after they are made straight edges.

use nalgebra::{Affine3, Point3};
use wirebend_core::curve::{EllipticArc, Spline};
use wirebend_core::units::{Angle, Length};
use wirebend_core::wireframe::{Vertex, VertexId, Wireframe};

use super::drawing::Drawing;
use super::error::{Location, ReadError};
use super::note::NoteKind;
use super::options::ReadOptions;
use super::text::{LIMIT, Source};

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
}

impl<'a> Pen<'a> {
    /// The unit of `drawing` is known, since the tolerance is one of millimetres.
    pub(super) fn new(source: Source<'a>, drawing: Drawing, options: &ReadOptions) -> Self {
        let factor = drawing.factor(options);
        // A scale that leaves the finite numbers is refused with the first position.
        let tolerance = Length::from_mm(options.tolerance.mm() / factor).unwrap_or(options.tolerance);
        Self { source, drawing, tolerance, weld: options.weld.mm() / factor, factor }
    }

    /// Adds the vertices and edges of an outline; `line` is where it stands, in a text.
    pub(super) fn draw(&mut self, place: &Location, outline: &Outline) -> Result<(), ReadError> {
        let first = self.drawing.points.len();
        self.point(place, outline.start)?;
        for piece in &outline.pieces {
            let (points, end) = match piece {
                Piece::Line(to) => {
                    self.point(place, *to)?;
                    continue;
                }
                Piece::Arc(arc, to) => {
                    for part in [0.25, 0.5, 0.75, 1.0] {
                        let at =
                            Angle::from_rad(arc.start.rad() + part * arc.sweep.rad()).unwrap_or_default();
                        self.within(place, &arc.point(at))?;
                    }
                    (arc.flatten(self.tolerance), Some(*to))
                }
                Piece::Spline(spline) => {
                    spline.control().iter().try_for_each(|point| self.within(place, point))?;
                    let max_points = LIMIT.saturating_sub(self.drawing.points.len());
                    let Ok(points) = spline.flatten(self.tolerance, max_points) else {
                        return self.source.room(place.clone(), LIMIT, "vertices");
                    };
                    (points, None)
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

    /// Adds a corner of faces, and gives its index.
    pub(super) fn corner(&mut self, place: &Location, point: Point3<f64>) -> Result<u32, ReadError> {
        self.within(place, &point)?;
        self.point(place, point)?;
        Ok(index(self.drawing.points.len()) - 1)
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
