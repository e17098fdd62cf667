//! Bends that are lost in the scatter of bends: what is left of them may point either way.

use super::{Diagnostic, Fact, Remedy, Severity, WireStages};
use crate::units::Angle;

pub(super) fn check(wire: &WireStages, found: &mut Vec<Diagnostic>) {
    let Some(scatter) = wire.scatter else { return };
    let steps = wire.nominal.iter().flat_map(|program| program.steps.iter().enumerate());
    for (index, step) in steps {
        let bend = step.bend.abs();
        if bend == Angle::ZERO || bend >= scatter.value {
            continue;
        }
        found.push(Diagnostic {
            severity: Severity::Warning,
            location: wire.location_of_step(index),
            fact: Fact::BendInScatter { bend, scatter: scatter.clone() },
            remedies: vec![Remedy::Straighten, Remedy::EnlargeBend],
        });
    }
}
