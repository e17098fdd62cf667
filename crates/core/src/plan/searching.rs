//! From the first routes to wires that meet nothing.

use std::collections::BTreeSet;

use super::stages::bend_seconds;
use super::{DoublingChoice, Machine, PlanObserver, PlanOptions, Searched, contacts, routing};
use crate::checks::{Diagnostic, Fact, Location, Remedy, Severity};
use crate::clearance::Obstacle;
use crate::route::{Doubling, ForcedBend, Route};
use crate::search::{Bender, FoundWire, Obstruction, SearchTask, search};
use crate::wireframe::{Component, EdgeId, Wireframe};

/// A search for the wires of a component.
pub(super) struct Searching<'a> {
    pub wireframe: &'a Wireframe,
    pub component: &'a Component,
    pub machine: &'a Machine,
    pub options: &'a PlanOptions,
}

/// Wires instead of the first ones.
pub(super) struct Instead {
    pub wires: Vec<FoundWire>,
    pub searched: Searched,
}

impl Searching<'_> {
    /// Searches where it is wanted and there are routes that a machine can bend.
    pub fn find(
        &self,
        routes: &[Route],
        forced: &[ForcedBend],
        observer: &mut impl PlanObserver,
    ) -> Option<Instead> {
        let Self { wireframe, component, machine, options } = *self;
        let wanted = options.search.as_ref().filter(|_| !routes.is_empty() && forced.is_empty())?;
        let bender = Bender {
            head: &machine.head,
            bend: &machine.compensation.bend,
            bodies: &machine.bodies,
            wire: contacts::stock_wire(machine),
            straight: machine.straight,
            max_bend: routing::largest_bend(machine),
            seconds: &|bend| bend_seconds(machine, bend),
        };
        let doubled = match &options.doubling {
            DoublingChoice::Accepted(edges) => Some(edges.as_slice()),
            DoublingChoice::Cheapest => None,
        };
        let task = SearchTask {
            routes,
            doubled,
            start: options.start,
            closed: options.closed,
            keep_routes: options.settled.is_some(),
        };
        let most = wanted.effort.saturating_mul(wanted.max_wires as u64);
        let outcome =
            search(wireframe, component, &bender, &task, wanted, |checks| observer.searching(checks, most))?;
        let searched = Searched {
            found: outcome.is_clear,
            checks: outcome.checks,
            exhausted: outcome.exhausted,
            obstruction: outcome.obstruction,
        };
        Some(Instead { wires: outcome.best.wires, searched })
    }

    /// The cheapest doubling for so many wires.
    pub fn proposal(&self, wires: usize) -> Option<Doubling> {
        let options = PlanOptions { wires, ..self.options.clone() };
        routing::proposal(self.wireframe, self.component, &options).ok()
    }

    /// That nothing was found, and what was in the way.
    pub fn finding(&self, searched: &Searched) -> Option<Diagnostic> {
        if searched.found {
            return None;
        }
        let Searched { checks, exhausted, obstruction, .. } = *searched;
        let bodies = &self.machine.bodies.all;
        let body = match obstruction.and_then(|Obstruction { obstacle, .. }| obstacle) {
            Some(Obstacle::Body(index)) => bodies.get(index),
            _ => None,
        };
        let measure = body.filter(|body| !body.measured).map(|_| Remedy::MeasureBody);
        let longer = (!exhausted).then_some(Remedy::SearchLonger);
        let further = [Remedy::AllowWires, Remedy::MoveApart, Remedy::ChooseMachine];
        Some(Diagnostic {
            severity: Severity::Warning,
            location: Location::at_vertices(obstruction.and_then(|obstruction| obstruction.vertex)),
            fact: Fact::NoClearProgram {
                checks,
                exhausted,
                obstacle: obstruction.and_then(|obstruction| obstruction.obstacle),
                body: body.map(|body| body.name.clone()),
                passed: obstruction.map(|obstruction| (obstruction.passed, obstruction.of)),
            },
            remedies: measure.into_iter().chain(longer).chain(further).collect(),
        })
    }
}

/// The edges that wires together pass more than once, as often as beyond the first time.
pub(super) fn doubled(routes: &[Route]) -> Vec<EdgeId> {
    let mut passed = BTreeSet::new();
    let all = routes.iter().flat_map(|route| &route.traversals);
    all.filter(|traversal| !passed.insert(traversal.edge)).map(|traversal| traversal.edge).collect()
}
