//! Whether a wire, or as many as there may be, can run through every edge once.

use super::{Diagnostic, Fact, Location, Remedy, Severity, WireStages};

pub(super) fn check(wire: &WireStages, found: &mut Vec<Diagnostic>) {
    let odd = wire.wireframe.odd_vertices(wire.component, wire.doubled);
    let allowed = wire.odd_allowed;
    if odd.len() <= allowed {
        return;
    }
    found.push(Diagnostic {
        severity: Severity::Error,
        location: Location::at_vertices(odd.iter().copied()),
        fact: Fact::NoEulerPath { odd: odd.len(), allowed },
        remedies: match wire.proposal {
            Some(doubling) => vec![Remedy::double(doubling, wire.wireframe, wire.component)],
            None => vec![Remedy::FindDoubling, Remedy::ReduceOddVertices],
        },
    });
}
