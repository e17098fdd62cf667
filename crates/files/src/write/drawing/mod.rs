//! A drawing at 1:1: lines, arcs and text in mm.

mod canvas;

use std::f64::consts::{FRAC_PI_2, TAU};

use crate::write::pdf::letters::width;

pub(crate) use canvas::draw;

/// A point of a drawing: to the right and up, in mm.
pub type Point = [f64; 2];

/// What a shape belongs to; a layer of a CAD drawing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Layer {
    /// The middle of the wire.
    Centreline,
    /// The wire's edges, and its ends.
    Wire,
    /// What is there to be read.
    Text,
}

impl Layer {
    pub const ALL: [Self; 3] = [Self::Centreline, Self::Wire, Self::Text];

    /// Its name in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Centreline => "CENTRELINE",
            Self::Wire => "WIRE",
            Self::Text => "TEXT",
        }
    }
}

/// A part of a drawing.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    Line([Point; 2]),
    /// A part of a circle.
    Arc {
        centre: Point,
        /// Its radius in mm.
        radius: f64,
        /// Where it begins: from the x axis, counter-clockwise, in rad.
        from: f64,
        /// How far it goes in rad, counter-clockwise where it is above zero.
        sweep: f64,
    },
    Circle {
        centre: Point,
        /// Its radius in mm.
        radius: f64,
    },
    /// Lines from each point to the next: a curve that is no circle, as chords.
    Chain(Vec<Point>),
    /// A line of text.
    Text {
        /// The left end of its baseline.
        at: Point,
        /// The size of its letters in mm; capitals are 0.72 of it high.
        size: f64,
        text: String,
    },
}

/// A drawing at 1:1.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Drawing {
    pub title: String,
    /// Its shapes, in the order in which the wire goes.
    pub shapes: Vec<(Layer, Shape)>,
    /// How many bends have a smaller radius here than on the machine, because their sides are too short.
    pub tightened: usize,
}

/// Left, bottom, right, top.
pub(crate) type Bounds = [f64; 4];

pub(crate) fn joined(a: Bounds, b: Bounds) -> Bounds {
    [a[0].min(b[0]), a[1].min(b[1]), a[2].max(b[2]), a[3].max(b[3])]
}

/// What encloses shapes; none where there are none.
pub(crate) fn bounds<'a>(shapes: impl IntoIterator<Item = &'a (Layer, Shape)>) -> Option<Bounds> {
    shapes.into_iter().map(|(_, shape)| shape.bounds()).reduce(joined)
}

impl Drawing {
    pub(crate) fn bounds(&self) -> Bounds {
        bounds(&self.shapes).unwrap_or_default()
    }
}

impl Shape {
    pub(crate) fn bounds(&self) -> Bounds {
        match self {
            Self::Circle { centre: [x, y], radius } => [x - radius, y - radius, x + radius, y + radius],
            // Below the baseline there is a quarter of the size.
            Self::Text { at: [x, y], size, text } => {
                [*x, y - size / 4.0, x + width(text, *size, false), y + size]
            }
            Self::Line(points) => around(points),
            Self::Chain(points) => around(points),
            Self::Arc { .. } => around(&self.points(f64::INFINITY)),
        }
    }

    /// The shape as points of lines that leave it by no more than `chord` mm; an arc with its outermost points. Of
    /// text the corners of its frame.
    pub(crate) fn points(&self, chord: f64) -> Vec<Point> {
        match self {
            Self::Line(points) => points.to_vec(),
            Self::Chain(points) => points.clone(),
            Self::Circle { centre, radius } => arc_points(*centre, *radius, 0.0, TAU, chord),
            Self::Arc { centre, radius, from, sweep } => arc_points(*centre, *radius, *from, *sweep, chord),
            Self::Text { .. } => {
                let [left, bottom, right, top] = self.bounds();
                vec![[left, bottom], [right, bottom], [right, top], [left, top], [left, bottom]]
            }
        }
    }

    fn shift(&mut self, [x, y]: Point) {
        let shift = |point: &mut Point| *point = [point[0] + x, point[1] + y];
        match self {
            Self::Line(points) => points.iter_mut().for_each(shift),
            Self::Chain(points) => points.iter_mut().for_each(shift),
            Self::Arc { centre, .. } | Self::Circle { centre, .. } => shift(centre),
            Self::Text { at, .. } => shift(at),
        }
    }
}

/// Moves shapes to the right and up.
pub(crate) fn shift(shapes: &mut [(Layer, Shape)], by: Point) {
    for (_, shape) in shapes {
        shape.shift(by);
    }
}

pub(crate) fn on_circle(centre: Point, radius: f64, angle: f64) -> Point {
    let (sin, cos) = angle.sin_cos();
    [centre[0] + radius * cos, centre[1] + radius * sin]
}

fn arc_points(centre: Point, radius: f64, from: f64, sweep: f64, chord: f64) -> Vec<Point> {
    let widest = (2.0 * (1.0 - (chord / radius).clamp(1e-6, 1.0)).acos()).min(FRAC_PI_2);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // from 1 to some thousand
    let count = (sweep.abs() / widest).ceil().clamp(1.0, 8192.0) as u32;
    let mut angles: Vec<f64> = (0..=count).map(|k| from + sweep * f64::from(k) / f64::from(count)).collect();
    // Rightmost, topmost and so on, where the arc passes them.
    let (low, high) = (from.min(from + sweep), from.max(from + sweep));
    let quarter = (low / FRAC_PI_2).ceil();
    angles.extend((0..8).map(|k| (quarter + f64::from(k)) * FRAC_PI_2).filter(|angle| *angle < high));
    angles.sort_by(|a, b| if sweep < 0.0 { b.total_cmp(a) } else { a.total_cmp(b) });
    angles.into_iter().map(|angle| on_circle(centre, radius, angle)).collect()
}

fn around(points: &[Point]) -> Bounds {
    let nothing = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
    points.iter().fold(nothing, |bounds, &[x, y]| joined(bounds, [x, y, x, y]))
}

/// Whether a line passes a rectangle: what is left of it when it is cut off at each side in turn (Liang and Barsky,
/// ACM Transactions on Graphics 3, 1984).
pub(crate) fn crosses(from: Point, to: Point, [left, bottom, right, top]: Bounds) -> bool {
    let (mut begin, mut end) = (0.0_f64, 1.0_f64);
    for (from, to, min, max) in [(from[0], to[0], left, right), (from[1], to[1], bottom, top)] {
        let along = to - from;
        for (room, along) in [(from - min, -along), (max - from, along)] {
            if along == 0.0 {
                if room < 0.0 {
                    return false;
                }
            } else if along < 0.0 {
                begin = begin.max(room / along);
            } else {
                end = end.min(room / along);
            }
        }
    }
    begin <= end
}
