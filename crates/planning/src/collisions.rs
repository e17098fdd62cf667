//! Where the wires of a plan meet their machine or themselves, looked for after all else is planned: that takes the longest, and
//! whoever asks for it may stop it.

use std::time::{Duration, Instant};

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_core::checks::Diagnostic;
use wirebend_core::clearance::{Body, FirstContact, Obstacle};
use wirebend_core::motion::moments;
use wirebend_core::plan::{WirePlan, clearance, keep_contacts};

use crate::contacts::{PATIENCE, first_contacts, not_searched};
use crate::machine::Setup;
use crate::plan::Planned;
use crate::playback::machine_steps;
use crate::report::{DiagnosticReport, NoteReport};

/// A first contact of a wire with one thing that it meets, as it is played.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ContactReport {
    /// The wire, from 0, of those that have a program.
    pub wire: usize,
    /// The step in which it happens, from 0.
    pub step: usize,
    /// The part of the step's time that has passed by then, from 0 to 1.
    pub at: f64,
    /// The step, from 0, that has made the part of the wire that is met.
    pub leg: usize,
    /// The body of the machine that it meets, by its place in the profile from 0; null: the wire that is still to be bent.
    pub body: Option<usize>,
    /// How deep they are in each other at the worst of that step, mm; below zero: they only come so near.
    pub depth_mm: f64,
    /// In how many later steps they meet again in this way.
    pub later: usize,
    /// Whether where it is depends on dimensions that were not measured.
    pub estimated: bool,
    /// What the checks say of it.
    pub finding: DiagnosticReport,
}

/// Where the wires of a design meet the machine or themselves while they are bent.
#[derive(Debug, Clone, PartialEq, Default, Serialize, JsonSchema)]
pub struct Collisions {
    /// Whether every wire was looked at to its end: not where it was stopped, and not without a route.
    pub checked: bool,
    /// Whether somebody has stopped it, or asked for a later one.
    pub stopped: bool,
    /// Of each wire in the order of its steps.
    pub contacts: Vec<ContactReport>,
    /// How many bodies the machine's profile has.
    pub bodies: usize,
    /// How many of them have dimensions that were not measured.
    pub estimates: usize,
}

impl Planned {
    /// Looks where the wires meet the machine or themselves, and adds what the checks say of it to each. `goes_on` is asked again
    /// and again, with how many of how many steps are done.
    pub fn find_collisions(&mut self, goes_on: &mut dyn FnMut(usize, usize) -> bool) -> Collisions {
        let wireframe = &self.opened.document.wireframe;
        let of = self.wires.iter().filter_map(steps_of).sum();
        let mut all = Collisions::of(&self.setup);
        let (mut wire, mut done) = (0, 0);
        for plan in &mut self.wires {
            let Some(steps) = steps_of(plan) else { continue };
            let machine = &self.setup.model;
            let searched = clearance(wireframe, machine, plan)
                .map(|clearance| first_contacts(&clearance, |step| goes_on(done + step, of)));
            let stopped = searched.as_ref().is_some_and(|searched| !searched.whole);
            let contacts = searched.map(|searched| searched.contacts);
            let findings = keep_contacts(wireframe, machine, plan, contacts);
            all.contacts.extend(contacts_of(plan, wire, &self.setup, &findings));
            plan.diagnostics.extend(findings);
            plan.diagnostics.sort_by_key(|diagnostic| diagnostic.severity);
            if stopped {
                // What was found counts; that there is no more is not known.
                plan.contacts = None;
                return Collisions { stopped: true, ..Collisions::of(&self.setup) };
            }
            (wire, done) = (wire + 1, done + steps);
        }
        all.checked = self.collisions_checked();
        all
    }

    /// The same for as long as a person waits for it. A note says so where that was not enough.
    pub fn find_collisions_in_time(&mut self) -> Option<NoteReport> {
        self.find_collisions_within(PATIENCE)
    }

