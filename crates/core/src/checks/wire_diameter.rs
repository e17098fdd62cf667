//! Whether the wire fits the machine at all.

use super::{Diagnostic, Fact, Location, Remedy, Severity, WireStages};

pub(super) fn check(wire: &WireStages, found: &mut Vec<Diagnostic>) {
    let (min, max) = (&wire.limits.min_diameter, &wire.limits.max_diameter);
    let limit = if wire.diameter < min.value {
        min
    } else if wire.diameter > max.value {
        max
    } else {
        return;
    };
    found.push(Diagnostic {
        severity: Severity::Error,
        location: Location::default(),
        fact: Fact::WireDoesNotFit {
            diameter: wire.diameter,
            range: [min.value, max.value],
            source: limit.source.clone(),
        },
        remedies: vec![Remedy::ChooseMaterial, Remedy::ChooseMachine],
    });
}
