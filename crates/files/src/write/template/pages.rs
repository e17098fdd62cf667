//! The template as PDF: an overview, then pages at 1:1 that are cut out and laid over one another.

use super::tiles::{OVERLAP, Tile, Tiling};
use crate::write::drawing::{Bounds, Drawing, Layer, draw, joined};
use crate::write::pdf::{Canvas, Paper, Pdf, Pen, Type, document, letters};

/// White around what a page shows, in mm: no printer reaches the edge.
const MARGIN: f64 = 10.0;
/// For the ruler and the page's name under it, in mm.
const FOOT: f64 = 14.0;
/// More pages than anybody glues together.
const MAX_PAGES: usize = 400;
/// How far chords may leave a curve where it is asked on which page it is, in mm; also how wide lines are.
const INK: f64 = 0.2;
const SHORT: &[f64] = &[1.5, 1.5];

/// A drawing that is too large to be printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("at 1:1 it takes more than {max} pages")]
pub struct TooManyPages {
    /// How many there may be.
    pub max: usize,
}

/// Writes a template as PDF, on paper that stands upright or lies, whichever takes fewer pages. The first page is an
/// overview. Each page has a ruler of 100 mm to check the print with, its name, crop marks, and the lines where its
/// neighbours begin; pages without anything on them are left out.
///
/// # Errors
/// [`TooManyPages`] beyond 400 pages.
pub fn template_pdf(drawing: &Drawing, paper: Paper) -> Result<Pdf, TooManyPages> {
    let [short, long] = paper.size_mm();
    let tiled = [[short, long], [long, short]].map(|size| {
        let window = [size[0] - 2.0 * MARGIN, size[1] - 2.0 * MARGIN - FOOT];
        Tiling::new(drawing, window, INK, MAX_PAGES).map(|tiling| (size, tiling))
    });
    let fewest = tiled.into_iter().flatten().min_by_key(|(_, tiling)| tiling.used.len());
    let (size, tiling) = fewest.ok_or(TooManyPages { max: MAX_PAGES })?;
    let mut pages = vec![overview(drawing, &tiling, paper.size_mm())];
    pages.extend(tiling.used.iter().map(|&tile| page(drawing, &tiling, tile, size)));
    Ok(document(&format!("{}: template 1:1", drawing.title), pages))
}

/// A page at 1:1.
fn page(drawing: &Drawing, tiling: &Tiling, tile: Tile, size: [f64; 2]) -> Canvas {
    let mut page = Canvas::new(size);
    let shown = tiling.shown(tile);
    let window = [MARGIN, MARGIN + FOOT, MARGIN + tiling.window[0], MARGIN + FOOT + tiling.window[1]];
    let move_by = [window[0] - shown[0], window[1] - shown[1]];
    let apart = |a: Bounds, b: Bounds| a[2] < b[0] || b[2] < a[0] || a[3] < b[1] || b[3] < a[1];
    page.within(window, |page| {
        for (layer, shape) in &drawing.shapes {
            if !apart(shape.bounds(), [shown[0] - INK, shown[1] - INK, shown[2] + INK, shown[3] + INK]) {
                draw(page, *layer, shape, 1.0, move_by);
            }
        }
    });
    crop_marks(&mut page, window);
    neighbours(&mut page, tiling, tile, window);
    let name = format!("{} of {}×{}", Tiling::name(tile), tiling.columns, tiling.rows);
    let kind = Type::new(4.5).bold();
    page.text_to([size[0] - MARGIN, MARGIN], &name, kind);
    let room = size[0] - 2.0 * MARGIN - kind.width(&name) - 5.0;
    foot(&mut page, &drawing.title, room);
    page
}

/// The ruler, and the title under it.
fn foot(page: &mut Canvas, title: &str, room: f64) {
    let (left, y) = (MARGIN, MARGIN + 6.5);
    let pen = Pen::new(0.2, 0.0);
    page.line([left, y], [left + 100.0, y], pen);
    for k in 0..=10 {
        let (x, tick) = (left + 10.0 * f64::from(k), if k % 5 == 0 { 2.5 } else { 1.5 });
        page.line([x, y], [x, y + tick], pen);
    }
    page.text([left + 103.0, y], "must measure 100 mm: print at 100 %", Type::new(3.2));
    page.text([left, MARGIN], &letters::cut(title, 3.2, false, room), Type::new(3.2).grey(0.3));
}

/// Lines beside the corners of what the page shows.
fn crop_marks(page: &mut Canvas, [left, bottom, right, top]: Bounds) {
    let (pen, gap, length) = (Pen::new(0.15, 0.0), 1.0, 3.5);
    for (x, outwards) in [(left, -1.0), (right, 1.0)] {
        for (y, up) in [(bottom, -1.0), (top, 1.0)] {
            page.line([x + outwards * gap, y], [x + outwards * (gap + length), y], pen);
            page.line([x, y + up * gap], [x, y + up * (gap + length)], pen);
        }
    }
}

