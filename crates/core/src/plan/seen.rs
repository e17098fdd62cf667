//! What the checks see of a wire.

use super::{Machine, WirePlan};
use crate::checks::{Diagnostic, WireStages, check_wire};
use crate::wireframe::Wireframe;

/// What checks see of a plan, which does not say why a stage was left out.
pub(super) fn stages_of<'a>(
    wireframe: &'a Wireframe,
    machine: &'a Machine,
    plan: &'a WirePlan,
) -> WireStages<'a> {
    WireStages {
        wireframe,
        component: &plan.component,
        doubled: &plan.doubled,
        odd_allowed: 0,
        proposal: None,
        forced: &[],
        passed_again: &[],
        route: plan.route.as_ref(),
        nominal: plan.nominal.as_ref(),
        scheduled: plan.scheduled.as_ref(),
        rotation: None,
        compensated: plan.compensated.as_ref(),
        unbendable: &[],
        searched: plan.searched.is_some(),
        sag: plan.sag.map(|sag| sag.largest),
        contacts: plan.contacts.as_deref().unwrap_or_default(),
        bodies: &machine.bodies.all,
        compensation: &machine.compensation,
        diameter: machine.wire.diameter,
        bend_radius: machine.bend_radius,
        straight: machine.straight,
        scatter: machine.scatter.as_ref(),
        limits: &machine.limits,
    }
}

/// Everything worth saying about a wire whose stages are given: its walk stays as it is, and no other one is proposed. Most severe
/// first.
#[must_use]
pub fn check_given(wireframe: &Wireframe, machine: &Machine, plan: &WirePlan) -> Vec<Diagnostic> {
    let mut found =
        check_wire(&WireStages { odd_allowed: usize::MAX, ..stages_of(wireframe, machine, plan) });
    found.sort_by_key(|diagnostic| diagnostic.severity);
    found
}
