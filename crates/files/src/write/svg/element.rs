//! SVG text: elements, escaping, colours.

use std::fmt::Write as _;

use crate::number::short;

pub(super) const PAPER: &str = "#ffffff";
pub(super) const INK: &str = "#18212b";
pub(super) const GREY: &str = "#5b6875";
pub(super) const RULE: &str = "#d5dbe1";
pub(super) const BLUE: &str = "#1d5fd1";
pub(super) const GREEN: &str = "#14803c";
pub(super) const RED: &str = "#c81e1e";
pub(super) const AMBER: &str = "#b45309";

/// The page that elements are put on, one after another.
pub(super) struct Page {
    pub(super) width: f64,
    pub(super) height: f64,
    text: String,
}

#[derive(Clone, Copy)]
pub(super) struct Type {
    pub(super) size: f64,
    pub(super) bold: bool,
    pub(super) colour: &'static str,
    /// `start`, `middle` or `end`.
    pub(super) anchor: &'static str,
}

impl Type {
    pub(super) const fn new(size: f64, colour: &'static str) -> Self {
        Self { size, bold: false, colour, anchor: "start" }
    }

    pub(super) const fn bold(self) -> Self {
        Self { bold: true, ..self }
    }

    pub(super) const fn anchor(self, anchor: &'static str) -> Self {
        Self { anchor, ..self }
    }

    /// About how wide a text is; its letters are a little more than half as wide as high.
    pub(super) fn width(self, text: &str) -> f64 {
        #[allow(clippy::cast_precision_loss)] // a count of letters
        let letters = text.chars().count() as f64;
        letters * self.size * if self.bold { 0.6 } else { 0.55 }
    }

    /// The text, cut so that it fits.
    pub(super) fn cut(self, text: &str, width: f64) -> String {
        if self.width(text) <= width {
            return text.to_owned();
        }
        let mut short = text.to_owned();
        while !short.is_empty() && self.width(&short) + self.size > width {
            short.pop();
        }
        format!("{}…", short.trim_end())
    }
}

impl Page {
    pub(super) fn new(width: u32, height: u32, title: &str) -> Self {
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
             font-family=\"system-ui, 'Segoe UI', 'Helvetica Neue', 'DejaVu Sans', sans-serif\" font-variant-numeric=\"tabular-nums\">\n"
        );
        let _ = writeln!(text, "<title>{}</title>", escape(title));
        let _ = writeln!(text, "<rect width=\"{width}\" height=\"{height}\" fill=\"{PAPER}\"/>");
        Self { width: width.into(), height: height.into(), text }
    }

    /// An element without content; attribute values must need no escaping.
    pub(super) fn element(&mut self, name: &str, attributes: &str) {
        let _ = writeln!(self.text, "<{name} {attributes}/>");
    }

    pub(super) fn line(&mut self, from: [f64; 2], to: [f64; 2], stroke: &str, attributes: &str) {
        let [x1, y1, x2, y2] = [from[0], from[1], to[0], to[1]].map(px);
        self.element(
            "line",
            &format!("x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\" stroke=\"{stroke}\" {attributes}"),
        );
    }

    pub(super) fn circle(&mut self, at: [f64; 2], radius: f64, attributes: &str) {
        let [x, y, r] = [at[0], at[1], radius].map(px);
        self.element("circle", &format!("cx=\"{x}\" cy=\"{y}\" r=\"{r}\" {attributes}"));
    }

    pub(super) fn polygon(&mut self, points: &[[f64; 2]], attributes: &str) {
        let points: Vec<String> = points.iter().map(|p| format!("{},{}", px(p[0]), px(p[1]))).collect();
        self.element("polygon", &format!("points=\"{}\" {attributes}", points.join(" ")));
    }

    /// Text with its baseline at `at`. With `halo` it stays legible on lines.
    pub(super) fn text(&mut self, at: [f64; 2], text: &str, kind: Type, halo: bool) {
        let [x, y, size] = [at[0], at[1], kind.size].map(px);
        let weight = if kind.bold { " font-weight=\"600\"" } else { "" };
        let halo = if halo {
            format!(
                " paint-order=\"stroke\" stroke=\"{PAPER}\" stroke-width=\"3.5\" stroke-linejoin=\"round\""
            )
        } else {
            String::new()
        };
        let _ = writeln!(
            self.text,
            "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" fill=\"{}\" text-anchor=\"{}\"{weight}{halo}>{}</text>",
            kind.colour,
            kind.anchor,
            escape(text)
        );
    }

    pub(super) fn finish(mut self) -> String {
        self.text.push_str("</svg>\n");
        self.text
    }
}

/// A coordinate with two decimals, without zeros at the end.
pub(super) fn px(value: f64) -> String {
    short(value, 2)
}

/// Text inside XML; what XML cannot hold becomes a replacement character.
pub(crate) fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            '\t' | '\n' | '\r' => escaped.push(' '),
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => escaped.push('\u{fffd}'),
            c => escaped.push(c),
        }
    }
    escaped
}
