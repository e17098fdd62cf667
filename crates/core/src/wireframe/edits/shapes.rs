//! Edits that draw regular polygons and helices.

use std::f64::consts::{PI, TAU};

use nalgebra::{Point3, Unit, Vector3};

use super::super::Vertex;
use super::super::delta::Draft;
use super::chord_limits::{ChordLimits, NOTHING};
use super::{EditError, drawing};
use crate::units::{Angle, Length};

/// The fewest and the most edges of a polygon, and of a turn of a helix.
const MIN_SIDES: u32 = 3;
const MAX_SIDES: u32 = 10_000;
/// The most turns of a helix.
const MAX_TURNS: f64 = 10_000.0;

/// A plane that a shape is drawn in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShapePlane {
    /// The middle of the shape.
    pub centre: Point3<f64>,
    /// The axis from which angles are counted.
    pub u: Unit<Vector3<f64>>,
    /// The axis towards which they are counted, at right angles to the first.
    pub v: Unit<Vector3<f64>>,
}

/// What the size of a regular polygon is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PolygonSize {
    /// The radius of the circle through its corners.
    Corners(Length),
    /// The radius of the circle that touches its sides.
    Flats(Length),
    /// The length of a side.
    Side(Length),
}

/// Which edges a shape would have. They are all alike; it is drawn also where they are too short.
#[derive(Debug, Clone, PartialEq)]
pub struct ShapeOutcome {
    /// How many.
    pub edges: u32,
    /// How long each is.
    pub length: Length,
    /// What can be made at least; 0 where everything can be made.
    pub needed: Length,
    /// Whether they can be made.
    pub fits: bool,
    /// The most edges of a turn, up to as many as are asked for, that can be made; none where no number of them can.
    pub fitting: Option<u32>,
}

impl ShapePlane {
    /// A place by polar coordinates, with a height over the plane.
    fn place(&self, radius: f64, angle: f64, height: f64) -> Point3<f64> {
        let (u, v) = (self.u.into_inner(), self.v.into_inner());
        self.centre + u * (radius * angle.cos()) + v * (radius * angle.sin()) + u.cross(&v) * height
    }
}

/// The vertices of a regular polygon or of a helix. Each turns and rises from the one before by the same, so all edges are alike.
pub(super) struct Shape {
    plane: ShapePlane,
    radius: f64,
    /// The angle of its first vertex, rad.
    begin: f64,
    /// Less than 0 against the right hand.
    turns: f64,
    /// How far it rises, mm.
    rise: f64,
    /// How many edges.
    count: u32,
    /// Whether the last edge ends at the first vertex.
    closed: bool,
}

impl Shape {
    /// A closed polygon of equal sides, its first vertex on the first axis of the plane, turned by `turn`.
    pub(super) fn polygon(
        plane: &ShapePlane,
        sides: u32,
        size: PolygonSize,
        turn: Angle,
    ) -> Result<Self, EditError> {
        check_sides(sides)?;
        let half = PI / f64::from(sides);
        let radius = match size {
            PolygonSize::Corners(radius) => checked(radius)?,
            PolygonSize::Flats(radius) => checked(radius)? / half.cos(),
            PolygonSize::Side(side) => checked(side)? / (2.0 * half.sin()),
        };
        let begin = turn.rad();
        Ok(Self { plane: *plane, radius, begin, turns: 1.0, rise: 0.0, count: sides, closed: true })
    }

    /// A helix about the normal of the plane, from its first axis on: with `sides` straight edges a turn, rising by `pitch` a turn.
    pub(super) fn helix(
        plane: &ShapePlane,
        radius: Length,
        pitch: Length,
        turns: f64,
        sides: u32,
        left: bool,
    ) -> Result<Self, EditError> {
        check_sides(sides)?;
        let radius = checked(radius)?;
        if !(turns > 0.0 && turns <= MAX_TURNS) {
            return Err(EditError::Turns(turns));
        }
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // at most 1e8
        let count = (turns * f64::from(sides)).round().max(1.0) as u32;
        if count as usize > drawing::MAX_DRAWN {
            return Err(EditError::TooMuch { count: count as usize, max: drawing::MAX_DRAWN });
        }
        let rise = pitch.mm() * turns;
        let turns = if left { -turns } else { turns };
        Ok(Self { plane: *plane, radius, begin: 0.0, turns, rise, count, closed: false })
    }

    pub(super) fn draw(&self, draft: &mut Draft) -> Result<(), EditError> {
        if !self.closed {
            let through: Vec<Point3<f64>> = (0..=self.count).map(|k| self.place(k)).collect();
            return drawing::strand(draft, None, &through, None);
        }
        let vertices: Vec<Vertex> = (0..self.count).map(|k| Vertex::at(self.place(k))).collect();
        let count = vertices.len();
        let edges: Vec<(usize, usize)> = (0..count).map(|k| (k, (k + 1) % count)).collect();
        drawing::piece(draft, &vertices, &edges)
    }

    fn place(&self, k: u32) -> Point3<f64> {
        let part = |whole: f64| whole * f64::from(k) / f64::from(self.count);
        self.plane.place(self.radius, self.begin + part(TAU * self.turns), part(self.rise))
    }

    fn edge(&self, k: u32) -> Vector3<f64> {
        self.place(k + 1) - self.place(k)
    }

    /// How long each edge is, mm.
    fn length(&self) -> f64 {
        self.edge(0).norm()
    }

    /// How far the wire is bent between two edges, rad.
    fn bend(&self) -> f64 {
        if self.count > 1 { self.edge(0).angle(&self.edge(1)) } else { 0.0 }
    }

    /// Whether a machine can make its edges.
    fn fits(&self, limits: &ChordLimits) -> bool {
        self.length() >= limits.side(self.bend()) - NOTHING
    }
}

impl ShapeOutcome {
    pub(super) fn of(
        shape: impl Fn(u32) -> Result<Shape, EditError>,
        sides: u32,
        limits: &ChordLimits,
    ) -> Result<Self, EditError> {
        let asked = shape(sides)?;
        let fits = |sides: &u32| shape(*sides).is_ok_and(|shape| shape.fits(limits));
        Ok(Self {
            edges: asked.count,
            length: Length::computed(asked.length()),
            needed: Length::computed(limits.side(asked.bend())),
            fits: asked.fits(limits),
            fitting: (MIN_SIDES..=sides).rev().find(fits),
        })
    }
}

fn check_sides(sides: u32) -> Result<(), EditError> {
    if (MIN_SIDES..=MAX_SIDES).contains(&sides) {
        Ok(())
    } else {
        Err(EditError::Sides { sides, max: MAX_SIDES })
    }
}

fn checked(size: Length) -> Result<f64, EditError> {
    if size > Length::ZERO { Ok(size.mm()) } else { Err(EditError::ShapeSize(size.mm())) }
}
