//! Bends that are lost in the scatter of bends: what is left of them may point either way.

use super::{Code, Diagnostic, Limit, Quantity, Severity, Wire};
use crate::units::{Angle, digits_apart};

pub(super) fn check(wire: &Wire, found: &mut Vec<Diagnostic>) {
    let Some(scatter) = wire.scatter else { return };
    let steps = wire.nominal.iter().flat_map(|program| program.steps.iter().enumerate());
    for (index, step) in steps {
        let bend = step.bend.abs();
        if bend == Angle::ZERO || bend >= scatter.value {
            continue;
        }
        let at = wire
            .vertex_of_step(index)
            .map_or_else(|| format!(" of step {}", index + 1), |v| format!(" at vertex {v}"));
        let digits = digits_apart(bend.deg(), scatter.value.deg(), 1);
        found.push(Diagnostic {
            code: Code::BendInScatter,
            severity: Severity::Warning,
            place: wire.place_of_step(index),
            measured: Some(Quantity::Angle(bend)),
            limit: Some(Limit { value: Quantity::Angle(scatter.value), source: scatter.source.clone() }),
            message: format!(
                "the bend{at} is {bend:.digits$}, less than bends scatter on this machine ({:.digits$})",
                scatter.value
            ),
            help:
                "make the edges straight there, or the bend larger: it may come out as any bend of this size"
                    .to_owned(),
        });
    }
}
