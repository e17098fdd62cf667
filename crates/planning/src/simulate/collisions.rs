//! Where wires that come out with errors hit the machine or themselves.

use std::collections::BTreeMap;

use nalgebra::Point3;
use schemars::JsonSchema;
use serde::Serialize;
use wirebend_core::bend::Step;
use wirebend_core::checks::Diagnostic;
use wirebend_core::clearance::{FirstContact, Obstacle};
use wirebend_core::plan::ScheduledWire;
use wirebend_core::simulate::{ImperfectWire, steps_of_corners};
use wirebend_core::units::Length;
use wirebend_files::document::JobWire;

use crate::contacts::first_contacts;
use crate::job::scheduled;
use crate::machine::Setup;
use crate::report::DiagnosticReport;

/// Where the simulated wires of one wire of a job hit the machine or themselves while they are bent.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct SimulatedCollisions {
    /// How many wires were looked at: one that the simulated machine or, without one, the formulas bend without errors, else one for
    /// each run.
    pub wires: u32,
    /// How many of them hit something. What only comes nearer than the clearance does not count.
    pub colliding: u32,
    /// `colliding` as a share of `wires`, 0 to 1.
    pub share: f64,
    /// What the checks say of each thing that is hit or nearer than the clearance, of the wire that goes deepest into it; errors first.
    pub diagnostics: Vec<SimulatedContact>,
}

/// What is said of one thing that simulated wires hit.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct SimulatedContact {
    #[serde(flatten)]
    pub finding: DiagnosticReport,
    /// How many of the wires hit it, or come nearer to it than the clearance.
    pub wires: u32,
    /// Which of the wires the finding is of, from 0.
    pub run: u32,
}

/// Looks at one simulated wire after the other.
pub(super) struct CollisionSearch<'a> {
    setup: &'a Setup,
    /// As it was planned.
    planned: ScheduledWire,
    wires: u32,
    colliding: u32,
    found: BTreeMap<Obstacle, Found>,
}

struct Found {
    wires: u32,
    run: u32,
    deepest: FirstContact,
    /// The wire that goes deepest.
    finding: Diagnostic,
}

impl<'a> CollisionSearch<'a> {
    /// For the wire of a job; otherwise why that cannot be. `margin`: how far things have to stay from each other, where that is not as the
    /// job says.
    pub fn new(wire: &JobWire, setup: &'a Setup, margin: Option<Length>) -> Result<Self, String> {
        let mut planned = scheduled(wire, setup)?;
        planned.options.margin = margin.unwrap_or(planned.options.margin);
        Ok(Self { setup, planned, wires: 0, colliding: 0, found: BTreeMap::new() })
    }

    /// A wire that came out with errors.
    pub fn imperfect(&mut self, wire: &ImperfectWire) {
        self.planned.steps.clone_from(&wire.steps);
        self.planned.told.clone_from(&wire.told);
        self.look();
    }

    /// A wire by its ends and corners, mm, laid beside the design; false where they are not those of the planned steps. The bend
    /// axis goes as it was told.
    pub fn corners(&mut self, corners: &[Point3<f64>]) -> bool {
        let Some((start, steps)) = steps_of_corners(corners, &self.planned.start, &self.planned.steps) else {
            return false;
        };
        let planned: (_, Vec<Step>) = (self.planned.start, std::mem::replace(&mut self.planned.steps, steps));
        self.planned.start = start;
        self.look();
        (self.planned.start, self.planned.steps) = planned;
        true
    }

    fn look(&mut self) {
        let machine = &self.setup.model;
        let contacts = first_contacts(&self.planned.clearance(machine), |_| true).contacts;
        let findings = self.planned.check(machine, contacts.clone());
        let run = self.wires;
        self.wires += 1;
        self.colliding += u32::from(contacts.iter().any(FirstContact::hits));
        for (contact, finding) in contacts.into_iter().zip(findings) {
            let known = self.found.entry(contact.contact.obstacle).or_insert_with(|| Found {
                wires: 0,
                run,
                deepest: contact,
                finding: finding.clone(),
            });
            known.wires += 1;
            if contact.depth > known.deepest.depth {
                *known = Found { wires: known.wires, run, deepest: contact, finding };
            }
        }
    }

    /// What was found of all.
    pub fn finish(self) -> SimulatedCollisions {
        let mut found: Vec<Found> = self.found.into_values().collect();
        found.sort_by_key(|found| (found.finding.severity, found.deepest.contact.step));
        let report = |Found { wires, run, finding, .. }: Found| SimulatedContact {
            finding: DiagnosticReport::from(&finding),
            wires,
            run,
        };
        SimulatedCollisions {
            wires: self.wires,
            colliding: self.colliding,
            share: f64::from(self.colliding) / f64::from(self.wires.max(1)),
            diagnostics: found.into_iter().map(report).collect(),
        }
    }
}
