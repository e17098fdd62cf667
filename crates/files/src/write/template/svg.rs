//! The template as SVG: units are mm, so that it is printed and cut at 1:1.

use std::fmt::Write as _;

use crate::number::short;
use crate::write::drawing::{Drawing, Layer, Point, Shape, on_circle};
use crate::write::svg::escape;

/// Around the drawing, in mm.
const MARGIN: f64 = 5.0;
/// For the ruler under it, in mm.
const RULER: f64 = 14.0;

/// Writes a template as SVG: a group a layer, y down, and a ruler of 100 mm to check a print with.
#[must_use]
pub fn template_svg(drawing: &Drawing) -> String {
    let [left, bottom, right, top] = drawing.bounds();
    let width = (right - left).max(110.0) + 2.0 * MARGIN;
    let height = top - bottom + 2.0 * MARGIN + RULER;
    let page = Page { left: left - MARGIN, top: top + MARGIN };
    let (w, h) = (mm(width), mm(height));
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}mm\" height=\"{h}mm\" viewBox=\"0 0 {w} {h}\" \
         font-family=\"Helvetica, Arial, sans-serif\">\n"
    );
    let _ = writeln!(text, "<title>{}</title>", escape(&drawing.title));
    for layer in Layer::ALL {
        let style = match layer {
            Layer::Centreline => {
                "fill=\"none\" stroke=\"#000\" stroke-width=\"0.18\" stroke-dasharray=\"6 1 1 1\""
            }
            Layer::Wire => "fill=\"none\" stroke=\"#000\" stroke-width=\"0.25\"",
            Layer::Text => "fill=\"none\" stroke=\"#333\" stroke-width=\"0.18\"",
        };
        let _ = writeln!(text, "<g id=\"{}\" {style}>", layer.name());
        for (_, shape) in drawing.shapes.iter().filter(|(of, _)| *of == layer) {
            page.shape(&mut text, shape);
        }
        text.push_str("</g>\n");
    }
    ruler(&mut text, height - MARGIN);
    text.push_str("</svg>\n");
    text
}

/// The place of the page's upper left corner in the drawing.
struct Page {
    left: f64,
    top: f64,
}

impl Page {
    fn at(&self, [x, y]: Point) -> [String; 2] {
        [mm(x - self.left), mm(self.top - y)]
    }

    fn shape(&self, text: &mut String, shape: &Shape) {
        let _ = match shape {
            Shape::Line([from, to]) => {
                let ([x1, y1], [x2, y2]) = (self.at(*from), self.at(*to));
                writeln!(text, "<line x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\"/>")
            }
            Shape::Arc { centre, radius, from, sweep } => {
                let [[x1, y1], [x2, y2]] =
                    [*from, from + sweep].map(|angle| self.at(on_circle(*centre, *radius, angle)));
                let large = u8::from(sweep.abs() > std::f64::consts::PI);
                // With y down, counter-clockwise is against SVG's positive direction.
                let positive = u8::from(*sweep < 0.0);
                let r = mm(*radius);
                writeln!(text, "<path d=\"M {x1} {y1} A {r} {r} 0 {large} {positive} {x2} {y2}\"/>")
            }
            Shape::Circle { centre, radius } => {
                let [x, y] = self.at(*centre);
                writeln!(text, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{}\"/>", mm(*radius))
            }
            Shape::Chain(points) => {
                let points: Vec<String> = points.iter().map(|point| self.at(*point).join(",")).collect();
                writeln!(text, "<polyline points=\"{}\"/>", points.join(" "))
            }
            Shape::Text { at, size, text: words } => {
                let [x, y] = self.at(*at);
                let attributes = format!("x=\"{x}\" y=\"{y}\" font-size=\"{}\"", mm(*size));
                writeln!(text, "<text {attributes} fill=\"#333\" stroke=\"none\">{}</text>", escape(words))
            }
        };
    }
}

/// A bar of 100 mm with a tick every 10 mm, and what to do with it.
fn ruler(text: &mut String, y: f64) {
    let _ = writeln!(text, "<g id=\"RULER\" fill=\"none\" stroke=\"#333\" stroke-width=\"0.25\">");
    let (left, right) = (MARGIN, MARGIN + 100.0);
    let y_at = mm(y);
    let _ = writeln!(text, "<line x1=\"{}\" y1=\"{y_at}\" x2=\"{}\" y2=\"{y_at}\"/>", mm(left), mm(right));
    for k in 0..=10 {
        let (x, tick) = (mm(left + 10.0 * f64::from(k)), if k % 5 == 0 { 3.0 } else { 1.5 });
        let _ = writeln!(text, "<line x1=\"{x}\" y1=\"{y_at}\" x2=\"{x}\" y2=\"{}\"/>", mm(y - tick));
    }
    let (x, y) = (mm(left + 1.0), mm(y - 4.5));
    let _ = writeln!(
        text,
        "<text x=\"{x}\" y=\"{y}\" font-size=\"3\" fill=\"#333\" stroke=\"none\">must measure 100 mm: print at 100 %</text>\n</g>"
    );
}

/// A length with five decimals at most: a hundredth of a micrometre.
fn mm(value: f64) -> String {
    short(value, 5)
}
