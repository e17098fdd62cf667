//! Designed edges that are too short for the machine's head to fit between two bends.

use super::{Diagnostic, Fact, Location, ROUNDING, Remedy, Severity, WireStages, is_near};
use crate::units::Length;

pub(super) fn check(wire: &WireStages, found: &mut Vec<Diagnostic>) {
    // With a program the straight parts are known, of which an edge may be a piece; until then each
    // edge is judged on its own.
    if let Some(nominal) = wire.nominal {
        for (index, step) in nominal.steps.iter().enumerate() {
            judge(wire, wire.location_of_step(index), step.feed, found);
        }
    } else {
        for &edge in &wire.component.edges {
            judge(wire, Location::at_edges([edge]), wire.wireframe.edge_length(edge), found);
        }
    }
}

fn judge(wire: &WireStages, location: Location, length: Length, found: &mut Vec<Diagnostic>) {
    let limit = wire.limits.min_edge.clone();
    let room = (length - limit.value).mm();
    let (severity, fact, remedies) = if room < -ROUNDING {
        let by = Some(Length::computed(-room));
        let remedies = vec![Remedy::LengthenEdge { by }, Remedy::ScaleUp];
        (Severity::Error, Fact::EdgeTooShort { length, limit }, remedies)
    } else if is_near(room.max(0.0), limit.value.mm()) {
        let remedies = vec![Remedy::Leave, Remedy::LengthenEdge { by: None }];
        (Severity::Warning, Fact::EdgeNearLimit { length, limit }, remedies)
    } else {
        return;
    };
    found.push(Diagnostic { severity, location, fact, remedies });
}
