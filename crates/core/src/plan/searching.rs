//! From the first routes to wires that meet nothing.

use std::collections::BTreeSet;

use super::contacts::ContactOptions;
use super::stages::{Stages, bend_seconds};
use super::{
    DoublingChoice, Machine, PlanObserver, PlanOptions, Searched, WirePlan, along, contacts, routing,
};
use crate::checks::{Code, Diagnostic, Fact, Location, Remedy, Severity};
use crate::clearance::Obstacle;
use crate::route::{Doubling, ForcedBend, Route};
use crate::schedule::ScheduledProgram;
use crate::search::{
    Bender, FoundWire, Helps, Obstruction, SearchOptions, SearchOutcome, SearchProgress, SearchTask,
    bend_route, search,
};
use crate::units::Angle;
use crate::wireframe::{Component, EdgeId, Wireframe};

/// A search for the wires of a component.
#[derive(Clone, Copy)]
pub(super) struct Searching<'a> {
    pub wireframe: &'a Wireframe,
    pub component: &'a Component,
    pub machine: &'a Machine,
    pub options: &'a PlanOptions,
}

/// Which edges are run along once more.
#[derive(Clone, Copy)]
pub(super) struct Doubled<'a> {
    pub edges: &'a [EdgeId],
    /// Whether they may be others.
    pub is_free: bool,
}

/// Wires instead of the first ones.
pub(super) struct SearchedWires {
    pub wires: Vec<FoundWire>,
    pub searched: Searched,
    pub helps: Helps,
}

