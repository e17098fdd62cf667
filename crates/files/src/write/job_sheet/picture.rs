//! How the wires look.

use nalgebra::{Point3, Vector3};

use super::{Canvas, JobSheet, Pen};
use crate::number::unit_word;
use crate::write::drawing::{Bounds, Layer, Point, draw as draw_shape};
use crate::write::labels::{BendAt, EdgeAt, LabelStep, Spots, Style, WordAt, labels, left_out, spots};
use crate::write::plane;
use crate::write::svg::{Projection, View, is_finite};

/// Half the width of a line for an edge that is laid twice, in mm.
const HALF: f64 = 0.6;
/// Around the wire, for its labels, in mm.
const INSET: f64 = 12.0;
/// The size of labels in mm.
const LETTERS: f64 = 2.5;
/// What looks along an axis nearer than that, as the cosine of the angle, is called by its name.
const ALONG: f64 = 0.9999;

/// A wire on the page.
struct Seen {
    points: Vec<Point3<f64>>,
    on_page: Vec<Point>,
    steps: Vec<LabelStep>,
}

/// Draws wires into a strip: lines, a dot at each vertex, a word at each end, numbers, angles and lengths beside them. Edges that are laid
/// twice are wide and grey. Wires that lie in one plane are seen straight from above it. Gives how to read the picture.
pub(super) fn draw(page: &mut Canvas, sheet: &JobSheet, frame: Bounds) -> Vec<String> {
    page.frame(frame, Pen::new(0.15, 0.7));
    let [left, bottom, right, top] = frame;
    // On a page y goes up.
    let area = [left + INSET, -(top - INSET), right - INSET, -(bottom + INSET)];
    let all: Vec<Point3<f64>> =
        sheet.wires.iter().flat_map(|wire| &wire.picture.points).copied().filter(is_finite).collect();
    let flat = plane::of_flat(&all, sheet.flat, sheet.straight);
    let laid = |points: &[Point3<f64>]| match &flat {
        Some(view) => plane::laid(points, view),
        None => points.to_vec(),
    };
    let view = if flat.is_some() { View::Top } else { View::Isometric };
    let Some(projection) = Projection::fit(view, laid(&all).into_iter(), area) else { return Vec::new() };
    let at = |point| {
        let [x, y] = projection.at(point);
        [x, -y]
    };
    let seen: Vec<Seen> = sheet
        .wires
        .iter()
        .map(|wire| {
            let steps = wire
                .steps
                .iter()
                .map(|step| LabelStep { feed_mm: step.designed[0], bend_deg: step.designed[2] });
            let points = laid(&wire.picture.points);
            let on_page = points.iter().map(|&point| at(point)).collect();
            Seen { points, on_page, steps: steps.collect() }
        })
        .collect();
    let mut lines = Vec::new();
    for (wire, of) in sheet.wires.iter().zip(&seen) {
        let segments = || {
            of.on_page.windows(2).enumerate().filter(|(_, pair)| pair.iter().flatten().all(|c| c.is_finite()))
        };
        for (_, pair) in segments().filter(|(k, _)| wire.picture.doubled.contains(k)) {
            page.line(pair[0], pair[1], Pen::new(2.0 * HALF, 0.7));
        }
        for (_, pair) in segments() {
            page.line(pair[0], pair[1], Pen::new(0.35, 0.0));
            lines.push([pair[0], pair[1]]);
        }
        for &point in of.on_page.iter().filter(|point| point.iter().all(|c| c.is_finite())) {
            page.circle(point, 0.4, Pen::new(0.3, 0.0));
        }
    }
    let several = seen.len() > 1;
    let words: Vec<WordAt> =
        seen.iter().enumerate().flat_map(|(k, wire)| words(page, wire, several.then_some(k + 1))).collect();
    let (mut bends, mut edges) = (Vec::new(), Vec::new());
    for wire in &seen {
        let Spots { bends: of_wire, edges: between } = spots(&wire.points, &wire.steps);
        bends.extend(of_wire.iter().map(|bend| {
            let corner = at(bend.at);
            let sides = bend.sides.map(|side| {
                let [x, y] = at(bend.at + side);
                [x - corner[0], y - corner[1]]
            });
            BendAt { number: bend.number, at: corner, sides, angle_deg: bend.angle_deg }
        }));
        edges
            .extend(between.iter().map(|edge| EdgeAt { ends: edge.ends.map(at), length_mm: edge.length_mm }));
    }
    let room = Some([left + 1.0, bottom + 1.0, right - 1.0, top - 1.0]);
    let style = Style { size: LETTERS, half: HALF, room, unit: sheet.unit };
    let found = labels(&lines, &words, &bends, &edges, style);
    for shape in &found.shapes {
        draw_shape(page, Layer::Text, shape, 1.0, [0.0; 2]);
    }
    if bends.is_empty() && edges.is_empty() {
        return Vec::new();
    }
    let unit = unit_word(sheet.unit);
    let read = format!(
        "In circles the numbers of the steps, with the angles as designed; lengths in {unit}, from corner to corner."
    );
    let [numbers, angles] = [&found.numbered, &found.with_angle].map(|some| bends.len() - some.len());
    let missing = left_out(numbers, angles, found.without_length);
    let from = flat.map(|view| seen_from(&view.normal(), !bends.is_empty()));
    from.into_iter()
        .chain(std::iter::once(read))
        .chain(missing.map(|what| format!("No room for {what}: all are in the table of steps.")))
        .collect()
}

/// What the ends are called, and a circle at the start. An end that is where the wire starts has no word.
fn words(page: &mut Canvas, wire: &Seen, number: Option<usize>) -> Vec<WordAt> {
    let number = number.map(|number| format!(" {number}")).unwrap_or_default();
    let mut ends = wire.on_page.iter().copied().filter(|point| point.iter().all(|c| c.is_finite()));
    let Some(first) = ends.next() else { return Vec::new() };
    page.circle(first, 1.1, Pen::new(0.35, 0.0));
    let away = |from: Point, point: Point| [point[0] - from[0], point[1] - from[1]];
    let second = ends.clone().next().unwrap_or(first);
    let mut words = vec![WordAt { word: format!("start{number}"), at: first, away: away(second, first) }];
    let apart = |a: Point, b: Point| (a[0] - b[0]).hypot(a[1] - b[1]) > 8.0;
    if let Some(last) = ends.next_back().filter(|&last| apart(first, last)) {
        let before = ends.next_back().unwrap_or(first);
        words.push(WordAt { word: format!("end{number}"), at: last, away: away(before, last) });
    }
    words
}

/// From where a flat wire is seen, with the name of the window's view of the design that looks the same way.
fn seen_from(normal: &Vector3<f64>, bends: bool) -> String {
    let sides = [
        (Vector3::z(), "Top"),
        (-Vector3::z(), "Bottom"),
        (-Vector3::y(), "Front"),
        (Vector3::y(), "Back"),
        (Vector3::x(), "Right"),
        (-Vector3::x(), "Left"),
    ];
    let side = sides.iter().find(|(side, _)| normal.dot(side) > ALONG);
    let view = side.map(|(_, name)| format!(", as in the view {name}")).unwrap_or_default();
    let left = if bends { ": its first bend turns left" } else { "" };
    format!("Seen straight from above its plane{view}{left}.")
}