    fn find_collisions_within(&mut self, patience: Duration) -> Option<NoteReport> {
        let until = Instant::now() + patience;
        let mut reached = (0, 0);
        let found = self.find_collisions(&mut |done, of| {
            reached = (done, of);
            Instant::now() < until
        });
        found.stopped.then(|| not_searched(reached.0, reached.1))
    }
}

impl Collisions {
    /// None yet, on a machine.
    fn of(setup: &Setup) -> Self {
        let bodies = &setup.model.bodies.all;
        let estimates = bodies.iter().filter(|body| !body.measured).count();
        Self { bodies: bodies.len(), estimates, ..Self::default() }
    }
}

/// How many steps a wire has, where it has a program.
fn steps_of(plan: &WirePlan) -> Option<usize> {
    plan.scheduled.as_ref().map(|program| program.steps.len())
}

fn contacts_of(plan: &WirePlan, wire: usize, setup: &Setup, findings: &[Diagnostic]) -> Vec<ContactReport> {
    let moments = machine_steps(plan, &setup.model.time).map(|steps| moments(&steps)).unwrap_or_default();
    let steps = plan.scheduled.as_ref().map(|program| program.steps.as_slice()).unwrap_or_default();
    let report = |(&FirstContact { contact, depth, later, .. }, finding): (&FirstContact, &Diagnostic)| {
        let body = match contact.obstacle {
            Obstacle::Body(index) => Some(index),
            Obstacle::Stock => None,
        };
        let bend = steps.get(contact.step).map(|step| step.bend).unwrap_or_default();
        let known: Option<&Body> = body.and_then(|body| setup.model.bodies.all.get(body));
        ContactReport {
            wire,
            step: contact.step,
            at: moments.get(contact.step).map_or(0.0, |moments| contact.time_in(moments, bend)),
            leg: contact.leg,
            body,
            depth_mm: depth.mm(),
            later,
            estimated: known.is_some_and(|body| !body.measured),
            finding: DiagnosticReport::from(finding),
        }
    };
    plan.contacts.iter().flatten().zip(findings).map(report).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::DesignInput;
    use crate::{Installation, NoProgress, PlanChoices};

    /// Whoever waits in vain would take a program that was not looked at for one that is clear.
    #[test]
    fn a_search_that_takes_too_long_is_said_to_have_no_end() {
        let app = Installation::new(&[]).unwrap();
        let example = format!("{}/../../examples/u-sample.obj", env!("CARGO_MANIFEST_DIR"));
        let opened = DesignInput::file(example.into()).open(&NoProgress).unwrap();
        let choices = PlanChoices { machine: Some("wirebend-kit".into()), ..PlanChoices::default() };
        let mut planned = app.plan_design(opened, &choices, &NoProgress).unwrap();
        let steps = steps_of(&planned.wires[0]).unwrap();
        let note = planned.find_collisions_within(Duration::ZERO).unwrap();
        assert_eq!(note.message, format!("collisions not fully searched: 0 of {steps} steps in 10 s"));
        assert!(!planned.collisions_checked());
        assert_eq!(planned.find_collisions_within(Duration::from_mins(1)), None);
        assert!(planned.collisions_checked());
    }

    /// A wire that is known to collide is refused, whatever the rest of it would have shown.
    #[test]
    fn what_was_found_before_the_search_was_stopped_counts() {
        let app = Installation::new(&[]).unwrap();
        let example = format!("{}/../../examples/truss-1.obj", env!("CARGO_MANIFEST_DIR"));
        let opened = DesignInput::file(example.into()).open(&NoProgress).unwrap();
        let choices =
            PlanChoices { machine: Some("wirebend-kit".into()), double: true, ..PlanChoices::default() };
        let mut planned = app.plan_design(opened, &choices, &NoProgress).unwrap();
        assert!(planned.wires[0].is_feasible());
        let found = planned.find_collisions(&mut |done, of| done < of / 2);
        assert!(found.stopped && !found.checked && !planned.collisions_checked());
        assert!(!planned.wires[0].is_feasible(), "it goes into the wire that is still to be bent");
    }
}
