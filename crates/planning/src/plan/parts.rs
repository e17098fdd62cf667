//! The wires of the parts of a design, one part after the other.

use std::collections::BTreeMap;

use wirebend_core::plan::{PlanOptions, WirePlan, plan_wires};
use wirebend_core::route::Route;
use wirebend_core::wireframe::{Component, VertexId};
use wirebend_files::document::{Clearance, Document};

use super::choice::{
    Allowance, Replaced, WireChoice, chosen_walks, doubling_choice, start_in, wires_of_parts,
};
use super::observed::Observed;
use crate::Progress;
use crate::choices::PlanChoices;
use crate::machine::Setup;

/// The parts of a design, and how their wires are planned.
pub(super) struct Parts<'a> {
    pub document: &'a Document,
    /// Those without an edge, too.
    pub components: &'a [Component],
    pub setup: &'a Setup,
    pub choices: &'a PlanChoices,
    pub chosen: WireChoice,
    /// The walks in their order where that is kept.
    pub settled: Vec<Route>,
    pub start: Option<VertexId>,
    pub clearance: Clearance,
}

/// What came of all parts.
pub(super) struct PlannedParts {
    pub wires: Vec<WirePlan>,
    /// ms of each stage, for each wire: the first of a part has the times of all its wires.
    pub timings: Vec<BTreeMap<&'static str, f64>>,
    pub replaced: Replaced,
}

impl Parts<'_> {
    pub(super) fn plan(&self, progress: &dyn Progress) -> PlannedParts {
        let &Self { document, components, setup, choices, ref chosen, ref settled, start, clearance } = self;
        let bent: Vec<&Component> =
            components.iter().filter(|component| !component.edges.is_empty()).collect();
        let mut wires = Vec::with_capacity(bent.len());
        let mut timings = Vec::with_capacity(bent.len());
        let mut replaced = Replaced::default();
        progress.stage("planning");
        let shares = wires_of_parts(document, &bent, start, chosen.wires);
        let mut allowance = Allowance::of(choices, chosen, &shares);
        for (index, component) in bent.iter().enumerate() {
            progress.advance(index as u64, bent.len() as u64);
            let here = start_in(component, start);
            let share = &shares[index];
            let walks = chosen_walks(document, component, choices, &mut replaced);
            let doubling =
                doubling_choice(document, component, choices, chosen, (here, share), &mut replaced);
            let options = PlanOptions {
                wires: share.wires,
                doubling,
                detours: choices.detours,
                closed: chosen.closed,
                start: here,
                // Walks that were chosen have their direction.
                reversed: chosen.reversed && walks.is_empty(),
                contacts: choices.collisions || choices.avoid_collisions,
                clearance: clearance.length(),
                sag: choices.sag || document.collisions.sag,
                search: allowance.search(choices, share),
                clear_sides: !walks.is_empty(),
                settled: if walks.is_empty() { settled.clone() } else { walks },
            };
            let mut took = BTreeMap::new();
            let observer = Observed::new(progress, [index + 1, bent.len()], &mut took);
            let plans = plan_wires(&document.wireframe, component, &setup.model, &options, observer);
            progress.stage("planning");
            allowance.use_up(share, plans.len());
            timings.push(took);
            timings.resize(timings.len() + plans.len() - 1, BTreeMap::new());
            wires.extend(plans);
        }
        progress.advance(bent.len() as u64, bent.len() as u64);
        PlannedParts { wires, timings, replaced }
    }
}
