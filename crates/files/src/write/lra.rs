//! LRA/YBC table: length, twist and bend of every straight part, as tube and wire benders read it.
//!
//! The twist stands on the row of the bend that it precedes, the angle has no sign, and the last row
//! has only a length.

use wirebend_core::bend::{Convention, Step, TangentError, tangent_lengths};
use wirebend_core::units::{Angle, Length};

use super::number::is_zero;
use super::table::TableStyle;

/// What the columns are called.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LraNames {
    /// L, R, A.
    #[default]
    Lra,
    /// Y, B, C.
    Ybc,
}

/// What the lengths are measured between.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Lengths {
    /// The ends of the arcs.
    #[default]
    Tangent,
    /// The corners of the polygon.
    Intersection,
}

/// How a table is written.
#[derive(Debug, Clone, PartialEq)]
pub struct LraLayout {
    /// What the columns are called.
    pub names: LraNames,
    /// What the lengths are measured between.
    pub lengths: Lengths,
    /// Centreline radius of the bends.
    pub radius: Length,
    /// Whether the radius has a column, CLR.
    pub clr_column: bool,
    /// How the machine counts its axes.
    pub convention: Convention,
    /// Separators and digits.
    pub table: TableStyle,
}

impl LraLayout {
    /// L, R, A and CLR, tangent lengths.
    #[must_use]
    pub fn lra(radius: Length) -> Self {
        Self {
            names: LraNames::Lra,
            lengths: Lengths::Tangent,
            radius,
            clr_column: true,
            convention: Convention::default(),
            table: TableStyle::default(),
        }
    }

    /// Y, B and C, tangent lengths, no radius, no header: what most controllers take.
    #[must_use]
    pub fn ybc(radius: Length) -> Self {
        let table = TableStyle { header: false, ..TableStyle::default() };
        Self { names: LraNames::Ybc, clr_column: false, table, ..Self::lra(radius) }
    }
}

/// Writes a table. A negative bend becomes a positive one by half a turn before and after it.
///
/// # Errors
/// [`TangentError`] when lengths are to be tangent lengths and the arcs of this radius overlap, or
/// a bend of 180° has no corner.
pub fn lra(steps: &[Step], layout: &LraLayout) -> Result<String, TangentError> {
    let steps = without_signs(steps);
    let lengths = match layout.lengths {
        Lengths::Tangent => tangent_lengths(&steps, layout.radius)?,
        Lengths::Intersection => steps.iter().map(|step| step.feed).collect(),
    };
    let style = layout.table;
    let columns = 3 + usize::from(layout.clr_column);
    let mut text = String::new();
    if style.header {
        let names = match layout.names {
            LraNames::Lra => ["L_mm", "R_deg", "A_deg", "CLR_mm"],
            LraNames::Ybc => ["Y_mm", "B_deg", "C_deg", "CLR_mm"],
        };
        text.push_str(&style.row(&names[..columns]));
    }
    for (k, (step, length)) in steps.iter().zip(lengths).enumerate() {
        let counted = layout.convention.apply(*step);
        let mut cells = vec![style.number(length.mm()), style.number(counted.rotate.deg())];
        cells.push(style.number(counted.bend.deg()));
        if layout.clr_column {
            cells.push(style.number(layout.radius.mm()));
        }
        // A twist that no bend follows turns nothing.
        if k + 1 == steps.len() && is_zero(&cells[2]) {
            cells[1..].fill(String::new());
        }
        text.push_str(&style.row(cells));
    }
    Ok(text)
}

/// The same wire with every bend in [0°, 180°]: (φ, -θ) is (φ + 180°, θ) and then -180°.
fn without_signs(steps: &[Step]) -> Vec<Step> {
    let mut turned_back = Angle::ZERO;
    let mut unsigned = Vec::with_capacity(steps.len());
    for step in steps {
        let negative = step.bend < Angle::ZERO;
        let half = if negative { Angle::HALF_TURN } else { Angle::ZERO };
        let rotate = (step.rotate + turned_back + half).wrapped();
        unsigned.push(Step { feed: step.feed, rotate, bend: step.bend.abs() });
        turned_back = -half;
    }
    unsigned
}