/// Where the pages to the right and below begin: their edges are laid on these lines.
fn neighbours(page: &mut Canvas, tiling: &Tiling, (row, column): Tile, window: Bounds) {
    let [left, bottom, right, top] = window;
    let (pen, kind) = (Pen::new(0.12, 0.55).dashed(SHORT), Type::new(2.4).grey(0.45));
    if tiling.used.contains(&(row, column + 1)) {
        let x = right - OVERLAP;
        page.line([x, bottom], [x, top], pen);
        page.text([x + 0.8, top - 3.0], &Tiling::name((row, column + 1)), kind);
    }
    if tiling.used.contains(&(row + 1, column)) {
        let y = bottom + OVERLAP;
        page.line([left, y], [right, y], pen);
        page.text([left + 0.8, y - 3.0], &Tiling::name((row + 1, column)), kind);
    }
}

/// The whole drawing with the pages that it is on.
fn overview(drawing: &Drawing, tiling: &Tiling, size: [f64; 2]) -> Canvas {
    let mut page = Canvas::new(size);
    let room = size[0] - 2.0 * MARGIN;
    let mut y = size[1] - MARGIN - 5.0;
    let title = format!("{}: template 1:1", drawing.title);
    page.text([MARGIN, y], &letters::cut(&title, 5.5, true, room), Type::new(5.5).bold());
    y -= 3.0;
    for text in instructions(tiling) {
        for line in letters::lines(&text, 3.4, false, room) {
            y -= 4.8;
            page.text([MARGIN, y], &line, Type::new(3.4));
        }
    }
    y -= 6.0;
    let last = (tiling.rows - 1, tiling.columns - 1);
    let [left, bottom, right, top] = joined(tiling.shown((0, 0)), tiling.shown(last));
    let high = y - MARGIN - FOOT - 4.0;
    let scale = (room / (right - left)).min(high / (top - bottom)).min(0.5);
    let move_by = [MARGIN - left * scale, y - top * scale];
    let scaled = |[left, bottom, right, top]: Bounds| {
        let [x, y] = move_by;
        [left * scale + x, bottom * scale + y, right * scale + x, top * scale + y]
    };
    for &tile in &tiling.used {
        let cell = scaled(tiling.shown(tile));
        page.fill(cell, 0.95);
    }
    for &tile in &tiling.used {
        page.frame(scaled(tiling.shown(tile)), Pen::new(0.15, 0.5));
    }
    for (layer, shape) in drawing.shapes.iter().filter(|(layer, _)| *layer == Layer::Centreline) {
        draw(&mut page, *layer, shape, scale, move_by);
    }
    for &tile in &tiling.used {
        let [left, _, right, top] = scaled(tiling.shown(tile));
        let kind = Type::new(((right - left) / 5.0).clamp(1.5, 5.0)).bold().grey(0.35);
        page.text([left + 0.8, top - kind.size - 0.4], &Tiling::name(tile), kind);
    }
    page.frame(scaled([left, bottom, right, top]), Pen::new(0.15, 0.7).dashed(SHORT));
    foot(&mut page, &drawing.title, room);
    page
}

/// What to do, and which pages there are.
fn instructions(tiling: &Tiling) -> Vec<String> {
    let (all, used) = (u64::from(tiling.columns) * u64::from(tiling.rows), tiling.used.len());
    let pages = if used == 1 { "1 page follows".to_owned() } else { format!("{used} pages follow") };
    let count = |count: u32, what: &str, names: &str| match count {
        1 => format!("1 {what}"),
        _ => format!("{count} {what}s ({names}, …)"),
    };
    let mut lines = vec![format!(
        "{pages}, of {} and {}.",
        count(tiling.columns, "column", "A, B"),
        count(tiling.rows, "row", "1, 2")
    )];
    let empty = all.saturating_sub(used as u64);
    if empty > 0 {
        let places = (0..tiling.rows).flat_map(|row| (0..tiling.columns).map(move |column| (row, column)));
        let names: Vec<String> =
            places.filter(|tile| !tiling.used.contains(tile)).take(12).map(Tiling::name).collect();
        let more = if empty > 12 { ", …" } else { "" };
        let are = if empty == 1 { "page would be empty and is" } else { "pages would be empty and are" };
        lines.push(format!("{empty} {are} left out: {}{more}.", names.join(", ")));
    } else {
        lines.push("No page is left out.".to_owned());
    }
    lines.push(
        "Print at 100 %, without fitting to the page. On every page the ruler must measure 100 mm."
            .to_owned(),
    );
    if used > 1 {
        lines.push(format!(
            "Cut each page at its crop marks. Pages overlap by {OVERLAP} mm: lay the edge of the next one on the dashed line that has its name."
        ));
    }
    lines
}
