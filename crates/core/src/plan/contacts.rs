//! Where the wire of a plan meets the machine.

use super::stages::stages_of;
use super::{Machine, WirePlan};
use crate::checks::{Diagnostic, check_contacts};
use crate::clearance::{Clearance, FirstContact, Passage, StockWire};
use crate::compensate::CompensatedProgram;
use crate::simulate::scheduled_start;
use crate::units::Length;
use crate::wireframe::Wireframe;

/// The first contact with each thing that the wire meets, once it has been scheduled, in the order of its steps.
pub(super) fn find(wireframe: &Wireframe, machine: &Machine, plan: &WirePlan) -> Option<Vec<FirstContact>> {
    Some(clearance(wireframe, machine, plan)?.first_contacts())
}

/// Looks where a wire that was planned without it meets the machine or itself, and keeps that in the plan. Gives what the checks
/// say of each contact, in their order. `goes_on` is asked before each step, with its index: where it does not, or where the
/// wire has not been scheduled, the plan has no contacts.
pub fn find_contacts(
    wireframe: &Wireframe,
    machine: &Machine,
    plan: &mut WirePlan,
    goes_on: impl FnMut(usize) -> bool,
) -> Vec<Diagnostic> {
    let clearance = clearance(wireframe, machine, plan);
    plan.contacts = clearance.and_then(|clearance| clearance.first_contacts_while(goes_on));
    check_contacts(&stages_of(wireframe, machine, plan))
}

/// The wire of a plan in its machine, once it has been scheduled.
fn clearance<'a>(wireframe: &Wireframe, machine: &'a Machine, plan: &WirePlan) -> Option<Clearance<'a>> {
    let (nominal, scheduled) = (plan.nominal.as_ref()?, plan.scheduled.as_ref()?);
    let route = plan.route.as_ref()?;
    let passages = nominal.spans.iter().map(|span| {
        let along = route.traversals.get(span.clone()).unwrap_or_default();
        let passage = |edge, from, to| (Passage { edge, from, to }, wireframe.edge_length(edge));
        along.iter().map(|one| passage(one.edge, one.from, one.to)).collect()
    });
    let wire = StockWire {
        diameter: machine.wire.diameter,
        bend_radius: machine.bend_radius,
        tail: machine.limits.tail.value,
        margin: Length::ZERO,
    };
    let steps = &scheduled.steps;
    Some(Clearance::new(
        (scheduled_start(plan.start, steps), steps),
        plan.compensated.as_ref().map(CompensatedProgram::steps),
        passages.collect(),
        wire,
        &machine.bodies,
        &machine.compensation.bend,
    ))
}
