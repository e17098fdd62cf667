//! The search for a program that meets nothing: which walk the wire takes, from which end, how it stands about its own axis, to
//! which side each bend is made and how far the head is wound; and where one wire cannot, fewest wires.
//!
//! Every step is judged as [`crate::clearance`] judges it. For a given walk, signs and windings are found by a dynamic program that
//! is exact; the walks are searched in a tree, from a seed, so that the same question has the same answer.

mod heads;
mod rounds;
mod trail;
mod walk;
mod wire;

use crate::clearance::{Bodies, Obstacle, StockWire};
use crate::compensate::BendModel;
use crate::route::Route;
use crate::schedule::{HeadLimits, ScheduledProgram};
use crate::units::Angle;
use crate::wireframe::{Component, EdgeId, VertexId, Wireframe};
use heads::Stand;
use rounds::Search;

/// The machine that a program is searched for.
pub struct Bender<'a> {
    /// What its head can do.
    pub head: &'a HeadLimits,
    /// How it bends.
    pub bend: &'a BendModel,
    /// Its bodies.
    pub bodies: &'a Bodies,
    /// The wire in it.
    pub wire: StockWire,
    /// A change of direction up to this is not bent.
    pub straight: Angle,
    /// The largest bend that it makes.
    pub max_bend: Angle,
    /// How long a signed bend takes, s; none where it cannot be made to that side.
    pub seconds: &'a dyn Fn(Angle) -> Option<f64>,
}

/// What is searched for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SearchOptions {
    /// How many steps may be asked about for each number of wires.
    pub effort: u64,
    /// Where chance begins.
    pub seed: u64,
    /// How many wires there may be at most.
    pub max_wires: usize,
}

impl Default for SearchOptions {
    fn default() -> Self {
        Self { effort: 20_000, seed: 1, max_wires: 6 }
    }
}

/// What is walked.
#[derive(Debug, Clone)]
pub struct SearchTask<'a> {
    /// The routes that are there.
    pub routes: &'a [Route],
    /// Which edges are passed once more; none: the cheapest for each number of wires.
    pub doubled: Option<&'a [EdgeId]>,
    /// Where the wire starts, if that is chosen.
    pub start: Option<VertexId>,
    /// Whether there is to be one wire that ends where it starts.
    pub closed: bool,
    /// Whether the routes are to stay as they are, so that only signs and windings are free.
    pub keep_routes: bool,
}

/// A wire with its walk and its program.
#[derive(Debug, Clone, PartialEq)]
pub struct FoundWire {
    /// The walk.
    pub route: Route,
    /// Signs and windings.
    pub scheduled: ScheduledProgram,
    /// What it meets: 0 is nothing, and more is worse.
    met: u64,
    /// How long it takes but for its feeds.
    nanoseconds: i64,
}

/// Wires that cover everything.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// One at least.
    pub wires: Vec<FoundWire>,
}

/// What was in the way where a search came farthest.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Obstruction {
    /// How many edges were passed until there, counted as often as they are to be passed.
    pub passed: usize,
    /// How many there are.
    pub of: usize,
    /// The vertex whose bend cannot be made.
    pub vertex: Option<VertexId>,
    /// What it meets; none where the head cannot turn so far.
    pub obstacle: Option<Obstacle>,
}

impl Obstruction {
    /// How far it came, as a share of all.
    #[allow(clippy::cast_precision_loss)] // thousands
    fn share(&self) -> f64 {
        self.passed as f64 / self.of.max(1) as f64
    }
}

/// What came of a search.
#[derive(Debug, Clone, PartialEq)]
pub struct SearchOutcome {
    /// The best that was found: that which meets nothing, else that which meets least.
    pub best: Found,
    /// Whether it meets nothing.
    pub is_clear: bool,
    /// How many steps were asked about.
    pub checks: u64,
    /// Whether every walk of one wire was tried, with every sign and winding, as far as more wires were not allowed.
    pub exhausted: bool,
    /// What was in the way where it came farthest without a contact; none where nothing had to be searched.
    pub obstruction: Option<Obstruction>,
}

/// Searches for wires along all edges of a component that meet nothing while they are bent. `go_on` is told how many steps were
/// asked about; the search ends where it says no, with the best that there is. `None`: the routes that are there cannot be bent at
/// all.
pub fn search(
    wireframe: &Wireframe,
    component: &Component,
    bender: &Bender,
    task: &SearchTask,
    options: &SearchOptions,
    mut go_on: impl FnMut(u64) -> bool,
) -> Option<SearchOutcome> {
    let stands = stands(bender.head, task.keep_routes);
    let best_of = |route: &Route| {
        let backwards = (!task.keep_routes && task.start.is_none()).then(|| route.reversed());
        let ways = [Some(route.clone()), backwards].into_iter().flatten();
        let bent = ways.filter_map(|route| wire::bend_route(wireframe, &route, bender, &stands));
        bent.min_by_key(|found| (found.met, found.nanoseconds))
    };
    let first = Found { wires: task.routes.iter().map(best_of).collect::<Option<_>>()? };
    let mut outcome = SearchOutcome {
        is_clear: first.met() == 0,
        best: first,
        checks: task.routes.iter().map(|route| route.traversals.len() as u64).sum(),
        exhausted: false,
        obstruction: None,
    };
    if outcome.is_clear || task.keep_routes {
        return Some(outcome);
    }
    let most = if task.closed { 1 } else { options.max_wires.max(1) };
    for wires in 1..=most {
        let mut search = Search {
            wireframe,
            component,
            bender,
            task,
            options,
            wires,
            checks: 0,
            exhausted: false,
            obstruction: None,
        };
        let before = outcome.checks;
        let found = search.run(&mut |checks| go_on(before + checks));
        outcome.checks += search.checks;
        outcome.exhausted = search.exhausted && most == 1;
        outcome.obstruction = search.obstruction.or(outcome.obstruction);
        if let Some(found) = found {
            (outcome.best, outcome.is_clear) = (found, true);
            return Some(outcome);
        }
        if !go_on(outcome.checks) {
            break;
        }
    }
    Some(outcome)
}

impl Found {
    fn met(&self) -> u64 {
        self.wires.iter().map(|wire| wire.met).sum()
    }
}

/// How a wire may stand about its own axis: with the head at its reference for the first bend, to either side; and where `turned` says
/// so, turned to the sides, too, as far as the head goes.
fn stands(limits: &HeadLimits, turned: bool) -> Vec<Stand> {
    let stand = |(degrees, flipped): (i32, bool)| Stand {
        head: Angle::computed(f64::from(degrees).to_radians()),
        flipped,
    };
    let at_reference = [(0, false), (0, true)];
    let aside = [45, -45, 90, -90, 135, -135].map(|degrees| (degrees, false));
    let aside = aside.into_iter().filter(|_| turned);
    let within = |stand: &Stand| stand.head >= limits.min && stand.head <= limits.max;
    at_reference.into_iter().chain(aside).map(stand).filter(within).collect()
}

#[cfg(test)]
mod tests;
