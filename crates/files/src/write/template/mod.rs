//! The template at 1:1, to lay the bent wire on: its centreline with its bends as arcs, and the edges of the wire.

mod drawing;
mod dxf;
mod outline;
mod pages;
mod plane;
mod svg;
mod tiles;
mod views;

use nalgebra::{Point3, Vector3};
use wirebend_core::units::{Angle, Length};

pub use drawing::{Drawing, Layer, Shape};
pub use dxf::template_dxf;
pub use pages::{TooManyPages, template_pdf};
pub use svg::template_svg;

use super::centreline::{Piece, pieces};
use super::pdf::letters::cut;
use crate::number::short;
use drawing::{Point, bounds, shift};
use plane::View;

/// Size of the letters in mm.
const LETTERS: f64 = 3.5;
/// From the origin, in mm: what is farther away overflows when it is squared some times.
const FARTHEST: f64 = 1e9;
/// Width of a title in mm: a longer one would need pages of its own.
const TITLE: f64 = 140.0;
/// Between wires, and between the views of one, in mm.
const GAP: f64 = 20.0;

/// What a template is made of. Points are in mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Template {
    /// The name of the design.
    pub title: String,
    /// The paths of the wires.
    pub wires: Vec<Vec<Point3<f64>>>,
    /// Diameter of the wire.
    pub diameter: Length,
    /// Centreline radius of the machine's bends.
    pub radius: Length,
    /// How far a point of a wire may be from a plane for the wire to be flat.
    pub flat: Length,
    /// A bend up to this is none.
    pub straight: Angle,
    /// How far chords may leave a curve that is no circle.
    pub chord: Length,
}

/// Draws a template. A flat wire is laid into its plane and seen from the side on which its first bend turns left;
/// of others there are three views in third-angle projection. Several wires stand one under the other. Points that are
/// not finite or farther than a thousand kilometres away are left out.
#[must_use]
pub fn template(template: &Template) -> Drawing {
    let mut drawing = Drawing { title: template.title.clone(), ..Drawing::default() };
    let mut top = 0.0;
    for (index, path) in template.wires.iter().enumerate() {
        let path: Vec<Point3<f64>> =
            path.iter().copied().filter(|point| point.coords.iter().all(|c| c.abs() < FARTHEST)).collect();
        let name = if template.wires.len() > 1 { format!("wire {}: ", index + 1) } else { String::new() };
        let mut wire = wire(template, &path, &name, &mut drawing.tightened);
        let Some([left, bottom, _, highest]) = bounds(&wire) else { continue };
        shift(&mut wire, [-left, top - highest]);
        top -= highest - bottom + GAP;
        drawing.shapes.append(&mut wire);
    }
    let title = cut(&template.title, LETTERS, false, TITLE);
    let mut lines = vec![
        format!("{title}: template 1:1"),
        format!(
            "wire of {} mm, bends with a centreline radius of {} mm",
            figure(template.diameter.mm()),
            figure(template.radius.mm())
        ),
    ];
    if drawing.tightened > 0 {
        let tightened = drawing.tightened;
        lines.push(format!(
            "{tightened} bends are drawn tighter than the machine bends them: their sides are too short"
        ));
    }
    caption(&mut drawing.shapes, &lines, [0.0, top + GAP - 5.0]);
    drawing
}

/// The views of one wire with what stands under them.
fn wire(template: &Template, path: &[Point3<f64>], name: &str, tightened: &mut usize) -> Vec<(Layer, Shape)> {
    let seen = |path: &[Point3<f64>], view: &View, tightened: &mut usize| {
        let (pieces, tight) = pieces(&corners(path, template.straight), template.radius);
        *tightened = tight.len();
        let mut shapes = outline::outline(&pieces, view, template.diameter.mm(), template.chord.mm());
        marks(&mut shapes, &pieces, view, template.diameter.mm());
        shapes
    };
    let mut tight = 0;
    let (mut shapes, about) = if let Some(view) = plane::of_flat(path, template.flat, template.straight) {
        let page = View { right: Vector3::x(), up: Vector3::y() };
        let shapes = seen(&plane::laid(path, &view), &page, &mut tight);
        let [x, y, z] = [0, 1, 2].map(|k| figure(view.normal()[k]));
        (shapes, format!("{name}flat; its first bend turns left, as seen from ({x}, {y}, {z})"))
    } else {
        let shapes = views::third_angle(|view| seen(path, view, &mut tight));
        (shapes, format!("{name}third-angle projection: front from -y, top from +z, right from +x"))
    };
    *tightened += tight;
    if let Some([left, bottom, ..]) = bounds(&shapes) {
        caption(&mut shapes, &[about], [left, bottom - 5.0]);
    }
    shapes
}

/// The ends of a path and the points where it turns by more than `straight`: arcs may run past the others.
fn corners(path: &[Point3<f64>], straight: Angle) -> Vec<Point3<f64>> {
    let mut corners: Vec<Point3<f64>> = path.first().copied().into_iter().collect();
    for three in path.windows(3) {
        let from = corners.last().copied().unwrap_or(three[0]);
        let (before, after) = (three[1] - from, three[2] - three[1]);
        if before.cross(&after).norm().atan2(before.dot(&after)) > straight.rad().abs().max(1e-9) {
            corners.push(three[1]);
        }
    }
    corners.extend(path.last().copied().filter(|_| path.len() > 1));
    corners
}

/// Lines of text from a point down.
fn caption(shapes: &mut Vec<(Layer, Shape)>, lines: &[String], [x, y]: Point) {
    let mut y = y;
    for text in lines {
        y -= LETTERS;
        shapes.push((Layer::Text, Shape::Text { at: [x, y], size: LETTERS, text: text.clone() }));
        y -= LETTERS * 0.5;
    }
}

/// Words at both ends of a wire, on the side where it is not.
fn marks(shapes: &mut Vec<(Layer, Shape)>, pieces: &[Piece], view: &View, diameter: f64) {
    let ends = [(pieces.first(), 0.0, -1.0, "start"), (pieces.last(), 1.0, 1.0, "end")];
    for (piece, at, sign, word) in ends {
        let Some((point, tangent)) = piece.map(|piece| outline::end_of(piece, at, view)) else { continue };
        let away = tangent.map(|c| c * sign);
        let room = diameter / 2.0 + 1.5;
        let text = Shape::Text { at: [0.0; 2], size: LETTERS, text: word.to_owned() };
        let [_, _, width, height] = text.bounds();
        // Seen along the wire, the word stands above its end.
        let at = if away[0].abs() > away[1].abs().max(0.01) {
            let x = if away[0] < 0.0 { point[0] - room - width } else { point[0] + room };
            [x, point[1] - LETTERS * 0.36]
        } else {
            let y = if away[1] < 0.0 { point[1] - room - height } else { point[1] + room };
            [point[0] - width / 2.0, y]
        };
        shapes.push((Layer::Text, Shape::Text { at, size: LETTERS, text: word.to_owned() }));
    }
}

/// A number with up to three decimals.
fn figure(value: f64) -> String {
    short(value, 3)
}
