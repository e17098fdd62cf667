//! What stands around the drawing: title block, scale bar, axes.

use super::element::{AMBER, BLUE, GREY, INK, Page, RED, RULE, Type, px};
use super::view::{Area, Projection};
use super::{Picture, Severity, View};
use crate::number::{fixed, thousands};

const MARGIN: f64 = 28.0;
const BLOCK: f64 = 76.0;
const FOOT: f64 = 44.0;
const LIST: f64 = 250.0;
const GAP: f64 = 34.0;

pub(super) struct Layout {
    pub(super) drawing: Area,
    /// What is to be fixed; none when there is nothing, or no room.
    pub(super) list: Option<Area>,
    /// The lowest strip of the page.
    block_top: f64,
}

impl Layout {
    pub(super) fn of(picture: &Picture, page: &Page) -> Self {
        let block_top = page.height - BLOCK;
        let listed = !picture.marks.is_empty() && page.width > 2.4 * LIST;
        let right = if listed { page.width - LIST - 2.0 * MARGIN } else { page.width - MARGIN };
        let list = listed.then_some([page.width - LIST, MARGIN, page.width - MARGIN, block_top - 16.0]);
        let inset = 24.0;
        let drawing = [MARGIN + inset, MARGIN + inset, right - inset, block_top - FOOT - inset];
        Self { drawing, list, block_top }
    }
}

/// Title at the left, figures in columns at the right, under a rule.
pub(super) fn title_block(page: &mut Page, picture: &Picture, layout: &Layout) {
    let (top, width) = (layout.block_top, page.width);
    page.line([0.0, top], [width, top], RULE, "stroke-width=\"1\"");
    let mut figures = vec![
        ("Length", format!("{} mm", thousands(&fixed(picture.length.mm(), 1))), INK),
        ("Bends", picture.bends.to_string(), INK),
    ];
    if picture.wires.len() > 1 {
        figures.push(("Wires", picture.wires.len().to_string(), INK));
    }
    let doubled: usize = picture.wires.iter().map(|wire| wire.doubled.len()).sum();
    if doubled > 0 {
        figures.push(("Doubled", format!("{} ═", doubled.div_ceil(2)), BLUE));
    }
    if !picture.trials.is_empty() {
        figures.push(("As bent", format!("{} ∿", picture.trials.len()), AMBER));
    }
    let errors = picture.marks.iter().filter(|mark| mark.severity == Severity::Error).count();
    if errors > 0 {
        figures.push(("Errors", format!("{errors} ▲"), RED));
    }
    let mut right = width - MARGIN;
    let (name, value) = (Type::new(11.0, GREY), Type::new(15.0, INK).bold());
    for (label, figure, colour) in figures.into_iter().rev() {
        let column = name.width(label).max(value.width(&figure)) + GAP;
        if right - column < width * 0.3 {
            break;
        }
        right -= column;
        page.text([right + GAP, top + 29.0], label, name, false);
        page.text([right + GAP, top + 50.0], &figure, Type { colour, ..value }, false);
    }
    let room = right - MARGIN - 8.0;
    let title = Type::new(18.0, INK).bold();
    page.text([MARGIN, top + 32.0], &title.cut(&picture.title, room), title, false);
    let under: Vec<&str> = picture.machine.iter().chain(&picture.material).map(String::as_str).collect();
    let small = Type::new(12.5, GREY);
    page.text([MARGIN, top + 53.0], &small.cut(&under.join("  ·  "), room), small, false);
}

/// A bar of a round length, as it looks along an axis of space.
pub(super) fn scale_bar(page: &mut Page, projection: &Projection, layout: &Layout) {
    let pixels = projection.scale * projection.view.foreshortening();
    let wanted = (layout.drawing[2] - layout.drawing[0]) / 6.0 / pixels;
    let power = 10.0_f64.powf(wanted.log10().floor());
    let length = [5.0, 2.0, 1.0].map(|step| step * power).into_iter().find(|l| *l <= wanted).unwrap_or(power);
    let (left, y) = (MARGIN, layout.block_top - 20.0);
    let right = left + length * pixels;
    let ends = "stroke-width=\"1.4\"";
    page.line([left, y], [right, y], INK, ends);
    for x in [left, f64::midpoint(left, right), right] {
        let tick = if x > left && x < right { 3.0 } else { 5.0 };
        page.line([x, y - tick], [x, y + tick], INK, ends);
    }
    let what = if projection.view == View::Isometric { " along an axis" } else { "" };
    let label = format!("{} mm{what}", px(length));
    page.text([right + 10.0, y + 4.0], &label, Type::new(11.5, GREY), false);
}

/// The three axes of space; one that points at the eye is left out.
pub(super) fn axes(page: &mut Page, projection: &Projection, layout: &Layout) {
    let room = if let Some([left, ..]) = layout.list { left - 16.0 } else { page.width };
    let (x, y) = (room - MARGIN - 30.0, layout.block_top - 24.0);
    for (k, name) in ["x", "y", "z"].into_iter().enumerate() {
        let [dx, dy] = projection.axis(k);
        if dx.hypot(dy) < 0.1 {
            continue;
        }
        let tip = [x + 26.0 * dx, y + 26.0 * dy];
        page.line([x, y], tip, GREY, "stroke-width=\"1.3\" stroke-linecap=\"round\"");
        let label = [x + 35.0 * dx, y + 35.0 * dy + 3.5];
        page.text(label, name, Type::new(11.0, GREY).anchor("middle"), false);
    }
}

/// What an empty picture says.
pub(super) fn nothing(page: &mut Page, layout: &Layout) {
    let [left, top, right, bottom] = layout.drawing;
    let at = [f64::midpoint(left, right), f64::midpoint(top, bottom)];
    page.text(at, "no wire yet", Type::new(16.0, GREY).anchor("middle"), false);
}
