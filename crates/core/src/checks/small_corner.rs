//! Corners that are smaller than the bend axis resolves: the wire goes straight on there.

use super::{Diagnostic, Fact, Location, Remedy, Severity, WireStages};
use crate::units::Angle;

/// Below this a corner is the rounding of a file with three decimals, not a design; degrees.
const ROUNDING_DEG: f64 = 0.005;

pub(super) fn check(wire: &WireStages, found: &mut Vec<Diagnostic>) {
    let (Some(route), Some(nominal)) = (wire.route, wire.nominal) else { return };
    let within = nominal.spans.iter().flat_map(|span| span.start + 1..span.end);
    for (before, after) in
        within.filter_map(|k| Some((route.traversals.get(k - 1)?, route.traversals.get(k)?)))
    {
        let along = |t: &crate::route::Traversal| wire.wireframe.direction(t.edge, t.from);
        let (Some(one), Some(next)) = (along(before), along(after)) else { continue };
        let corner = Angle::computed(one.angle(&next));
        if corner.deg() <= ROUNDING_DEG {
            continue;
        }
        found.push(Diagnostic {
            severity: Severity::Warning,
            location: Location {
                vertices: vec![after.from],
                edges: vec![before.edge, after.edge],
                step: None,
            },
            fact: Fact::CornerNotMade { vertex: after.from, corner, straight: wire.straight },
            remedies: vec![Remedy::Straighten, Remedy::EnlargeBend],
        });
    }
}
