//! The whole pipeline for the wires of a component: every stage in order, as far as it gets, and what the checks say.

mod closing;
mod contacts;
mod head;
mod helps;
mod routing;
mod searching;
mod seen;
mod stages;

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::Point3;

use crate::bend::{Frame, NominalProgram};
use crate::checks::{Diagnostic, MachineLimits, Sourced};
use crate::clearance::{Bodies, FirstContact, JointSag};
use crate::compensate::{CompensatedProgram, Compensation};
use crate::estimate::{TimeModel, WireModel};
use crate::route::{Doubling, Route};
use crate::sag::Sag;
use crate::schedule::{HeadLimits, ScheduledProgram};
use crate::search::{Objective, Obstruction, SearchOptions, SearchProgress};
use crate::units::{Angle, Length};
use crate::wireframe::{Component, EdgeId, VertexId, Wireframe};
pub use closing::name_closing_bends;
pub use contacts::{ContactOptions, ScheduledWire, clearance, keep_contacts};
use routing::Routed;
pub use routing::check_walks;
use searching::Searching;
pub use seen::check_given;
use stages::Stages;
pub use stages::fastest_schedule;

/// A machine with a wire in it: everything that the stages ask about.
#[derive(Debug, Clone, PartialEq)]
pub struct Machine {
    /// What it can do.
    pub limits: MachineLimits,
    /// What its head can do.
    pub head: HeadLimits,
    /// How its feeds and bends are compensated for.
    pub compensation: Compensation,
    /// How fast it is.
    pub time: TimeModel,
    /// The wire.
    pub wire: WireModel,
    /// Centreline radius of its bends.
    pub bend_radius: Length,
    /// A change of direction up to this is not bent: half of what the bend axis resolves.
    pub straight: Angle,
    /// Its bodies.
    pub bodies: Bodies,
    /// How far its bends scatter (one standard deviation), where that is known.
    pub scatter: Option<Sourced<Angle>>,
}

/// Which edges are travelled twice.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum DoublingChoice {
    /// Those that a person has accepted.
    Accepted(Vec<EdgeId>),
    /// The cheapest that make a route possible.
    Cheapest,
}

impl Default for DoublingChoice {
    /// Every edge once.
    fn default() -> Self {
        Self::Accepted(Vec::new())
    }
}

/// What a person may choose of a plan.
#[derive(Debug, Clone, PartialEq, Eq)]
#[allow(clippy::struct_excessive_bools)] // each is an option of its own
pub struct PlanOptions {
    /// How many wires there may be, at least one. Fewer are used where more would not save doubled edges.
    pub wires: usize,
    /// Which edges are travelled twice.
    pub doubling: DoublingChoice,
    /// Whether edges are travelled once more, too, where only a detour avoids a bend that the machine cannot make.
    pub detours: bool,
    /// Whether the wire must end where it starts.
    pub closed: bool,
    /// Where the wire starts.
    pub start: Option<VertexId>,
    /// Whether the wire runs the other way: it ends where it would have started.
    pub reversed: bool,
    /// Whether to look where the wire meets the machine or itself, which takes the longest.
    pub contacts: bool,
    /// How far they have to stay from each other.
    pub clearance: Length,
    /// Whether to work out how far the part already bent sags under its own weight, and to look for contacts as it hangs.
    pub sag: bool,
    /// How to search for wires that meet nothing while they are bent; none where the first ones will do. Where a walk is settled,
    /// signs and windings alone are searched.
    pub search: Option<SearchOptions>,
    /// The walks, where they are settled: no others are looked for, and no edge is doubled but those that they pass again.
    pub settled: Vec<Route>,
    /// Whether of settled walks those sides and windings of bends are taken with which the wire meets least, instead of the fastest.
    pub clear_sides: bool,
}

impl Default for PlanOptions {
    /// One open wire along every edge once.
    fn default() -> Self {
        Self {
            wires: 1,
            doubling: DoublingChoice::default(),
            detours: false,
            closed: false,
            start: None,
            reversed: false,
            contacts: false,
            clearance: Length::ZERO,
            sag: false,
            search: None,
            settled: Vec::new(),
            clear_sides: false,
        }
    }
}

/// A stage of the pipeline that has been done.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    /// Which edges to travel twice.
    Doubling,
    /// The walk along every edge.
    Route,
    /// The nominal program.
    Program,
    /// Signs and windings.
    Schedule,
    /// What the machine is told.
    Compensate,
    /// The search for wires that meet nothing.
    Search,
    /// Where the wire meets the machine.
    Contacts,
    /// What cannot be made.
    Check,
}

