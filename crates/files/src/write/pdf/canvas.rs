//! A page to draw on, in mm from its lower left corner, y up.

use std::collections::BTreeSet;

use pdf_writer::types::LineCapStyle;
use pdf_writer::{Content, Name, Str};

use super::letters::{encoded, width};

/// Points of 1/72 inch in a millimetre.
const POINTS: f64 = 72.0 / 25.4;

/// How a line is drawn. Grey is from 0 for black to 1 for white.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pen {
    pub width: f64,
    pub grey: f64,
    /// Lengths of dash, gap, and so on, in mm; none for a whole line.
    pub dashes: &'static [f64],
}

impl Pen {
    pub(crate) const fn new(width: f64, grey: f64) -> Self {
        Self { width, grey, dashes: &[] }
    }

    pub(crate) const fn dashed(self, dashes: &'static [f64]) -> Self {
        Self { dashes, ..self }
    }
}

/// How text stands; the size is in mm.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Type {
    pub size: f64,
    pub bold: bool,
    pub grey: f64,
}

impl Type {
    pub(crate) const fn new(size: f64) -> Self {
        Self { size, bold: false, grey: 0.0 }
    }

    pub(crate) const fn bold(self) -> Self {
        Self { bold: true, ..self }
    }

    pub(crate) const fn grey(self, grey: f64) -> Self {
        Self { grey, ..self }
    }

    pub(crate) fn width(self, text: &str) -> f64 {
        width(text, self.size, self.bold)
    }
}

pub(crate) struct Canvas {
    /// Width and height of the page in mm.
    pub(crate) size: [f64; 2],
    pub(super) content: Content,
    /// Letters that the fonts do not have.
    pub(super) missing: BTreeSet<char>,
}

impl Canvas {
    pub(crate) fn new(size: [f64; 2]) -> Self {
        Self { size, content: Content::new(), missing: BTreeSet::new() }
    }

    fn pen(&mut self, pen: Pen) {
        let dashes = pen.dashes.iter().map(|length| points(*length));
        self.content.set_line_width(points(pen.width)).set_stroke_gray(single(pen.grey));
        self.content.set_dash_pattern(dashes, 0.0).set_line_cap(LineCapStyle::ButtCap);
    }

    /// Lines from each point to the next.
    pub(crate) fn chain(&mut self, through: &[[f64; 2]], pen: Pen) {
        let Some((first, rest)) = through.split_first() else { return };
        self.pen(pen);
        self.content.move_to(points(first[0]), points(first[1]));
        for to in rest {
            self.content.line_to(points(to[0]), points(to[1]));
        }
        self.content.stroke();
    }

    pub(crate) fn line(&mut self, from: [f64; 2], to: [f64; 2], pen: Pen) {
        self.chain(&[from, to], pen);
    }

    /// A rectangle by two corners.
    pub(crate) fn frame(&mut self, [left, bottom, right, top]: [f64; 4], pen: Pen) {
        let corners = [[left, bottom], [right, bottom], [right, top], [left, top], [left, bottom]];
        self.chain(&corners, pen);
    }

    /// A filled rectangle by two corners.
    pub(crate) fn fill(&mut self, [left, bottom, right, top]: [f64; 4], grey: f64) {
        self.content.set_fill_gray(single(grey));
        self.content.rect(points(left), points(bottom), points(right - left), points(top - bottom));
        self.content.fill_nonzero();
    }

    /// An arc, counter-clockwise where `sweep` (rad) is above zero. Cubic curves of 30° leave it by less than a
    /// millionth of its radius.
    pub(crate) fn arc(&mut self, centre: [f64; 2], radius: f64, from: f64, sweep: f64, pen: Pen) {
        self.pen(pen);
        let at = |angle: f64, [along, aside]: [f64; 2]| {
            let (sin, cos) = angle.sin_cos();
            let x = centre[0] + radius * (along * cos - aside * sin);
            [points(x), points(centre[1] + radius * (along * sin + aside * cos))]
        };
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a turn or two
        let count = (sweep.abs() / (std::f64::consts::PI / 6.0)).ceil().clamp(1.0, 64.0) as u32;
        let part = sweep / f64::from(count);
        let handle = 4.0 / 3.0 * (part / 4.0).tan();
        let [x, y] = at(from, [1.0, 0.0]);
        self.content.move_to(x, y);
        for k in 0..count {
            let (begin, end) = (from + part * f64::from(k), from + part * f64::from(k + 1));
            let [x1, y1] = at(begin, [1.0, handle]);
            let [x2, y2] = at(end, [1.0, -handle]);
            let [x3, y3] = at(end, [1.0, 0.0]);
            self.content.cubic_to(x1, y1, x2, y2, x3, y3);
        }
        self.content.stroke();
    }

    pub(crate) fn circle(&mut self, centre: [f64; 2], radius: f64, pen: Pen) {
        self.arc(centre, radius, 0.0, std::f64::consts::TAU, pen);
    }

    /// Text with the left end of its baseline at a point.
    pub(crate) fn text(&mut self, [x, y]: [f64; 2], text: &str, kind: Type) {
        let bytes = encoded(text, &mut self.missing);
        self.content.set_fill_gray(single(kind.grey)).begin_text();
        self.content.set_font(Name(if kind.bold { b"F2" } else { b"F1" }), points(kind.size));
        self.content.next_line(points(x), points(y)).show(Str(&bytes)).end_text();
    }

    /// Text with the right end of its baseline at a point. Of figures it stands exactly there.
    pub(crate) fn text_to(&mut self, [x, y]: [f64; 2], text: &str, kind: Type) {
        self.text([x - kind.width(text), y], text, kind);
    }

    /// Draws with a rectangle as the window: what is outside of it stays white.
    pub(crate) fn within(&mut self, [left, bottom, right, top]: [f64; 4], draw: impl FnOnce(&mut Self)) {
        self.content.save_state();
        self.content.rect(points(left), points(bottom), points(right - left), points(top - bottom));
        self.content.clip_nonzero().end_path();
        draw(self);
        self.content.restore_state();
    }
}

fn points(mm: f64) -> f32 {
    single(mm * POINTS)
}

#[allow(clippy::cast_possible_truncation)] // a thousandth of a point is kept within two metres
fn single(value: f64) -> f32 {
    value as f32
}
