//! Tables of corners.

use wirebend_driver_api::{DriverError, Job, Wire};

use crate::grid::MAX_UNITS;
use crate::layout::PointLayout;
use crate::refusal;
use crate::rounding::Rounding;
use crate::sheet::Sheet;
use crate::values::PointColumn;

/// A row for each corner, from the start of the wire to its end. Points do not depend on one another, so
/// each is rounded alone.
pub(crate) fn table(
    job: &Job,
    index: usize,
    wire: &Wire,
    layout: &PointLayout,
    rounding: &mut Rounding,
) -> Result<String, DriverError> {
    let style = layout.style;
    let last = wire.path_mm.len().checked_sub(1).ok_or_else(|| refusal::empty(index, "points"))?;
    let mut sheet = Sheet::new(style, &job.design_hash, layout.header.as_deref());
    for (n, point) in wire.path_mm.iter().enumerate() {
        let mut coordinates = [0.0; 3];
        for ((units, &mm), axis) in coordinates.iter_mut().zip(point).zip(["x", "y", "z"]) {
            if !mm.is_finite() {
                return Err(refusal::not_a_number(index, "point", n, axis, mm));
            }
            *units = style.grid.units(style.in_unit(mm));
            if units.abs() > MAX_UNITS {
                return Err(refusal::too_long(index, style.in_unit(mm), style.unit, style.grid.decimals));
            }
            rounding.length(mm, style.grid.value(*units) * style.unit.mm());
        }
        let [x, y, z] = coordinates;
        let cell = |column: &PointColumn| match column {
            PointColumn::Number => (n + 1).to_string(),
            PointColumn::X => style.number(x),
            PointColumn::Y => style.number(y),
            PointColumn::Z => style.number(z),
            PointColumn::Radius if n == 0 || n == last => String::new(),
            PointColumn::Radius => style.number(style.grid.units(style.in_unit(job.bend_radius_mm))),
        };
        sheet.row(&layout.columns.iter().map(cell).collect::<Vec<_>>());
    }
    Ok(sheet.into_text())
}
