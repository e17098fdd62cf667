//! Whether the wire takes the radius that the machine bends it round.

use super::{Diagnostic, Fact, Location, Remedy, Severity, WireStages};

/// Of the same radius, written in another way, nothing is said.
const SAME: f64 = 1e-9;

pub(super) fn check(wire: &WireStages, found: &mut Vec<Diagnostic>) {
    let Some(bend) = &wire.limits.bend_radius else { return };
    if bend.inner.mm() >= bend.least().mm() * (1.0 - SAME) {
        return;
    }
    found.push(Diagnostic {
        severity: Severity::Warning,
        location: Location::default(),
        fact: Fact::BendRadiusSmall(bend.clone()),
        remedies: vec![Remedy::ChooseMaterial, Remedy::ChooseMachine],
    });
}
