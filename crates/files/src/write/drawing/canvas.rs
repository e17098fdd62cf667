//! Shapes on a page.

use super::{Layer, Point, Shape};
use crate::write::pdf::{Canvas, Pen, Type};

const DASHES: &[f64] = &[6.0, 1.0, 1.0, 1.0];

/// A shape, scaled and then moved.
pub(crate) fn draw(page: &mut Canvas, layer: Layer, shape: &Shape, scale: f64, [x, y]: Point) {
    let at = |point: Point| [point[0] * scale + x, point[1] * scale + y];
    let pen = match layer {
        Layer::Centreline if scale < 1.0 => Pen::new(0.3, 0.0),
        Layer::Centreline => Pen::new(0.15, 0.0).dashed(DASHES),
        Layer::Wire => Pen::new(0.25, 0.0),
        Layer::Text => Pen::new(0.15, 0.2),
    };
    match shape {
        Shape::Line(points) => page.chain(&points.map(at), pen),
        Shape::Chain(points) => page.chain(&points.iter().map(|point| at(*point)).collect::<Vec<_>>(), pen),
        Shape::Circle { centre, radius } => page.circle(at(*centre), radius * scale, pen),
        Shape::Arc { centre, radius, from, sweep } => {
            page.arc(at(*centre), radius * scale, *from, *sweep, pen);
        }
        Shape::Text { at: place, size, text } => {
            page.text(at(*place), text, Type::new(size * scale).grey(0.2));
        }
    }
}
