//! Tables of bends: a row for each straight part, with the rotation and the bend that follow it.

use wirebend_driver_api::{DesignStep, DriverError, Job, Wire};

use crate::grid::{Grid, MAX_UNITS};
use crate::layout::BendLayout;
use crate::measure;
use crate::refusal;
use crate::rounding::Rounding;
use crate::sheet::Sheet;
use crate::values::{Column, Handedness, RotationCount};

/// A bend below this is none, degrees: the noise of computing with floats, far below nine decimals.
const NO_BEND_DEG: f64 = 1e-10;

/// A row in units of the last place.
#[derive(Debug, Clone, Copy, Default)]
struct Row {
    length: f64,
    distance: f64,
    /// As it is written: relative or absolute.
    rotation: f64,
    bend: f64,
}

pub(crate) fn table(
    job: &Job,
    index: usize,
    wire: &Wire,
    layout: &BendLayout,
    rounding: &mut Rounding,
) -> Result<String, DriverError> {
    let style = layout.style;
    check(index, &wire.design)?;
    let mut rows = vec![Row::default(); wire.design.len()];
    if layout.columns.iter().any(|column| matches!(column, Column::Length | Column::Distance)) {
        lengths(job, index, &wire.design, layout, &mut rows, rounding)?;
    }
    turns(&wire.design, layout, &mut rows, rounding);
    let radius = style.number(style.grid.units(style.in_unit(job.bend_radius_mm)));
    let mut sheet = Sheet::new(style, &job.design_hash, layout.header.as_deref());
    for (n, row) in rows.iter().enumerate() {
        // A rotation that no bend follows turns nothing.
        let is_end = n + 1 == rows.len() && row.bend == 0.0;
        let cell = |column: &Column| match column {
            Column::Number => (n + 1).to_string(),
            Column::Length => style.number(row.length),
            Column::Distance => style.number(row.distance),
            _ if is_end => String::new(),
            Column::Rotation => style.number(row.rotation),
            Column::Angle => style.number(row.bend),
            Column::Radius => radius.clone(),
        };
        sheet.row(&layout.columns.iter().map(cell).collect::<Vec<_>>());
    }
    Ok(sheet.into_text())
}

fn check(index: usize, steps: &[DesignStep]) -> Result<(), DriverError> {
    if steps.is_empty() {
        return Err(refusal::empty(index, "steps"));
    }
    for (n, step) in steps.iter().enumerate() {
        let values = [("feed", step.feed_mm), ("rotate", step.rotate_deg), ("bend", step.bend_deg)];
        let straight = step.straight_mm.map(|value| ("straight", value));
        for (what, value) in values.into_iter().chain(straight) {
            if !value.is_finite() {
                return Err(refusal::not_a_number(index, "step", n, what, value));
            }
        }
        if step.bend_deg.abs() > 180.0 + NO_BEND_DEG {
            return Err(refusal::too_sharp(index, n, step.bend_deg));
        }
    }
    Ok(())
}

/// Each length is the difference of two rounded sums, so that the lengths add up to the rounded sum.
fn lengths(
    job: &Job,
    index: usize,
    steps: &[DesignStep],
    layout: &BendLayout,
    rows: &mut [Row],
    rounding: &mut Rounding,
) -> Result<(), DriverError> {
    let style = layout.style;
    let written_mm = |units: f64| style.grid.value(units) * style.unit.mm();
    let (mut sum, mut sum_mm) = (0.0, 0.0);
    let parts = measure::parts(index, steps, job.bend_radius_mm, layout.lengths)?;
    for (row, part) in rows.iter_mut().zip(parts) {
        let next = style.grid.units(style.in_unit(part.sum_mm));
        row.distance = style.grid.units(style.in_unit(part.distance_mm));
        if row.distance > MAX_UNITS {
            let distance = style.in_unit(part.distance_mm);
            return Err(refusal::too_long(index, distance, style.unit, style.grid.decimals));
        }
        row.length = next - sum;
        for column in &layout.columns {
            match column {
                Column::Length => rounding.length(part.sum_mm - sum_mm, written_mm(row.length)),
                Column::Distance => rounding.length(part.distance_mm, written_mm(row.distance)),
                _ => {}
            }
        }
        (sum, sum_mm) = (next, part.sum_mm);
    }
    Ok(())
}

/// Rotations are rounded where they are counted from the start; the relative ones are differences of those.
fn turns(steps: &[DesignStep], layout: &BendLayout, rows: &mut [Row], rounding: &mut Rounding) {
    let grid = layout.style.grid;
    let hand = if layout.handedness == Handedness::Left { -1.0 } else { 1.0 };
    let (mut turned_deg, mut turned, mut written) = (0.0, 0.0, 0.0);
    let mut bends = Bends { grid, carry: 0.0 };
    for (row, step) in rows.iter_mut().zip(steps) {
        let before_deg = turned_deg;
        turned_deg = (turned_deg + hand * step.rotate_deg) % 360.0;
        let next = grid.absolute(grid.units(turned_deg));
        let bend = bends.next(grid.relative(next - turned), step.bend_deg);
        match layout.rotation {
            RotationCount::Absolute => rounding.angle(turned_deg, grid.value(next)),
            RotationCount::Relative => rounding.angle(turned_deg - before_deg, grid.value(next - turned)),
        }
        rounding.angle(step.bend_deg, grid.value(bend));
        turned = next;
        // (φ, -θ) and (φ + 180°, θ) are the same bend. In units both are exact.
        let flip = layout.unsigned_bends && bend < 0.0;
        let from_start = if flip { grid.absolute(next + grid.half_turn()) } else { next };
        row.bend = if flip { -bend } else { bend };
        row.rotation = match layout.rotation {
            RotationCount::Absolute => from_start,
            RotationCount::Relative => grid.relative(from_start - written),
        };
        written = from_start;
    }
}

/// Rounds signed bends. Bends in one plane add up, so there the error of one is given to the next; out of
/// the plane it would only make the next bend worse.
struct Bends {
    grid: Grid,
    /// What the bends so far lack, about the axis of the last, in units: at most a half.
    carry: f64,
}

impl Bends {
    /// `rotation` is what turned the axis since the last bend, in units.
    fn next(&mut self, rotation: f64, bend_deg: f64) -> f64 {
        let half_turn = self.grid.half_turn();
        // Whole units: what is less than half of one apart is the same.
        if (rotation - half_turn).abs() < 0.5 {
            self.carry = -self.carry;
        } else if rotation != 0.0 {
            self.carry = 0.0;
        }
        if bend_deg.abs() < NO_BEND_DEG {
            return 0.0;
        }
        let exact = bend_deg * self.grid.scale() + self.carry;
        let units = (exact.round() + 0.0).clamp(-half_turn, half_turn);
        self.carry = exact - units;
        units
    }
}
