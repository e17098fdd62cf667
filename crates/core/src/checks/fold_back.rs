//! Wire that runs back along itself: folds of 180°, and edges made of two wires.

use std::collections::BTreeMap;

use super::{Code, Diagnostic, Limit, Place, Quantity, Severity, Wire};
use crate::units::Angle;

pub(super) fn check(wire: &Wire, found: &mut Vec<Diagnostic>) {
    let steps = wire.nominal.iter().flat_map(|program| program.steps.iter().enumerate());
    for (step, _) in steps.filter(|(_, step)| step.bend == Angle::HALF_TURN) {
        // The schedule has taken a side that can make it, if there is one.
        let made = wire.scheduled.and_then(|scheduled| scheduled.steps.get(step)).map(|step| step.bend);
        let negative = made.is_some_and(|bend| bend < Angle::ZERO);
        let limit = if negative { &wire.limits.least_bend } else { &wire.limits.largest_bend };
        let refused = wire.unbendable.iter().any(|failed| failed.step == step);
        let possible = limit.value.abs() >= Angle::HALF_TURN && wire.compensation.feed.is_none() && !refused;
        let at = wire.vertex_of_step(step).map_or_else(String::new, |v| format!(" at vertex {v}"));
        found.push(Diagnostic {
            code: Code::FoldBack,
            severity: if possible { Severity::Warning } else { Severity::Error },
            place: wire.place_of_step(step),
            measured: Some(Quantity::Angle(Angle::HALF_TURN)),
            limit: Some(Limit { value: Quantity::Angle(limit.value), source: limit.source.clone() }),
            message: format!("the wire folds straight back on itself{at}"),
            help: "start or end the wire there, or connect the vertex to another one".to_owned(),
        });
    }
    let mut passes: BTreeMap<_, usize> = BTreeMap::new();
    for traversal in wire.route.into_iter().flat_map(|route| &route.traversals) {
        *passes.entry(traversal.edge).or_default() += 1;
    }
    for (edge, count) in passes.into_iter().filter(|&(_, count)| count > 1) {
        found.push(Diagnostic {
            code: Code::DoubledEdge,
            severity: Severity::Info,
            place: Place::at_edges([edge]),
            measured: Some(Quantity::Count(count)),
            limit: None,
            message: format!("edge {edge} is made of {count} wires side by side"),
            help: "the wires lie on each other in the drawing; leave them room, or tie them".to_owned(),
        });
    }
}
