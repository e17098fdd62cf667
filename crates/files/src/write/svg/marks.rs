//! What is to be fixed: a numbered sign in the drawing, and its words in a list beside it.

use super::element::{AMBER, GREY, INK, PAPER, Page, RED, RULE, Type};
use super::sheet::Layout;
use super::view::{Projection, is_finite};
use super::{Mark, MarkAt, Severity};

fn colour(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => RED,
        Severity::Warning => AMBER,
    }
}

/// Edges get a wide band along them and a sign in their middle, vertices the sign alone.
pub(super) fn draw(page: &mut Page, marks: &[Mark], projection: &Projection) {
    let mut taken: Vec<[f64; 2]> = Vec::new();
    for (k, mark) in marks.iter().enumerate() {
        let at = match mark.at {
            MarkAt::Vertex(point) if is_finite(&point) => projection.at(point),
            MarkAt::Edge(a, b) if is_finite(&a) && is_finite(&b) => {
                let (from, to) = (projection.at(a), projection.at(b));
                let colour = colour(mark.severity);
                let band = "stroke-width=\"9\" stroke-opacity=\"0.22\" stroke-linecap=\"round\"";
                page.line(from, to, colour, band);
                page.line(
                    from,
                    to,
                    colour,
                    "stroke-width=\"2.6\" stroke-dasharray=\"6 4\" stroke-linecap=\"butt\"",
                );
                [f64::midpoint(from[0], to[0]), f64::midpoint(from[1], to[1])]
            }
            _ => continue,
        };
        let place = free_place(at, &taken);
        taken.push(place);
        page.line(at, place, colour(mark.severity), "stroke-width=\"1\"");
        page.circle(at, 2.4, &format!("fill=\"{}\"", colour(mark.severity)));
        sign(page, place, mark.severity, k + 1);
    }
}

/// Beside the place, and not on another sign.
fn free_place(at: [f64; 2], taken: &[[f64; 2]]) -> [f64; 2] {
    let spots = [
        (14.0, -14.0),
        (-14.0, -14.0),
        (14.0, 14.0),
        (-14.0, 14.0),
        (28.0, 0.0),
        (-28.0, 0.0),
        (0.0, -30.0),
        (0.0, 30.0),
    ];
    let spots = spots.map(|(x, y)| [at[0] + x, at[1] + y]);
    let free =
        |spot: &[f64; 2]| taken.iter().all(|other| (other[0] - spot[0]).hypot(other[1] - spot[1]) > 20.0);
    spots.into_iter().find(free).unwrap_or(spots[0])
}

/// A triangle for an error, a diamond for a warning, with the number of the mark.
fn sign(page: &mut Page, at: [f64; 2], severity: Severity, number: usize) {
    let outline: &[[f64; 2]] = match severity {
        Severity::Error => &[[0.0, -11.0], [11.0, 8.0], [-11.0, 8.0]],
        Severity::Warning => &[[0.0, -11.0], [11.0, 0.0], [0.0, 11.0], [-11.0, 0.0]],
    };
    let points: Vec<[f64; 2]> = outline.iter().map(|p| [at[0] + p[0], at[1] + p[1]]).collect();
    let attributes = format!(
        "fill=\"{}\" stroke=\"{PAPER}\" stroke-width=\"1.5\" stroke-linejoin=\"round\"",
        colour(severity)
    );
    page.polygon(&points, &attributes);
    let baseline = if severity == Severity::Error { 5.6 } else { 3.6 };
    let size = if number > 9 { 8.5 } else { 10.0 };
    page.text(
        [at[0], at[1] + baseline],
        &number.to_string(),
        Type::new(size, PAPER).bold().anchor("middle"),
        false,
    );
}

/// The list of what the signs mean; what does not fit is counted.
pub(super) fn list(page: &mut Page, marks: &[Mark], layout: &Layout) {
    let Some([left, top, right, bottom]) = layout.list else {
        return;
    };
    let (kind, line) = (Type::new(12.0, INK), 15.0);
    page.line([left - 16.0, top], [left - 16.0, bottom], RULE, "stroke-width=\"1\"");
    page.text([left, top + 12.0], "To fix", Type::new(13.0, INK).bold(), false);
    let mut y = top + 40.0;
    for (k, mark) in marks.iter().enumerate() {
        let words = wrap(&mark.label, kind, right - left - 30.0, 3);
        #[allow(clippy::cast_precision_loss)] // at most 3
        let height = words.len() as f64 * line;
        // The last row is for the count of what is left out, unless nothing is.
        let needed = if k + 1 == marks.len() { height } else { height + 2.0 * line };
        if y + needed > bottom {
            let more = format!("and {} more", marks.len() - k);
            page.text([left + 30.0, y], &more, Type::new(12.0, GREY), false);
            break;
        }
        sign(page, [left + 11.0, y - 4.0], mark.severity, k + 1);
        for words in words {
            page.text([left + 30.0, y], &words, kind, false);
            y += line;
        }
        y += 12.0;
    }
}

/// A text in lines that fit, broken between words; the last one is cut.
fn wrap(text: &str, kind: Type, width: f64, max_lines: usize) -> Vec<String> {
    let mut lines: Vec<String> = vec![String::new()];
    for word in text.split_whitespace() {
        let full = lines.len() == max_lines;
        if let Some(line) = lines.last_mut() {
            let longer = if line.is_empty() { word.to_owned() } else { format!("{line} {word}") };
            if line.is_empty() || full || kind.width(&longer) <= width {
                *line = longer;
                continue;
            }
        }
        lines.push(word.to_owned());
    }
    lines.iter().map(|line| kind.cut(line, width)).collect()
}
