//! Wire that runs back along itself: folds of 180°, and doubled edges.

use super::{Diagnostic, Fact, Location, Remedy, Severity, WireStages};
use crate::units::Angle;

pub(super) fn check(wire: &WireStages, found: &mut Vec<Diagnostic>) {
    let steps = wire.nominal.iter().flat_map(|program| program.steps.iter().enumerate());
    for (step, _) in steps.filter(|(_, step)| step.bend == Angle::HALF_TURN) {
        // The schedule has chosen a side that can make it, if there is one.
        let made = wire.scheduled.and_then(|scheduled| scheduled.steps.get(step)).map(|step| step.bend);
        let negative = made.is_some_and(|bend| bend < Angle::ZERO);
        let limit = if negative { &wire.limits.min_bend } else { &wire.limits.max_bend };
        let refused = wire.unbendable.iter().any(|failed| failed.step == step);
        let possible = limit.value.abs() >= Angle::HALF_TURN && wire.compensation.feed.is_none() && !refused;
        found.push(Diagnostic {
            severity: if possible { Severity::Warning } else { Severity::Error },
            location: wire.location_of_step(step),
            fact: Fact::FoldBack { limit: limit.clone() },
            remedies: vec![Remedy::EndAtVertex, Remedy::ConnectVertex],
        });
    }
    for &(edge, passes) in wire.passed_again {
        found.push(Diagnostic {
            severity: Severity::Info,
            location: Location::at_edges([edge]),
            fact: Fact::DoubledEdge { edge, passes },
            remedies: vec![Remedy::LeaveRoom, Remedy::TieWires],
        });
    }
}
