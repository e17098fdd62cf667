//! The template at 1:1, to lay the bent wire on: its centreline with its bends as arcs, and the edges of the wire.

mod dxf;
mod labelled;
mod outline;
mod pages;
mod svg;
mod tiles;
mod views;

use nalgebra::{Point3, Vector3};
use wirebend_core::units::{Angle, DisplayUnit, Length};

pub use super::drawing::{Drawing, Layer, Shape};
pub use dxf::template_dxf;
pub use pages::{TooManyPages, template_pdf};
pub use svg::template_svg;

use super::centreline::pieces;
use super::drawing::{Point, bounds, shift};
use super::labels::LabelStep;
use super::pdf::letters::cut;
use super::plane::{self, View};
use crate::number::{length_in, short, unit_name};
use labelled::Labelled;

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
    /// The steps of each wire as designed, whose numbers, angles and lengths stand beside it; none where they are not to be there.
    pub steps: Vec<Vec<LabelStep>>,
    /// What lengths are written in; the drawing itself is in mm.
    pub unit: DisplayUnit,
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
        let steps = template.steps.get(index).map_or(&[][..], Vec::as_slice);
        let mut wire = wire(template, &path, steps, &name, &mut drawing.tightened);
        let Some([left, bottom, _, highest]) = bounds(&wire) else { continue };
        shift(&mut wire, [-left, top - highest]);
        top -= highest - bottom + GAP;
        drawing.shapes.append(&mut wire);
    }
    let title = cut(&template.title, LETTERS, false, TITLE);
    let mut lines = vec![
        format!("{title}: template 1:1"),
        format!(
            "wire of {}, bends with a centreline radius of {}",
            length(template.diameter, template.unit),
            length(template.radius, template.unit)
        ),
    ];
    if drawing.tightened > 0 {
        let tightened = drawing.tightened;
        lines.push(if tightened == 1 {
            "1 bend is drawn tighter than the machine bends it: its sides are too short".to_owned()
        } else {
            format!(
                "{tightened} bends are drawn tighter than the machine bends them: their sides are too short"
            )
        });
    }
    caption(&mut drawing.shapes, &lines, [0.0, top + GAP - 5.0]);
    drawing
}

/// The views of one wire with what stands under them.
fn wire(
    template: &Template,
    path: &[Point3<f64>],
    steps: &[LabelStep],
    name: &str,
    tightened: &mut usize,
) -> Vec<(Layer, Shape)> {
    let mut labelled = Labelled::new(steps);
    let (diameter, chord) = (template.diameter.mm(), template.chord.mm());
    let mut seen = |path: &[Point3<f64>], view: &View, views: &[View], tightened: &mut usize| {
        let (pieces, tight) = pieces(&corners(path, template.straight), template.radius);
        *tightened = tight.len();
        let mut shapes = outline::outline(&pieces, view, diameter, chord);
        labelled.add(&mut shapes, path, &pieces, view, views, template);
        shapes
    };
    let mut tight = 0;
    let (mut shapes, about) = if let Some(view) = plane::of_flat(path, template.flat, template.straight) {
        let page = View { right: Vector3::x(), up: Vector3::y() };
        let shapes = seen(&plane::laid(path, &view), &page, &[page], &mut tight);
        let [x, y, z] = [0, 1, 2].map(|k| figure(view.normal()[k]));
        (shapes, format!("{name}flat; its first bend turns left, as seen from ({x}, {y}, {z})"))
    } else {
        let shapes = views::third_angle(|view| seen(path, view, &views::all(), &mut tight));
        (shapes, format!("{name}third-angle projection: front from -y, top from +z, right from +x"))
    };
    *tightened += tight;
    if let Some([left, bottom, ..]) = bounds(&shapes) {
        let lines: Vec<String> = std::iter::once(about).chain(labelled.about(template.unit)).collect();
        caption(&mut shapes, &lines, [left, bottom - 5.0]);
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

/// A length with up to three decimals of a millimetre or four of an inch.
fn length(length: Length, unit: DisplayUnit) -> String {
    let text = length_in(unit, length.mm(), [3, 4]);
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    format!("{text} {}", unit_name(unit))
}

/// A number with up to three decimals.
fn figure(value: f64) -> String {
    short(value, 3)
}
