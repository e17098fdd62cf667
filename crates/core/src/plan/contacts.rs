//! Where the wire of a plan meets the machine.

use super::seen::stages_of;
use super::{Machine, WirePlan};
use crate::bend::{Frame, Step};
use crate::checks::{Diagnostic, WireStages, check_contacts};
use crate::clearance::{Clearance, FirstContact, Passage, StockWire, passages};
use crate::compensate::{ToldStep, approaches};
use crate::route::Doubling;
use crate::simulate::scheduled_start;
use crate::units::Length;
use crate::wireframe::{Component, Wireframe};

/// The first contact with each thing that the wire meets or comes nearer to than a margin, once it has been scheduled, in the
/// order of its steps.
pub(super) fn find(
    wireframe: &Wireframe,
    machine: &Machine,
    plan: &WirePlan,
    margin: Length,
) -> Option<Vec<FirstContact>> {
    Some(clearance(wireframe, machine, plan, margin)?.first_contacts())
}

/// Keeps in a plan where its wire meets the machine or itself, which was looked for after all else: `None` where that is not
/// known. `margin`: how far things have to stay from each other. Gives what the checks say of each contact, in their order.
pub fn keep_contacts(
    wireframe: &Wireframe,
    machine: &Machine,
    plan: &mut WirePlan,
    contacts: Option<Vec<FirstContact>>,
    margin: Length,
) -> Vec<Diagnostic> {
    plan.contacts = contacts;
    check_contacts(&WireStages { margin, ..stages_of(wireframe, machine, plan) })
}

/// The wire of a plan in its machine, once it has been scheduled. `margin`: how far things have to stay from each other.
#[must_use]
pub fn clearance<'a>(
    wireframe: &Wireframe,
    machine: &'a Machine,
    plan: &WirePlan,
    margin: Length,
) -> Option<Clearance<'a>> {
    let (nominal, scheduled) = (plan.nominal.as_ref()?, plan.scheduled.as_ref()?);
    let route = plan.route.as_ref()?;
    let passages = passages(wireframe, &route.traversals, &nominal.spans);
    let told: Option<Vec<ToldStep>> = plan.compensated.as_ref().map(|program| program.told().collect());
    let start = scheduled_start(plan.start, &scheduled.steps);
    Some(in_machine(machine, (start, &scheduled.steps), told.as_deref(), passages, margin))
}

/// A wire that was planned before, such as that of a job.
#[derive(Debug, Clone)]
pub struct ScheduledWire {
    /// Where its steps begin.
    pub start: Frame,
    /// As scheduled, from corner to corner.
    pub steps: Vec<Step>,
    /// As compensated: where the bend axis goes in each.
    pub told: Vec<ToldStep>,
    /// The edges of each step, with their lengths.
    pub passages: Vec<Vec<(Passage, Length)>>,
}

impl ScheduledWire {
    /// The wire in its machine. `margin`: how far things have to stay from each other.
    #[must_use]
    pub fn clearance<'a>(&self, machine: &'a Machine, margin: Length) -> Clearance<'a> {
        in_machine(machine, (self.start, &self.steps), Some(&self.told), self.passages.clone(), margin)
    }

    /// What the checks say of its contacts, in their order; without edges, which only a plan has.
    #[must_use]
    pub fn check(&self, machine: &Machine, contacts: Vec<FirstContact>, margin: Length) -> Vec<Diagnostic> {
        let proposal = Doubling { edges: Vec::new(), added: Length::ZERO };
        let mut plan = WirePlan::new(Component::default(), Vec::new(), proposal, None);
        keep_contacts(&Wireframe::new(), machine, &mut plan, Some(contacts), margin)
    }
}

fn in_machine<'a>(
    machine: &'a Machine,
    wire: (Frame, &[Step]),
    told: Option<&[ToldStep]>,
    passages: Vec<Vec<(Passage, Length)>>,
    margin: Length,
) -> Clearance<'a> {
    let stock = stock_wire(machine, margin);
    let approaches = told.map(|told| approaches(told, &machine.compensation)).unwrap_or_default();
    let axes: Option<Vec<Step>> = told.map(|told| told.iter().map(|told| told.step).collect());
    Clearance::new(wire, axes.as_deref(), passages, stock, &machine.bodies, &machine.compensation.bend)
        .with_approaches(approaches)
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