impl Searching<'_> {
    /// Searches where it is wanted and there are routes that a machine can bend.
    pub fn find(
        &self,
        (routes, doubled): (&[Route], &[EdgeId]),
        forced: &[ForcedBend],
        observer: &mut dyn PlanObserver,
    ) -> Option<SearchedWires> {
        let options = self.options;
        let wanted = options.search.as_ref().filter(|_| !routes.is_empty() && forced.is_empty())?;
        let most = if options.closed { wanted.effort } else { wanted.most_checks() };
        let mut ended = false;
        let task = Doubled { edges: doubled, is_free: self.is_free() };
        let outcome = self.look(routes, task, wanted, &mut |progress| {
            ended |= !observer.searching(progress, most);
            !ended
        })?;
        let keeps_walks = !options.settled.is_empty();
        let vertex = outcome.obstruction.and_then(|obstruction| obstruction.vertex);
        let helps = match (outcome.is_clear || keeps_walks, ended) {
            (true, _) => Helps::default(),
            (false, true) => Helps { ended, ..Helps::default() },
            (false, false) => self.helps((routes, doubled), vertex, wanted, observer),
        };
        let searched = Searched {
            found: outcome.is_clear,
            checks: outcome.checks,
            exhausted: outcome.exhausted,
            obstruction: outcome.obstruction,
            ended,
            objective: wanted.objective,
        };
        Some(SearchedWires { wires: outcome.best.wires, searched, helps })
    }

    /// Whether other edges may be doubled than those that are: detours are around bends that no other doubling avoids.
    pub(super) fn is_free(&self) -> bool {
        self.options.doubling == DoublingChoice::Cheapest && !self.options.detours
    }

    /// A search with options of its own.
    pub(super) fn look(
        &self,
        routes: &[Route],
        doubled: Doubled,
        wanted: &SearchOptions,
        should_continue: &mut dyn FnMut(SearchProgress) -> bool,
    ) -> Option<SearchOutcome> {
        let Self { wireframe, component, machine, options } = *self;
        let seconds = |bend| bend_seconds(machine, bend);
        // As in edges that are too short.
        let anyway = routes.iter().flat_map(|route| errors(&self.planned(route, None, false))).collect();
        let accepts = |route: &Route, scheduled: &ScheduledProgram| self.accepts(route, scheduled, &anyway);
        let bender = self.bender(&seconds, &accepts);
        let task = SearchTask {
            routes,
            doubled: (!doubled.is_free).then_some(doubled.edges),
            start: options.start,
            closed: options.closed,
            keep_routes: !options.settled.is_empty(),
        };
        search(wireframe, component, &bender, &task, wanted, should_continue)
    }

    /// For each route the sides and windings of its bends with which it meets least.
    pub fn clear_sides(&self, routes: &[Route]) -> Option<Vec<ScheduledProgram>> {
        let seconds = |bend| bend_seconds(self.machine, bend);
        let bender = self.bender(&seconds, &|_, _| true);
        let best = |route: &Route| Some(bend_route(self.wireframe, route, &bender, true)?.scheduled);
        routes.iter().map(best).collect()
    }

    fn bender<'b>(
        &'b self,
        seconds: &'b dyn Fn(Angle) -> Option<f64>,
        accepts: &'b dyn Fn(&Route, &ScheduledProgram) -> bool,
    ) -> Bender<'b> {
        let machine = self.machine;
        Bender {
            head: &machine.head,
            bend: &machine.compensation.bend,
            bodies: &machine.bodies,
            wire: contacts::stock_wire(machine, &ContactOptions::of(self.options)),
            straight: machine.straight,
            max_bend: routing::largest_bend(machine),
            seconds,
            accepts,
        }
    }

    /// Whether a wire meets nothing and has no errors but those that the routes have anyway.
    fn accepts(&self, route: &Route, scheduled: &ScheduledProgram, anyway: &BTreeSet<Code>) -> bool {
        let plan = self.planned(route, Some(scheduled), true);
        let is_clear = plan.contacts.as_ref().is_some_and(Vec::is_empty) && plan.compensated.is_some();
        is_clear && errors(&plan).is_subset(anyway)
    }

    /// A wire through all stages.
    fn planned(&self, route: &Route, scheduled: Option<&ScheduledProgram>, contacts: bool) -> WirePlan {
        let stages = Stages {
            wireframe: self.wireframe,
            machine: self.machine,
            contacts,
            contact_options: ContactOptions::of(self.options),
            searched: true,
            odd_allowed: 2,
            forced: &[],
            passed_again: Vec::new(),
        };
        let doubled = routing::again(route);
        let mut plan = WirePlan::new(along(route), doubled, Doubling::default(), Some(route.clone()));
        plan.scheduled = scheduled.cloned();
        stages.run(0, &mut plan, Vec::new(), &mut |_| ());
        plan
    }

    /// The cheapest doubling for so many wires.
    pub fn proposal(&self, wires: usize) -> Option<Doubling> {
        let options = PlanOptions { wires, ..self.options.clone() };
        routing::proposal(self.wireframe, self.component, &options).ok()
    }

    /// That nothing was searched where it was wanted: no wire has a program before the bends that no route avoids are out of the way.
    pub fn not_searched(&self, forced: &[ForcedBend]) -> Option<Diagnostic> {
        let is_wanted = self.options.search.is_some() && !forced.is_empty();
        is_wanted.then(|| Diagnostic {
            severity: Severity::Error,
            location: Location::at_vertices(forced.iter().map(|bend| bend.vertex)),
            fact: Fact::NoClearProgram {
                checks: 0,
                exhausted: false,
                obstacle: None,
                body: None,
                passed: None,
                clearance: self.options.clearance,
                helps: Helps::default(),
            },
            // What is said of these bends says what to do about them.
            remedies: Vec::new(),
        })
    }

    /// That nothing was found, and what was in the way.
    pub fn finding(&self, searched: &Searched, helps: Helps) -> Option<Diagnostic> {
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
        let keeps_walk = !self.options.settled.is_empty();
        let longer = (!exhausted && !keeps_walk).then_some(Remedy::SearchLonger);
        let more = (!keeps_walk && !self.options.closed).then_some(Remedy::AllowWires);
        let further = [Remedy::MoveApart, Remedy::ChooseMachine];
        Some(Diagnostic {
            severity: Severity::Error,
            location: Location::at_vertices(obstruction.and_then(|obstruction| obstruction.vertex)),
            fact: Fact::NoClearProgram {
                checks,
                exhausted,
                obstacle: obstruction.and_then(|obstruction| obstruction.obstacle),
                body: body.map(|body| body.name.clone()),
                passed: obstruction.map(|obstruction| (obstruction.passed, obstruction.of)),
                clearance: self.options.clearance,
                helps,
            },
            remedies: measure.into_iter().chain(longer).chain(more).chain(further).collect(),
        })
    }
}

/// What a wire cannot be made for.
fn errors(plan: &WirePlan) -> BTreeSet<Code> {
    plan.diagnostics.iter().filter(|found| found.is_error()).map(Diagnostic::code).collect()
}
