//! Whether the bend axis is strong enough for the wire.

use super::{Diagnostic, Fact, Location, Remedy, Severity, WireStages};

/// So many times the moment that bends the wire a bend axis should have, for friction and for wire that is stronger than its figures.
const MARGIN: f64 = 1.5;

pub(super) fn check(wire: &WireStages, found: &mut Vec<Diagnostic>) {
    let Some(torque) = &wire.limits.bend_torque else { return };
    let needed_n_m = torque.needed_n_m;
    if torque.available_n_m.value >= MARGIN * needed_n_m {
        return;
    }
    found.push(Diagnostic {
        severity: Severity::Warning,
        location: Location::default(),
        fact: Fact::BendTorqueLow { needed_n_m, available_n_m: torque.available_n_m.clone(), margin: MARGIN },
        remedies: vec![Remedy::ChooseMaterial, Remedy::ChooseMachine],
    });
}