/// Hears how far planning is.
pub trait PlanObserver {
    /// A stage has been done.
    fn done(&mut self, stage: Stage);

    /// How far the search for the wires of a part is, of so many steps at most. Whether it goes on; else it ends with the best that it has.
    fn searching(&mut self, _progress: SearchProgress, _of: u64) -> bool {
        true
    }

    /// So many steps, of so many at most, were checked to see which changes help where a search has found nothing. Whether it goes on.
    fn trying(&mut self, _checks: u64, _of: u64) -> bool {
        true
    }
}

impl<F: FnMut(Stage)> PlanObserver for F {
    fn done(&mut self, stage: Stage) {
        self(stage);
    }
}

/// What came of a search, of all wires of a component together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Searched {
    /// Whether wires were found that meet nothing.
    pub found: bool,
    /// How many steps were checked.
    pub checks: u64,
    /// Whether every walk of one wire was tried.
    pub exhausted: bool,
    /// What was in the way where it came farthest.
    pub obstruction: Option<Obstruction>,
    /// Whether it was ended before it was done.
    pub ended: bool,
    /// By what programs that meet nothing were compared.
    pub objective: Objective,
}

/// One wire through all stages, as far as it got.
#[derive(Debug, Clone, PartialEq)]
pub struct WirePlan {
    /// What it covers: a component, or a part of one that it shares with other wires.
    pub component: Component,
    /// Edges that are travelled twice.
    pub doubled: Vec<EdgeId>,
    /// The cheapest doubling for these options, whether or not it was applied.
    pub proposal: Doubling,
    /// The route.
    pub route: Option<Route>,
    /// The edges that it makes once more beside a wire before it, one of them for each time.
    pub beside: Vec<EdgeId>,
    /// Whether the wires that were planned with it are the cheapest together; of one alone its proposal says.
    pub is_cheapest: bool,
    /// The positions of the route's vertices, in mm.
    pub path: Vec<Point3<f64>>,
    /// The frame in which the nominal program starts.
    pub start: Frame,
    /// The nominal program.
    pub nominal: Option<NominalProgram>,
    /// The schedule.
    pub scheduled: Option<ScheduledProgram>,
    /// The compensated program.
    pub compensated: Option<CompensatedProgram>,
    /// What came of the search for wires that meet nothing; none where there was none.
    pub searched: Option<Searched>,
    /// How far the part already bent sags under its own weight; none where nobody asked.
    pub sag: Option<PartSag>,
    /// How contacts are looked for.
    pub contact_options: ContactOptions,
    /// Where it meets the machine or itself while it is bent; none where nobody looked.
    pub contacts: Option<Vec<FirstContact>>,
    /// What the checks say, doublings and refusals included.
    pub diagnostics: Vec<Diagnostic>,
    /// Seconds on the machine.
    pub seconds: Option<f64>,
    /// Stock to load.
    pub stock: Option<Length>,
}

/// How far the part already bent sags under its own weight while the machine bends it; see [`crate::sag`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PartSag {
    /// The largest sag of its free end.
    pub largest: Sag,
    /// Where it is off the most when the wire comes back to a vertex; none where it never does.
    pub joint: Option<JointSag>,
}

impl WirePlan {
    /// A wire before all stages but its route.
    fn new(component: Component, doubled: Vec<EdgeId>, proposal: Doubling, route: Option<Route>) -> Self {
        Self {
            component,
            doubled,
            proposal,
            route,
            beside: Vec::new(),
            is_cheapest: true,
            path: Vec::new(),
            start: Frame::default(),
            nominal: None,
            scheduled: None,
            compensated: None,
            searched: None,
            sag: None,
            contact_options: ContactOptions::default(),
            contacts: None,
            diagnostics: Vec::new(),
            seconds: None,
            stock: None,
        }
    }

    /// What the doubled edges add to the wire.
    #[must_use]
    pub fn doubled_length(&self, wireframe: &Wireframe) -> Length {
        self.doubled.iter().map(|&edge| wireframe.edge_length(edge)).sum()
    }

    /// What the edges add that it makes beside a wire before it.
    #[must_use]
    pub fn length_beside(&self, wireframe: &Wireframe) -> Length {
        self.beside.iter().map(|&edge| wireframe.edge_length(edge)).sum()
    }

    /// Whether the machine can make it: it has been compensated and no check objects.
    #[must_use]
    pub fn is_feasible(&self) -> bool {
        self.compensated.is_some() && !self.diagnostics.iter().any(Diagnostic::is_error)
    }
}

