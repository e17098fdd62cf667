//! Whether the bend axis is strong enough for the wire, and the wire for the radius that it is bent to.

use super::{Diagnostic, Fact, Location, Remedy, Severity, WireStages};
use crate::sag::Sag;

/// So many times the moment that bends the wire a bend axis should have, for friction and for wire that is stronger than its figures.
pub const TORQUE_MARGIN: f64 = 1.5;
/// Of the same radius, written in another way, nothing is said.
const SAME: f64 = 1e-9;

pub(super) fn torque(wire: &WireStages, found: &mut Vec<Diagnostic>) {
    let Some(torque) = &wire.limits.bend_torque else { return };
    let needed_n_m = torque.needed_n_m;
    if torque.available_n_m.value < TORQUE_MARGIN * needed_n_m {
        let available_n_m = torque.available_n_m.clone();
        found.push(warning(Fact::BendTorqueLow { needed_n_m, available_n_m, margin: TORQUE_MARGIN }));
    }
}

pub(super) fn radius(wire: &WireStages, found: &mut Vec<Diagnostic>) {
    let Some(bend) = &wire.limits.bend_radius else { return };
    let (inner, least) = (bend.inner.mm(), bend.least().mm());
    // Nor of one that may well be as large as it has to be.
    if inner < least * (1.0 - SAME) && least - inner > bend.inner_within.mm() {
        found.push(warning(Fact::BendRadiusSmall(bend.clone())));
    }
}

pub(super) fn sag(wire: &WireStages, found: &mut Vec<Diagnostic>) {
    let Some(sag) = wire.sag.filter(Sag::is_indicated) else { return };
    found.push(Diagnostic {
        severity: Severity::Warning,
        location: wire.location_of_step(sag.step),
        fact: Fact::PartSags(sag),
        remedies: vec![Remedy::HoldUp, Remedy::ChooseMaterial],
    });
}

/// Of the whole wire on this machine.
fn warning(fact: Fact) -> Diagnostic {
    Diagnostic {
        severity: Severity::Warning,
        location: Location::default(),
        fact,
        remedies: vec![Remedy::ChooseMaterial, Remedy::ChooseMachine],
    }
}
