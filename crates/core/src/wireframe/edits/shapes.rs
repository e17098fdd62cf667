//! Edits that draw regular polygons and helices.

use std::f64::consts::{PI, TAU};

use nalgebra::{Point3, Unit, Vector3};

use super::super::Vertex;
use super::super::delta::Draft;
use super::{EditError, drawing};
use crate::units::{Angle, Length};

/// The most edges of a polygon, and of a turn of a helix.
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

impl ShapePlane {
    /// A place by polar coordinates, with a height over the plane.
    fn place(&self, radius: f64, angle: f64, height: f64) -> Point3<f64> {
        let (u, v) = (self.u.into_inner(), self.v.into_inner());
        self.centre + u * (radius * angle.cos()) + v * (radius * angle.sin()) + u.cross(&v) * height
    }
}

/// A closed polygon of equal sides, its first vertex on the first axis of the plane, turned by `turn`.
pub(super) fn polygon(
    draft: &mut Draft,
    plane: &ShapePlane,
    sides: u32,
    size: PolygonSize,
    turn: Angle,
) -> Result<(), EditError> {
    check_sides(sides)?;
    let half = PI / f64::from(sides);
    let radius = match size {
        PolygonSize::Corners(radius) => checked(radius)?,
        PolygonSize::Flats(radius) => checked(radius)? / half.cos(),
        PolygonSize::Side(side) => checked(side)? / (2.0 * half.sin()),
    };
    let corner = |k: u32| plane.place(radius, turn.rad() + TAU * f64::from(k) / f64::from(sides), 0.0);
    let vertices: Vec<Vertex> = (0..sides).map(corner).map(Vertex::at).collect();
    let count = vertices.len();
    let edges: Vec<(usize, usize)> = (0..count).map(|k| (k, (k + 1) % count)).collect();
    drawing::piece(draft, &vertices, &edges)
}

/// A helix about the normal of the plane, from its first axis on: with `sides` straight edges a turn, rising by `pitch` a turn.
pub(super) fn helix(
    draft: &mut Draft,
    plane: &ShapePlane,
    radius: Length,
    pitch: Length,
    turns: f64,
    sides: u32,
    left: bool,
) -> Result<(), EditError> {
    check_sides(sides)?;
    let radius = checked(radius)?;
    if !(turns > 0.0 && turns <= MAX_TURNS) {
        return Err(EditError::Turns(turns));
    }
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // at most 1e8
    let count = (turns * f64::from(sides)).round().max(1.0) as u32;
    let sign = if left { -1.0 } else { 1.0 };
    let place = |k: u32| {
        let turned = turns * f64::from(k) / f64::from(count);
        plane.place(radius, sign * TAU * turned, pitch.mm() * turned)
    };
    if count as usize > drawing::MAX_DRAWN {
        return Err(EditError::TooMuch { count: count as usize, max: drawing::MAX_DRAWN });
    }
    let through: Vec<Point3<f64>> = (0..=count).map(place).collect();
    drawing::strand(draft, None, &through, None)
}

fn check_sides(sides: u32) -> Result<(), EditError> {
    if (3..=MAX_SIDES).contains(&sides) { Ok(()) } else { Err(EditError::Sides { sides, max: MAX_SIDES }) }
}

fn checked(size: Length) -> Result<f64, EditError> {
    if size > Length::ZERO { Ok(size.mm()) } else { Err(EditError::ShapeSize(size.mm())) }
}
