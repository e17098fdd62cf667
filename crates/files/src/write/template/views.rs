//! Three views of a wire that is not flat.

use nalgebra::Vector3;

use super::{GAP, LETTERS};
use crate::write::drawing::{Layer, Shape, bounds, shift};
use crate::write::plane::View;

/// Front, top and right side.
pub(super) fn all() -> [View; 3] {
    let (x, y, z) = (Vector3::x(), Vector3::y(), Vector3::z());
    [View { right: x, up: z }, View { right: x, up: y }, View { right: y, up: z }]
}

/// Front, the top above it, the right side to its right: third-angle projection, with its symbol. Each point stands at
/// the same height in front and right side, and as far to the right in front and top.
pub(super) fn third_angle(mut seen: impl FnMut(&View) -> Vec<(Layer, Shape)>) -> Vec<(Layer, Shape)> {
    let [mut front, mut top, mut right] = all().map(|view| seen(&view));
    for (view, name) in [(&mut front, "front"), (&mut top, "top"), (&mut right, "right")] {
        if let Some([left, bottom, ..]) = bounds(&*view) {
            let at = [left, bottom - 2.0 - LETTERS];
            view.push((Layer::Text, Shape::Text { at, size: LETTERS, text: name.to_owned() }));
        }
    }
    let all = [bounds(&front), bounds(&top), bounds(&right)];
    let [Some(of_front), Some(of_top), Some(of_right)] = all else { return front };
    let above = of_front[3] + GAP - of_top[1];
    let beside = of_front[2].max(of_top[2]) + GAP - of_right[0];
    shift(&mut top, [0.0, above]);
    shift(&mut right, [beside, 0.0]);
    let mut shapes = front;
    shapes.append(&mut top);
    shapes.append(&mut right);
    // Above the right side and beside the top nothing stands.
    let corner = [of_right[0] + beside + 6.0, of_front[3].max(of_right[3]) + GAP];
    shapes.extend(symbol(corner).map(|shape| (Layer::Text, shape)));
    shapes
}

/// The symbol of third-angle projection (ISO 5456-2): a cone with its tip cut off, and to its left how it looks from
/// there: the small end is in front, so both circles are seen. The left end of its axis is given.
fn symbol([x, y]: [f64; 2]) -> [Shape; 8] {
    let (small, large) = (2.0, 4.0);
    let (from, to) = (x + 14.0, x + 22.0);
    let centre = [x + 5.0, y];
    let line = |a: [f64; 2], b: [f64; 2]| Shape::Line([a, b]);
    [
        Shape::Circle { centre, radius: small },
        Shape::Circle { centre, radius: large },
        line([from, y - small], [from, y + small]),
        line([to, y - large], [to, y + large]),
        line([from, y + small], [to, y + large]),
        line([from, y - small], [to, y - large]),
        line([x, y], [x + 24.0, y]),
        line([centre[0], y - 5.0], [centre[0], y + 5.0]),
    ]
}
