//! Vertices through which no wire can be bent, whichever two edges it takes: known before there is a route.

use super::bend_angle::reach_limit;
use super::{BendOf, Diagnostic, Fact, Location, ROUNDING, Remedy, Severity, WireStages};
use crate::compensate::BendError;
use crate::units::Angle;
use crate::wireframe::VertexId;

pub(super) fn check(wire: &WireStages, found: &mut Vec<Diagnostic>) {
    // A route has its own bends, and each of them is judged.
    if wire.route.is_some() {
        return;
    }
    let (min, max) = (&wire.limits.min_bend, &wire.limits.max_bend);
    let limit = if min.value.abs() > max.value { min } else { max };
    for &vertex in &wire.component.vertices {
        let Some(bend) = gentlest(wire, vertex) else { continue };
        let of = BendOf::Vertex;
        let fact = if bend.deg() > limit.value.abs().deg() + ROUNDING {
            Fact::BendTooSharp { bend, of, limit: limit.clone() }
        } else if let Some(max) = max_reach(wire, bend) {
            Fact::BendOutOfReach { bend, of, max, reach: reach_limit(wire, bend) }
        } else {
            continue;
        };
        // The two ends of a closed wire may lie at a vertex of two edges: there it is not bent.
        let passes = !wire.closed || wire.wireframe.incident(vertex).len() > 2;
        found.push(Diagnostic {
            severity: if passes { Severity::Error } else { Severity::Warning },
            location: Location::at_vertices([vertex]),
            fact,
            remedies: if passes {
                vec![Remedy::OpenAngleOfTwo]
            } else {
                vec![Remedy::OpenAngle, Remedy::StartAtVertex]
            },
        });
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

/// The smallest bend with which a wire passes through a vertex; none where it only ends, or where an edge has no
/// length.
fn gentlest(wire: &WireStages, vertex: VertexId) -> Option<Angle> {
    let edges = wire.wireframe.incident(vertex);
    let out: Vec<_> =
        edges.iter().map(|&edge| wire.wireframe.direction(edge, vertex)).collect::<Option<_>>()?;
    let pairs =
        out.iter().enumerate().flat_map(|(k, one)| out[k + 1..].iter().map(move |other| (one, other)));
    pairs.map(|(one, other)| Angle::computed((-one).angle(other))).min()
}
