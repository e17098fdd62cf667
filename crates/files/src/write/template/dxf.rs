//! The template as DXF, release 12, which every CAD program and cutter reads. One unit is a millimetre.

use std::fmt::Write as _;

use crate::number::fixed;
use crate::write::drawing::{Drawing, Layer, Point, Shape};

/// Capitals of a font are so much of its size high; DXF counts their height.
const CAPITALS: f64 = 0.72;

/// Writes a template as ASCII DXF: LINE, ARC, CIRCLE, POLYLINE and TEXT on a layer for the centreline, one for the
/// wire's edges and one for text.
#[must_use]
pub fn template_dxf(drawing: &Drawing) -> String {
    let [left, bottom, right, top] = drawing.bounds();
    let mut dxf = Dxf::default();
    dxf.pair(0, "SECTION").pair(2, "HEADER");
    dxf.pair(9, "$ACADVER").pair(1, "AC1009");
    // 4: millimetres. Release 12 does not know the variable, but readers of it do.
    dxf.pair(9, "$INSUNITS").pair(70, "4");
    dxf.pair(9, "$EXTMIN").point(10, [left, bottom]).pair(9, "$EXTMAX").point(10, [right, top]);
    dxf.pair(0, "ENDSEC");
    tables(&mut dxf);
    dxf.pair(0, "SECTION").pair(2, "ENTITIES");
    for (layer, shape) in &drawing.shapes {
        entity(&mut dxf, *layer, shape);
    }
    dxf.pair(0, "ENDSEC").pair(0, "EOF");
    dxf.text
}

/// Kinds of lines, and the layers that have them.
fn tables(dxf: &mut Dxf) {
    dxf.pair(0, "SECTION").pair(2, "TABLES");
    dxf.pair(0, "TABLE").pair(2, "LTYPE").pair(70, "2");
    let center = [6.0, -1.0, 1.0, -1.0];
    for (name, about, parts) in
        [("CONTINUOUS", "solid", &[][..]), ("CENTER", "long and short dashes", &center)]
    {
        let sum = parts.iter().copied().map(f64::abs).sum();
        dxf.pair(0, "LTYPE").pair(2, name).pair(70, "64").pair(3, about).pair(72, "65");
        dxf.pair(73, &parts.len().to_string()).number(40, sum);
        for part in parts {
            dxf.number(49, *part);
        }
    }
    dxf.pair(0, "ENDTAB").pair(0, "TABLE").pair(2, "LAYER").pair(70, "3");
    for layer in Layer::ALL {
        // Red, black or white, and grey.
        let (colour, line) = match layer {
            Layer::Centreline => ("1", "CENTER"),
            Layer::Wire => ("7", "CONTINUOUS"),
            Layer::Text => ("8", "CONTINUOUS"),
        };
        dxf.pair(0, "LAYER").pair(2, layer.name()).pair(70, "0").pair(62, colour).pair(6, line);
    }
    dxf.pair(0, "ENDTAB").pair(0, "ENDSEC");
}

fn entity(dxf: &mut Dxf, layer: Layer, shape: &Shape) {
    let name = layer.name();
    match shape {
        Shape::Line([from, to]) => {
            dxf.pair(0, "LINE").pair(8, name).point(10, *from).point(11, *to);
        }
        Shape::Arc { centre, radius, from, sweep } => {
            // Always counter-clockwise.
            let (begin, end) = if *sweep < 0.0 { (from + sweep, *from) } else { (*from, from + sweep) };
            let degrees = |angle: f64| angle.to_degrees().rem_euclid(360.0);
            dxf.pair(0, "ARC").pair(8, name).point(10, *centre).number(40, *radius);
            dxf.number(50, degrees(begin)).number(51, degrees(end));
        }
        Shape::Circle { centre, radius } => {
            dxf.pair(0, "CIRCLE").pair(8, name).point(10, *centre).number(40, *radius);
        }
        Shape::Chain(points) => {
            dxf.pair(0, "POLYLINE").pair(8, name).pair(66, "1").point(10, [0.0; 2]).pair(70, "0");
            for point in points {
                dxf.pair(0, "VERTEX").pair(8, name).point(10, *point);
            }
            dxf.pair(0, "SEQEND").pair(8, name);
        }
        Shape::Text { at, size, text } => {
            dxf.pair(0, "TEXT").pair(8, name).point(10, *at).number(40, size * CAPITALS);
            dxf.pair(1, &plain(text));
        }
    }
}

/// Pairs of a group code and a value, each on a line of its own.
#[derive(Default)]
struct Dxf {
    text: String,
}

impl Dxf {
    fn pair(&mut self, code: u16, value: &str) -> &mut Self {
        let _ = writeln!(self.text, "{code:3}\n{value}");
        self
    }

    fn number(&mut self, code: u16, value: f64) -> &mut Self {
        self.pair(code, &fixed(value, 7))
    }

    /// x, y and z, whose codes are 10 apart.
    fn point(&mut self, code: u16, [x, y]: Point) -> &mut Self {
        self.number(code, x).number(code + 10, y).number(code + 20, 0.0)
    }
}

/// Text of one line in ASCII; other letters by their number in Unicode, as CAD programs write them. A `%%` would begin
/// a control code.
fn plain(text: &str) -> String {
    let mut plain = String::new();
    for c in text.chars() {
        match c {
            '%' if plain.ends_with('%') => plain.push_str(" %"),
            ' '..='~' => plain.push(c),
            c if c.is_control() => plain.push(' '),
            c => c.encode_utf16(&mut [0; 2]).iter().for_each(|unit| {
                let _ = write!(plain, "\\U+{unit:04X}");
            }),
        }
    }
    plain
}
