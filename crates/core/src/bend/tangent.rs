//! Between the two ways in which tables give straight lengths: from corner to corner of the
//! polygon, or from the end of one arc to the beginning of the next.

use super::Step;
use crate::units::{Angle, Length};

/// The straight parts of a program do not fit between its arcs.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum TangentError {
    /// A bend of 180° or more has no corner where its straight parts would meet.
    #[error("step {}: a bend of {bend:.3} has no corner; its straight parts are parallel", .step + 1)]
    NoCorner {
        /// Index of the step, from 0.
        step: usize,
        /// The bend.
        bend: Angle,
    },
}

/// How far the corner of a bend is from the ends of its arc: r·tan(|θ|/2), in mm.
fn corner(step: usize, bend: Angle, radius: Length) -> Result<f64, TangentError> {
    if bend.abs().deg() > 179.999 {
        return Err(TangentError::NoCorner { step, bend });
    }
    Ok(radius.mm() * (bend.abs().rad() / 2.0).tan())
}

/// For each step what the arcs at its two ends take off its corner-to-corner length, in mm.
fn taken(steps: &[Step], radius: Length) -> Result<Vec<f64>, TangentError> {
    let mut before = 0.0;
    let mut taken = Vec::with_capacity(steps.len());
    for (k, step) in steps.iter().enumerate() {
        let after = corner(k, step.bend, radius)?;
        taken.push(before + after);
        before = after;
    }
    Ok(taken)
}

/// Lengths between the arcs of a program whose feeds run from corner to corner, for bends of this
/// centreline radius. Below zero where the arcs overlap; `None` next to a bend of 180°, which has no
/// corner.
#[must_use]
pub fn straight_lengths(steps: &[Step], radius: Length) -> Vec<Option<Length>> {
    let mut before = Some(0.0);
    let mut lengths = Vec::with_capacity(steps.len());
    for (k, step) in steps.iter().enumerate() {
        let after = corner(k, step.bend, radius).ok();
        let left = before.zip(after).map(|(before, after)| step.feed.mm() - before - after);
        // Rounding of a table may eat a length that is exactly zero.
        lengths.push(left.map(|left| Length::computed(if left.abs() < 1e-6 { 0.0 } else { left })));
        before = after;
    }
    lengths
}

/// Corner-to-corner lengths of a program whose feeds run from tangent to tangent.
///
/// # Errors
/// [`TangentError::NoCorner`] for a bend of 180°.
pub fn intersection_lengths(steps: &[Step], radius: Length) -> Result<Vec<Length>, TangentError> {
    let taken = taken(steps, radius)?;
    Ok(steps.iter().zip(taken).map(|(s, taken)| Length::computed(s.feed.mm() + taken)).collect())
}