/// Plans the wires of one component: one, or where the options allow more, one for every two odd vertices. Whatever stands in the
/// way of a stage becomes a diagnostic, and the stages after it are left out.
pub fn plan_wires(
    wireframe: &Wireframe,
    component: &Component,
    machine: &Machine,
    options: &PlanOptions,
    mut observer: impl PlanObserver,
) -> Vec<WirePlan> {
    plan_observed(wireframe, component, machine, options, &mut observer)
}

/// The same, compiled once for all observers.
fn plan_observed(
    wireframe: &Wireframe,
    component: &Component,
    machine: &Machine,
    options: &PlanOptions,
    observer: &mut dyn PlanObserver,
) -> Vec<WirePlan> {
    let max_bend = Some(routing::largest_bend(machine));
    let Routed { mut doubled, mut proposal, mut routes, forced, mut refusals } =
        routing::find(wireframe, component, max_bend, options, &mut |stage| observer.done(stage));
    let mut schedules: Vec<ScheduledProgram> = Vec::new();
    let mut searched = None;
    let search = Searching { wireframe, component, machine, options };
    if let Some(found) = search.find((&routes, &doubled), &forced, observer) {
        refusals.extend(search.finding(&found.searched, found.helps));
        (routes, schedules) = found.wires.into_iter().map(|wire| (wire.route, wire.scheduled)).unzip();
        doubled = routing::repeated(&routes);
        proposal = search.proposal(routes.len()).unwrap_or(proposal);
        searched = Some(found.searched);
        observer.done(Stage::Search);
    } else {
        refusals.extend(search.not_searched(&forced));
        if options.clear_sides {
            schedules = search.clear_sides(&routes).unwrap_or_default();
        }
    }
    let mut done = |stage| observer.done(stage);
    let stages = Stages {
        wireframe,
        machine,
        contacts: options.contacts || options.search.is_some(),
        contact_options: ContactOptions::of(options),
        searched: options.search.is_some(),
        odd_allowed: routing::allowed(options),
        forced: &forced,
        passed_again: passed_again(&routes),
    };
    if routes.len() < 2 {
        let mut plan = WirePlan::new(component.clone(), doubled, proposal, routes.pop());
        (plan.scheduled, plan.searched) = (schedules.pop(), searched);
        stages.run(0, &mut plan, refusals, &mut done);
        return vec![plan];
    }
    let added = |edges: &[EdgeId]| -> Length { edges.iter().map(|&edge| wireframe.edge_length(edge)).sum() };
    let is_cheapest = proposal.is_matched_by(added(&doubled));
    let mut made = BTreeSet::new();
    let plan_one = |(index, route): (usize, Route)| {
        let component = along(&route);
        let beside = component.edges.iter().copied().filter(|edge| !made.insert(*edge)).collect();
        let doubled = routing::again(&route);
        let proposal = Doubling { edges: Vec::new(), added: added(&doubled) };
        let mut plan = WirePlan::new(component, doubled, proposal, Some(route));
        (plan.beside, plan.is_cheapest) = (beside, is_cheapest);
        (plan.scheduled, plan.searched) = (schedules.get(index).cloned(), searched);
        let of_all = if index == 0 { std::mem::take(&mut refusals) } else { Vec::new() };
        stages.run(index, &mut plan, of_all, &mut done);
        plan
    };
    routes.into_iter().enumerate().map(plan_one).collect()
}

/// For each wire the edges that are passed more than once and last by it, and how often by all wires together.
fn passed_again(routes: &[Route]) -> Vec<Vec<(EdgeId, usize)>> {
    let mut passes: BTreeMap<EdgeId, (usize, usize)> = BTreeMap::new();
    for (wire, route) in routes.iter().enumerate() {
        for traversal in &route.traversals {
            let (count, last) = passes.entry(traversal.edge).or_default();
            (*count, *last) = (*count + 1, wire);
        }
    }
    let mut found = vec![Vec::new(); routes.len()];
    for (edge, (count, last)) in passes.into_iter().filter(|(_, (count, _))| *count > 1) {
        found[last].push((edge, count));
    }
    found
}

/// What one of several wires runs along.
fn along(route: &Route) -> Component {
    let mut edges: Vec<EdgeId> = route.traversals.iter().map(|traversal| traversal.edge).collect();
    let mut vertices = route.vertices();
    edges.sort_unstable();
    edges.dedup();
    vertices.sort_unstable();
    vertices.dedup();
    Component { vertices, edges }
}
