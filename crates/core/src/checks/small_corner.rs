//! Corners that are gentler than the bend axis resolves: the wire goes straight on there.

use super::{Code, Diagnostic, Limit, Place, Quantity, Severity, Wire};
use crate::units::Angle;

/// Below this a corner is the rounding of a file with three decimals, not a design; degrees.
const ROUNDING_DEG: f64 = 0.005;

pub(super) fn check(wire: &Wire, found: &mut Vec<Diagnostic>) {
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
            code: Code::CornerNotMade,
            severity: Severity::Warning,
            place: Place { vertices: vec![after.from], edges: vec![before.edge, after.edge], step: None },
            measured: Some(Quantity::Angle(corner)),
            limit: Some(Limit {
                value: Quantity::Angle(wire.straight),
                source: "half of what the bend axis resolves".to_owned(),
            }),
            message: format!(
                "the corner at vertex {} is {corner:.3}, less than the bend axis can make: the wire goes straight on",
                after.from
            ),
            help: "make the corner straight or sharper; what follows is bent from where the wire really points"
                .to_owned(),
        });
    }
}
