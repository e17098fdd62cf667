//! The wires of the parts of a design, one part after the other.

use std::collections::BTreeMap;

use wirebend_core::checks::Diagnostic;
use wirebend_core::plan::{PlanOptions, WirePlan, check_walks, plan_wires};
use wirebend_core::route::{Route, Share};
use wirebend_core::units::Length;
use wirebend_core::wireframe::{Component, VertexId};
use wirebend_error::InputName;
use wirebend_files::document::Document;

use super::choice::{
    Allowance, Replaced, WireChoice, chosen_walks, doubling_choice, start_in, wires_of_parts,
};
use super::observed::Observed;
use crate::choices::PlanChoices;
use crate::contacts::collision_margin;
use crate::design::Opened;
use crate::machine::Setup;
use crate::{PlanningError, Progress};

/// The parts of a design, and how their wires are planned.
pub(super) struct Parts<'a> {
    document: &'a Document,
    /// Those that have edges.
    bent: Vec<&'a Component>,
    choices: &'a PlanChoices,
    chosen: WireChoice,
    /// The walks in their order where that is kept.
    settled: Vec<Route>,
    start: Option<VertexId>,
    clearance: Length,
}

/// What came of all parts.
pub(super) struct PlannedParts {
    pub wires: Vec<WirePlan>,
    /// ms of each stage, for each wire: the first of a part has the times of all its wires.
    pub timings: Vec<BTreeMap<&'static str, f64>>,
    /// What was accepted and is not used.
    pub replaced: Replaced,
}

impl<'a> Parts<'a> {
    /// The parts of a design. `components`: all of them.
    ///
    /// # Errors
    /// [`PlanningError`] for a choice for its wires that cannot be, such as a start that is no vertex.
    pub(super) fn of(
        opened: &'a Opened,
        components: &'a [Component],
        choices: &'a PlanChoices,
    ) -> Result<Self, PlanningError> {
        opened.require_designed()?;
        let document = &opened.document;
        let settled = opened.settled(choices)?;
        let clearance = choices.collision_margin_mm.map(collision_margin).transpose()?;
        let chosen = WireChoice::of(document, choices)?;
        let start = choices.start.map(VertexId).or(document.start);
        if let Some(VertexId(vertex)) = start.filter(|&vertex| document.wireframe.vertex(vertex).is_none()) {
            return Err(opened.no_vertex(vertex, InputName::Start));
        }
        if let Some(VertexId(vertex)) = start.filter(|&vertex| document.wireframe.incident(vertex).is_empty())
        {
            return Err(PlanningError::StartWithoutEdge { vertex, name: opened.name.clone() });
        }
        let bent: Vec<&Component> =
            components.iter().filter(|component| !component.edges.is_empty()).collect();
        let clearance = clearance.unwrap_or(document.collisions.clearance_mm).length();
        Ok(Self { document, bent, choices, chosen, settled, start, clearance })
    }

    pub(super) fn plan(&self, setup: &Setup, progress: &dyn Progress) -> PlannedParts {
        let mut wires = Vec::with_capacity(self.bent.len());
        let mut timings = Vec::with_capacity(self.bent.len());
        let mut replaced = Replaced::default();
        progress.stage("planning");
        let shares = self.shares();
        let mut allowance = Allowance::of(self.choices, &self.chosen, &shares);
        for (index, (component, share)) in self.bent.iter().zip(&shares).enumerate() {
            progress.advance(index as u64, self.bent.len() as u64);
            let options = PlanOptions {
                search: allowance.search(self.choices, share),
                ..self.options(component, share, &mut replaced)
            };
            let mut took = BTreeMap::new();
            let observer = Observed::new(progress, [index + 1, self.bent.len()], &mut took);
            let plans = plan_wires(&self.document.wireframe, component, &setup.model, &options, observer);
            progress.stage("planning");
            allowance.use_up(share, plans.len());
            timings.push(took);
            timings.resize(timings.len() + plans.len() - 1, BTreeMap::new());
            wires.extend(plans);
        }
        progress.advance(self.bent.len() as u64, self.bent.len() as u64);
        PlannedParts { wires, timings, replaced }
    }

    /// What stands in the way of the wires whichever machine bends them, and what was accepted and is not used.
    pub(super) fn check(&self) -> (Vec<Diagnostic>, Replaced) {
        let mut replaced = Replaced::default();
        let mut found = Vec::new();
        for (component, share) in self.bent.iter().zip(&self.shares()) {
            let options = self.options(component, share, &mut replaced);
            found.extend(check_walks(&self.document.wireframe, component, &options));
        }
        (found, replaced)
    }

    /// What each part has of the wires.
    fn shares(&self) -> Vec<Share> {
        wires_of_parts(self.document, &self.bent, self.start, self.chosen.wires)
    }

    /// How the wires of a part are planned, but for a search.
    fn options(&self, component: &Component, share: &Share, replaced: &mut Replaced) -> PlanOptions {
        let &Self { document, choices, ref chosen, ref settled, start, clearance, .. } = self;
        let here = start_in(component, start);
        let walks = chosen_walks(document, component, choices, replaced);
        PlanOptions {
            wires: share.wires,
            doubling: doubling_choice(document, component, choices, chosen, (here, share), replaced),
            detours: choices.detours,
            closed: chosen.closed,
            start: here,
            // Walks that were chosen have their direction.
            reversed: chosen.reversed && walks.is_empty(),
            contacts: choices.collisions || choices.avoid_collisions,
            clearance,
            sag: choices.sag || document.collisions.sag,
            search: None,
            clear_sides: !walks.is_empty(),
            settled: if walks.is_empty() { settled.clone() } else { walks },
        }
    }
}
