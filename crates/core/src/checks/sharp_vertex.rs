//! Vertices through which no wire can be bent, whatever follows what: known before there is a route.

use super::bend_angle::reach_limit;
use super::{BendOf, Diagnostic, Fact, Location, ROUNDING, Remedy, Severity, WireStages};
use crate::compensate::BendError;
use crate::units::Angle;

pub(super) fn check(wire: &WireStages, found: &mut Vec<Diagnostic>) {
    // A route has its own bends, and each of them is judged.
    if wire.route.is_some() {
        return;
    }
    let (min, max) = (&wire.limits.min_bend, &wire.limits.max_bend);
    let limit = if min.value.abs() > max.value { min } else { max };
    for forced in wire.forced {
        let (bend, of) = (forced.bend, BendOf::Vertex);
        let fact = if bend.deg() > limit.value.abs().deg() + ROUNDING {
            Fact::BendTooSharp { bend, of, limit: limit.clone() }
        } else if let Some(max) = max_reach(wire, bend) {
            Fact::BendOutOfReach { bend, of, max, reach: reach_limit(wire, bend) }
        } else {
            continue;
        };
        let mut remedies = vec![Remedy::OpenAngleOfTwo];
        remedies.extend(Remedy::around(wire, forced.vertex));
        let location = Location { vertices: vec![forced.vertex], edges: forced.edges.to_vec(), step: None };
        found.push(Diagnostic { severity: Severity::Error, location, fact, remedies });
    }
}

/// The largest bend that the machine can press and keep with this wire, where the bend is beyond it to both sides.
fn max_reach(wire: &WireStages, bend: Angle) -> Option<Angle> {
    let max_to = |side: Angle| match wire.compensation.bend.command(side) {
        Err(BendError::OutOfReach { max, .. }) => Some(max),
        _ => None,
    };
    Some(max_to(bend)?.max(max_to(-bend)?))
}

#[cfg(test)]
mod tests;
