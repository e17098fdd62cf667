//! Where the wire of a plan meets the machine.

use super::seen::stages_of;
use super::{Machine, PartSag, PlanOptions, WirePlan};
use crate::bend::{Frame, Step};
use crate::checks::{Diagnostic, check_contacts};
use crate::clearance::{Clearance, FirstContact, Passage, StockWire, max_joint_sag, passages};
use crate::compensate::{ToldStep, approaches};
use crate::route::Doubling;
use crate::sag::max_sag;
use crate::simulate::scheduled_start;
use crate::units::Length;
use crate::wireframe::{Component, Wireframe};

/// How contacts are looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ContactOptions {
    /// How far things have to stay from each other.
    pub margin: Length,
    /// Whether the part already bent hangs as its own weight makes it; otherwise it keeps the shape to which it is bent.
    pub sag: bool,
}

impl ContactOptions {
    pub(super) fn of(options: &PlanOptions) -> Self {
        Self { margin: options.clearance, sag: options.sag }
    }
}

/// How far the part already bent of a plan sags, once it has been scheduled.
pub(super) fn sag(wireframe: &Wireframe, machine: &Machine, plan: &WirePlan) -> Option<PartSag> {
    let (nominal, scheduled) = (plan.nominal.as_ref()?, plan.scheduled.as_ref()?);
    let passages = passages(wireframe, &plan.route.as_ref()?.traversals, &nominal.spans);
    let start = scheduled_start(plan.start, &scheduled.steps);
    let largest = max_sag(start, &scheduled.steps, &machine.wire)?;
    Some(PartSag { largest, joint: max_joint_sag((start, &scheduled.steps), &passages, &machine.wire) })
}

/// The first contact with each thing that the wire meets or comes nearer to than a margin, once it has been scheduled, in the
/// order of its steps.
pub(super) fn find(wireframe: &Wireframe, machine: &Machine, plan: &WirePlan) -> Option<Vec<FirstContact>> {
    Some(clearance(wireframe, machine, plan)?.first_contacts())
}

/// Keeps in a plan where its wire meets the machine or itself, which was looked for after all else: `None` where that is not
/// known. Gives what the checks say of each contact, in their order.
pub fn keep_contacts(
    wireframe: &Wireframe,
    machine: &Machine,
    plan: &mut WirePlan,
    contacts: Option<Vec<FirstContact>>,
) -> Vec<Diagnostic> {
    plan.contacts = contacts;
    check_contacts(&stages_of(wireframe, machine, plan))
}

/// The wire of a plan in its machine, once it has been scheduled.
#[must_use]
pub fn clearance<'a>(wireframe: &Wireframe, machine: &'a Machine, plan: &WirePlan) -> Option<Clearance<'a>> {
    let (nominal, scheduled) = (plan.nominal.as_ref()?, plan.scheduled.as_ref()?);
    let route = plan.route.as_ref()?;
    let passages = passages(wireframe, &route.traversals, &nominal.spans);
    let told: Option<Vec<ToldStep>> = plan.compensated.as_ref().map(|program| program.told().collect());
    let start = scheduled_start(plan.start, &scheduled.steps);
    Some(in_machine(machine, (start, &scheduled.steps), told.as_deref(), passages, &plan.contact_options))
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
    /// How contacts are looked for.
    pub options: ContactOptions,
}

impl ScheduledWire {
    /// The wire in its machine.
    #[must_use]
    pub fn clearance<'a>(&self, machine: &'a Machine) -> Clearance<'a> {
        in_machine(machine, (self.start, &self.steps), Some(&self.told), self.passages.clone(), &self.options)
    }

    /// What the checks say of its contacts, in their order; without edges, which only a plan has.
    #[must_use]
    pub fn check(&self, machine: &Machine, contacts: Vec<FirstContact>) -> Vec<Diagnostic> {
        let proposal = Doubling { edges: Vec::new(), added: Length::ZERO };
        let mut plan = WirePlan::new(Component::default(), Vec::new(), proposal, None);
        plan.contact_options = self.options;
        keep_contacts(&Wireframe::new(), machine, &mut plan, Some(contacts))
    }
}

fn in_machine<'a>(
    machine: &'a Machine,
    wire: (Frame, &[Step]),
    told: Option<&[ToldStep]>,
    passages: Vec<Vec<(Passage, Length)>>,
    options: &ContactOptions,
) -> Clearance<'a> {
    let stock = stock_wire(machine, options);
    let approaches = told.map(|told| approaches(told, &machine.compensation)).unwrap_or_default();
    let axes: Option<Vec<Step>> = told.map(|told| told.iter().map(|told| told.step).collect());
    Clearance::new(wire, axes.as_deref(), passages, stock, &machine.bodies, &machine.compensation.bend)
        .with_approaches(approaches)
}

/// The wire as it runs through the machine.
pub(super) fn stock_wire(machine: &Machine, options: &ContactOptions) -> StockWire {
    StockWire {
        diameter: machine.wire.diameter,
        bend_radius: machine.bend_radius,
        tail: machine.limits.tail.value,
        margin: options.margin,
        hangs: options.sag.then_some(machine.wire),
    }
}
