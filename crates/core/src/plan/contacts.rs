//! Where the wire of a plan meets the machine.

use super::{Machine, WirePlan};
use crate::clearance::{Clearance, FirstContact, StockWire, passages};
use crate::compensate::CompensatedProgram;
use crate::simulate::scheduled_start;
use crate::units::Length;
use crate::wireframe::Wireframe;

/// The first contact with each thing that the wire meets or comes nearer to than a margin, once it has been scheduled, in the
/// order of its steps.
pub(super) fn find(
    wireframe: &Wireframe,
    machine: &Machine,
    plan: &WirePlan,
    margin: Length,
) -> Option<Vec<FirstContact>> {
    let (nominal, scheduled) = (plan.nominal.as_ref()?, plan.scheduled.as_ref()?);
    let route = plan.route.as_ref()?;
    let passages = passages(wireframe, &route.traversals, &nominal.spans);
    let steps = &scheduled.steps;
    let clearance = Clearance::new(
        (scheduled_start(plan.start, steps), steps),
        plan.compensated.as_ref().map(CompensatedProgram::steps),
        passages,
        stock_wire(machine, margin),
        &machine.bodies,
        &machine.compensation.bend,
    );
    Some(clearance.first_contacts())
}

/// The wire as it runs through the machine.
pub(super) fn stock_wire(machine: &Machine, margin: Length) -> StockWire {
    StockWire {
        diameter: machine.wire.diameter,
        bend_radius: machine.bend_radius,
        tail: machine.limits.tail.value,
        margin,
    }
}
