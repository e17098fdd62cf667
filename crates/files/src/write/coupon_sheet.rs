//! The printed sheet of a calibration: a protractor in true size to lay coupons on, and boxes for what is read of them.

use super::pdf::flow::{Flow, SMALL};
use super::pdf::{Canvas, Paper, Pdf, Pen, Type, document};
use crate::number::{fixed, short};

/// What stands on it.
#[derive(Debug, Clone, PartialEq)]
pub struct CouponSheet {
    pub machine: String,
    /// The wire in it.
    pub material: String,
    pub wire_diameter_mm: f64,
    pub coupons: Vec<PrintedCoupon>,
    /// How often each is bent.
    pub repeats: u32,
    /// What it is printed on.
    pub paper: Paper,
}

/// A coupon: a wire that is bent to be measured.
#[derive(Debug, Clone, PartialEq)]
pub struct PrintedCoupon {
    pub name: String,
    /// Wire that is fed for one of them, mm.
    pub wire_mm: f64,
    pub readings: Vec<PrintedReading>,
}

/// One thing that is read of a coupon.
#[derive(Debug, Clone, PartialEq)]
pub struct PrintedReading {
    /// What is measured, as the table calls it.
    pub what: &'static str,
    /// What is wanted, in mm or degrees.
    pub wanted: f64,
    pub unit: &'static str,
    /// It is read with the protractor.
    pub is_bend: bool,
}

/// Radius of the scale, mm.
const RADIUS: f64 = 76.0;
/// Where lines of neighbouring angles would cross, they begin farther from the corner: this far at most, mm.
const MAX_BEGIN: f64 = 50.0;
/// How far beyond the scale names stand, mm: those of angles near each other by turns.
const NAMES: [f64; 3] = [8.5, 12.5, 16.5];
/// Names of angles farther apart, degrees, do not meet.
const APART_DEG: f64 = 11.0;
const RULER_MM: i32 = 150;
/// Nearer to the name of a coupon, degrees, no number stands at the scale.
const NAMED_DEG: f64 = 7.0;
/// Boxes for readings in a row.
const BOXES: u32 = 8;
const LETTERS: Type = Type::new(3.0);

/// Writes it. The same sheet gives the same bytes.
#[must_use]
pub fn coupon_sheet(sheet: &CouponSheet) -> Pdf {
    let mut flow = Flow::new(sheet.paper.size_mm());
    flow.text("Coupons", Type::new(6.0).bold());
    flow.text(&format!("{} with {}", sheet.machine, sheet.material), Type::new(3.6));
    flow.gap(1.0);
    flow.text("Print at 100 %. The ruler must measure 150 mm.", SMALL);
    flow.gap(6.0);
    let angles = ladder(sheet);
    if !angles.is_empty() {
        let [left, bottom, right, _] = flow.take(RADIUS + 24.0);
        let centre = [f64::midpoint(left, right), bottom + 6.0];
        protractor(flow.page(), centre, sheet.wire_diameter_mm, &angles);
        flow.text(
            "Lay the leg that was fed first into the lines at the left, with the corner in the middle. The other leg points to how far the wire turns: 0° is straight. For a bend to the other side, turn the wire over.",
            SMALL,
        );
        flow.gap(4.0);
    }
    let [left, bottom, right, _] = flow.take(10.0);
    ruler(flow.page(), [f64::midpoint(left, right) - f64::from(RULER_MM) / 2.0, bottom + 5.0]);
    flow.heading("Readings", 14.0);
    flow.text(
        "bend: how far the wire turns. side: over the outside of the U, with a caliper. turn, turn-back: between the planes of two bends that follow each other.",
        SMALL,
    );
    flow.gap(1.0);
    table(&mut flow, sheet);
    document("Coupons", flow.finish(&format!("Coupons of {} with {}", sheet.machine, sheet.material)))
}

/// The angles of the ladder, each with the name of its coupon.
fn ladder(sheet: &CouponSheet) -> Vec<(f64, &str)> {
    let bends = sheet.coupons.iter().flat_map(|coupon| {
        let bends = coupon.readings.iter().filter(|reading| reading.is_bend && reading.wanted > 0.0);
        bends.map(|reading| (reading.wanted, coupon.name.as_str()))
    });
    let mut angles: Vec<_> = bends.collect();
    angles.sort_by(|a, b| a.0.total_cmp(&b.0));
    angles
}

