//! How the wires look.

use super::{Canvas, Pen, Type};
use crate::write::svg::{PictureWire, Projection, View, is_finite};

/// Draws wires into a strip: lines, a dot at each vertex, a word at each end. Edges that are laid twice are wide and
/// grey.
pub(super) fn draw(page: &mut Canvas, wires: &[&PictureWire], [left, bottom, right, top]: [f64; 4]) {
    page.frame([left, bottom, right, top], Pen::new(0.15, 0.7));
    let inset = 8.0;
    // On a page y goes up.
    let area = [left + inset, -(top - inset), right - inset, -(bottom + inset)];
    let points = wires.iter().flat_map(|wire| &wire.points).copied();
    let Some(projection) = Projection::fit(View::Isometric, points, area) else { return };
    let at = |point| {
        let [x, y] = projection.at(point);
        [x, -y]
    };
    for wire in wires {
        let segments = || wire.points.windows(2).enumerate().filter(|(_, pair)| pair.iter().all(is_finite));
        for (_, pair) in segments().filter(|(k, _)| wire.doubled.contains(k)) {
            page.line(at(pair[0]), at(pair[1]), Pen::new(1.2, 0.7));
        }
        for (_, pair) in segments() {
            page.line(at(pair[0]), at(pair[1]), Pen::new(0.35, 0.0));
        }
        for &point in wire.points.iter().filter(|point| is_finite(point)) {
            page.circle(at(point), 0.4, Pen::new(0.3, 0.0));
        }
    }
    for (index, wire) in wires.iter().enumerate() {
        let number = if wires.len() > 1 { format!(" {}", index + 1) } else { String::new() };
        let mut ends = wire.points.iter().filter(|point| is_finite(point)).map(|&point| at(point));
        let (first, last) = (ends.next(), ends.next_back());
        let kind = Type::new(3.0).bold();
        if let Some([x, y]) = first {
            page.circle([x, y], 1.1, Pen::new(0.35, 0.0));
            page.text([x + 1.8, y + 0.8], &format!("start{number}"), kind);
        }
        let apart = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]) > 8.0;
        if let Some([x, y]) = last.filter(|&last| first.is_some_and(|first| apart(first, last))) {
            page.text([x + 1.8, y + 0.8], &format!("end{number}"), kind);
        }
    }
}
