//! Where the wire of a plan meets the machine.

use super::{Machine, WirePlan};
use crate::clearance::{Clearance, FirstContact, Passage, StockWire};
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
    let passages = nominal.spans.iter().map(|span| {
        let along = route.traversals.get(span.clone()).unwrap_or_default();
        let passage = |edge, from, to| (Passage { edge, from, to }, wireframe.edge_length(edge));
        along.iter().map(|one| passage(one.edge, one.from, one.to)).collect()
    });
    let wire = StockWire {
        diameter: machine.wire.diameter,
        bend_radius: machine.bend_radius,
        tail: machine.limits.tail.value,
        margin,
    };
    let steps = &scheduled.steps;
    let clearance = Clearance::new(
        (scheduled_start(plan.start, steps), steps),
        plan.compensated.as_ref().map(CompensatedProgram::steps),
        passages.collect(),
        wire,
        &machine.bodies,
        &machine.compensation.bend,
    );
    Some(clearance.first_contacts())
}
