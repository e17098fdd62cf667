//! Vertices through which no wire can be bent, whichever two edges it takes: known before there is a route.

use super::bend_angle::reach_source;
use super::{Code, Diagnostic, Limit, Place, Quantity, ROUNDING, Severity, Wire};
use crate::compensate::BendError;
use crate::units::{Angle, digits_apart};
use crate::wireframe::VertexId;

pub(super) fn check(wire: &Wire, found: &mut Vec<Diagnostic>) {
    // Of a route each bend is judged, and there are no others.
    if wire.route.is_some() {
        return;
    }
    let limits = [&wire.limits.least_bend, &wire.limits.largest_bend];
    let [least, largest] = limits;
    let limit = if least.value.abs() > largest.value { least } else { largest };
    for &vertex in &wire.component.vertices {
        let Some(bend) = gentlest(wire, vertex) else { continue };
        let stated = Limit { value: Quantity::Angle(limit.value), source: limit.source.clone() };
        let (code, most, limit) = if bend.deg() > limit.value.abs().deg() + ROUNDING {
            (Code::BendTooSharp, limit.value.abs(), stated)
        } else if let Some(most) = reach(wire, bend) {
            let source = reach_source(wire, bend);
            (Code::BendOutOfReach, most, Limit { value: Quantity::Angle(most), source })
        } else {
            continue;
        };
        // Of a closed wire the two ends may lie at a vertex of two edges: there it is not bent.
        let passes = !wire.closed || wire.wireframe.incident(vertex).len() > 2;
        let digits = digits_apart(bend.deg(), most.deg(), 1);
        found.push(Diagnostic {
            code,
            severity: if passes { Severity::Error } else { Severity::Warning },
            place: Place::at_vertices([vertex]),
            measured: Some(Quantity::Angle(bend)),
            limit: Some(limit),
            message: format!(
                "the gentlest bend at vertex {vertex} is {bend:.digits$}, more than the machine makes ({most:.digits$})"
            ),
            help: if passes {
                "open the angle between two of its edges"
            } else {
                "open the angle between its edges, or start the wire there"
            }
            .to_owned(),
        });
    }
}

/// The largest bend that the machine can press and keep with this wire, where the bend is beyond it to both sides.
fn reach(wire: &Wire, bend: Angle) -> Option<Angle> {
    let most = |side: Angle| match wire.compensation.bend.command(side) {
        Err(BendError::OutOfReach { largest, .. }) => Some(largest),
        _ => None,
    };
    Some(most(bend)?.max(most(-bend)?))
}

/// The least bend with which a wire passes through a vertex; none where it only ends, or where an edge has no length.
fn gentlest(wire: &Wire, vertex: VertexId) -> Option<Angle> {
    let edges = wire.wireframe.incident(vertex);
    let out: Vec<_> =
        edges.iter().map(|&edge| wire.wireframe.direction(edge, vertex)).collect::<Option<_>>()?;
    let pairs =
        out.iter().enumerate().flat_map(|(k, one)| out[k + 1..].iter().map(move |other| (one, other)));
    pairs.map(|(one, other)| Angle::computed((-one).angle(other))).min()
}