fn protractor(page: &mut Canvas, centre: [f64; 2], diameter: f64, angles: &[(f64, &str)]) {
    let fine = Pen::new(0.15, 0.35);
    let at = |deg: f64, radius: f64, aside: f64| {
        let (sin, cos) = deg.to_radians().sin_cos();
        [centre[0] + radius * cos - aside * sin, centre[1] + radius * sin + aside * cos]
    };
    page.arc(centre, RADIUS, 0.0, std::f64::consts::PI, Pen::new(0.25, 0.0));
    for deg in 0..=180 {
        let length = if deg % 10 == 0 {
            6.0
        } else if deg % 5 == 0 {
            4.0
        } else {
            2.5
        };
        let deg = f64::from(deg);
        page.line(at(deg, RADIUS - length, 0.0), at(deg, RADIUS, 0.0), fine);
    }
    for deg in (0..=180).step_by(10).map(f64::from) {
        // The name of a coupon says its angle.
        if angles.iter().all(|(angle, _)| (angle - deg).abs() > NAMED_DEG) {
            centred(page, at(deg, RADIUS + 3.5, 0.0), &short(deg, 0), SMALL);
        }
    }
    // The wire lies between two lines, those of a leg that is not bent on both sides.
    let half = diameter / 2.0;
    let lines = |page: &mut Canvas, deg: f64, from: f64, pen: Pen| {
        for aside in [-half, half] {
            page.line(at(deg, from, aside), at(deg, RADIUS - 7.0, aside), pen);
        }
    };
    lines(page, 180.0, 0.0, Pen::new(0.35, 0.0));
    let between = angles.windows(2).map(|pair| pair[1].0 - pair[0].0).fold(45.0, f64::min);
    let from = (half / (between / 2.0).to_radians().tan() + 4.0).clamp(6.0, MAX_BEGIN);
    let mut before: Option<(f64, usize)> = None;
    for &(deg, name) in angles {
        let near = before.filter(|(before, _)| deg - before < APART_DEG);
        let row = near.map_or(0, |(_, row)| (row + 1) % NAMES.len());
        before = Some((deg, row));
        lines(page, deg, from, Pen::new(0.25, 0.0));
        page.line(at(deg, RADIUS, 0.0), at(deg, RADIUS + NAMES[row] - 3.0, 0.0), Pen::new(0.25, 0.0));
        centred(page, at(deg, RADIUS + NAMES[row], 0.0), name, LETTERS.bold());
    }
    for deg in [0.0, 90.0] {
        page.line(at(deg, -4.0, 0.0), at(deg, 4.0, 0.0), Pen::new(0.25, 0.0));
    }
}

/// Text around a point.
fn centred(page: &mut Canvas, [x, y]: [f64; 2], text: &str, kind: Type) {
    page.text([x - kind.width(text) / 2.0, y - kind.size * 0.36], text, kind);
}

fn ruler(page: &mut Canvas, [left, y]: [f64; 2]) {
    let fine = Pen::new(0.15, 0.0);
    page.line([left, y], [left + f64::from(RULER_MM), y], fine);
    for mm in 0..=RULER_MM {
        let length = if mm % 10 == 0 {
            4.0
        } else if mm % 5 == 0 {
            3.0
        } else {
            2.0
        };
        let x = left + f64::from(mm);
        page.line([x, y], [x, y + length], fine);
        if mm % 10 == 0 {
            centred(page, [x, y - 2.2], &mm.to_string(), SMALL);
        }
    }
}

/// Where the columns of the table end, mm from the left: coupon, wire, what, wanted.
const ENDS: [f64; 4] = [34.0, 50.0, 72.0, 90.0];
const ROW: f64 = 7.0;

fn table(flow: &mut Flow, sheet: &CouponSheet) {
    let repeats = format!("{} × each", sheet.repeats);
    names(flow, &repeats);
    for coupon in &sheet.coupons {
        let lines = sheet.repeats.div_ceil(BOXES).max(1);
        // What belongs to one coupon stays on one page where a page has the room.
        let rows = u32::try_from(coupon.readings.len()).unwrap_or(u32::MAX).saturating_mul(lines).min(20);
        if !flow.fits(ROW * f64::from(rows)) {
            flow.next_page();
            names(flow, &repeats);
        }
        for (index, reading) in coupon.readings.iter().enumerate() {
            for line in 0..lines {
                let [left, bottom, right, top] = flow.take(ROW);
                let base = bottom + 2.2;
                if line == 0 {
                    if index == 0 {
                        flow.page().line([left, top], [right, top], Pen::new(0.15, 0.6));
                        flow.page().text([left, base], &coupon.name, LETTERS.bold());
                        flow.page().text_to([left + ENDS[1], base], &fixed(coupon.wire_mm, 0), LETTERS);
                    }
                    flow.page().text([left + ENDS[1] + 4.0, base], reading.what, LETTERS);
                    let wanted = format!("{}{}", short(reading.wanted, 2), reading.unit);
                    flow.page().text_to([left + ENDS[3], base], &wanted, LETTERS);
                }
                let width = (right - left - ENDS[3] - 4.0) / f64::from(BOXES);
                for k in 0..(sheet.repeats - line * BOXES).min(BOXES) {
                    let x = left + ENDS[3] + 4.0 + width * f64::from(k);
                    flow.page().frame([x, bottom + 0.8, x + width - 0.8, top - 0.8], Pen::new(0.2, 0.4));
                }
            }
        }
    }
}

fn names(flow: &mut Flow, repeats: &str) {
    let [left, bottom, ..] = flow.take(4.6);
    let page = flow.page();
    page.text([left, bottom + 1.2], "coupon", SMALL);
    page.text_to([left + ENDS[1], bottom + 1.2], "wire mm", SMALL);
    page.text([left + ENDS[1] + 4.0, bottom + 1.2], "read", SMALL);
    page.text_to([left + ENDS[3], bottom + 1.2], "wanted", SMALL);
    page.text([left + ENDS[3] + 4.0, bottom + 1.2], repeats, SMALL);
}
