//! The search for a program that meets nothing: which walk the wire takes, from which end, how it stands about its own axis, to
//! which side each bend is made and how far the head is wound; and where one wire cannot, fewest wires.
//!
//! Every step is judged as [`crate::clearance`] judges it. For a given walk, signs and windings are found by a dynamic program that
//! is exact; the walks are searched in a tree, from a seed, so that the same question has the same answer.

mod heads;
mod helps;
mod objective;
mod rounds;
mod trail;
mod walk;
mod wire;

use crate::clearance::{Bodies, Obstacle, StockWire};
use crate::compensate::BendModel;
use crate::route::Route;
use crate::schedule::{HeadLimits, ScheduledProgram};
use crate::units::{Angle, Length};
use crate::wireframe::{Component, EdgeId, VertexId, Wireframe};
use heads::Orientation;
pub use helps::{Change, ChangeKind, Help, Helps, MovedVertex};
use objective::Order;
pub use objective::{Objective, Weights};
use rounds::Search;
pub(crate) use wire::bend_route;

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
    /// The last word on a wire that meets nothing as far as the search sees: whether every check of it agrees.
    pub accepts: &'a dyn Fn(&Route, &ScheduledProgram) -> bool,
}

/// What is searched for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SearchOptions {
    /// How many steps may be checked for each number of wires.
    pub effort: u64,
    /// Where chance begins.
    pub seed: u64,
    /// How many wires there may be at most.
    pub max_wires: usize,
    /// Which of the programs that meet nothing is the best.
    pub objective: Objective,
}

impl Default for SearchOptions {
    fn default() -> Self {
        Self { effort: 20_000, seed: 1, max_wires: 32, objective: Objective::default() }
    }
}

impl SearchOptions {
    /// How many steps are checked at most, one number of wires after the other; fewer where more wires are of no use.
    #[must_use]
    pub fn most_checks(&self) -> u64 {
        self.effort.saturating_mul(ladder(self.max_wires.max(1)).count() as u64)
    }
}

/// What is walked.
#[derive(Debug, Clone)]
pub struct SearchTask<'a> {
    /// The routes that are there.
    pub routes: &'a [Route],
    /// Which edges are passed once more; none: the cheapest for each number of wires, and where those do not help, dearer ones.
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
    /// What was found, else the routes that were there, bent so that they meet least.
    pub best: Found,
    /// Whether it meets nothing.
    pub is_clear: bool,
    /// How many steps were checked.
    pub checks: u64,
    /// Whether every walk of one wire was tried, with every sign and winding, where more wires were not allowed: the part standing about
    /// the wire in steps of 5.625°.
    pub exhausted: bool,
    /// What was in the way where it came farthest without a contact; none where nothing had to be searched.
    pub obstruction: Option<Obstruction>,
}

/// The best of the wires found so far that meet nothing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BestSoFar {
    /// How many wires.
    pub wires: usize,
    /// The length of the edges that they run along again.
    pub doubled: Length,
}

/// How far a search is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SearchProgress {
    /// How many steps were checked.
    pub checks: u64,
    /// What it ends with if it ends now; none where it has found nothing.
    pub best: Option<BestSoFar>,
}

/// Searches for wires along all edges of a component that meet nothing while they are bent. `should_continue` is told how far it is;
/// the search ends where it says no, with the best that there is. `None`: the routes that are there cannot be bent at all.
pub fn search(
    wireframe: &Wireframe,
    component: &Component,
    bender: &Bender,
    task: &SearchTask,
    options: &SearchOptions,
    should_continue: &mut dyn FnMut(SearchProgress) -> bool,
) -> Option<SearchOutcome> {
    let best_of = |route: &Route| {
        let backwards = (!task.keep_routes && task.start.is_none()).then(|| route.reversed());
        let ways = [Some(route.clone()), backwards].into_iter().flatten();
        let bent = ways.filter_map(|route| bend_route(wireframe, &route, bender, task.keep_routes));
        bent.min_by_key(|found| (found.met, found.nanoseconds))
    };
    let first = Found { wires: task.routes.iter().map(best_of).collect::<Option<_>>()? };
    let is_accepted = |wire: &FoundWire| wire.met == 0 && (bender.accepts)(&wire.route, &wire.scheduled);
    let mut outcome = SearchOutcome {
        is_clear: first.wires.iter().all(is_accepted),
        best: first,
        checks: task.routes.iter().map(|route| route.traversals.len() as u64).sum(),
        exhausted: false,
        obstruction: None,
    };
    if task.keep_routes {
        return Some(outcome);
    }
    let objective = options.objective;
    // What is clear may need fewer wires still; weighed, more may be better, too.
    let most = match (outcome.is_clear && objective == Objective::InOrder, task.closed) {
        (true, _) => task.routes.len().saturating_sub(1),
        (false, true) => 1,
        (false, false) => options.max_wires.max(1),
    };
    let mut attempt = |wires: usize, outcome: &mut SearchOutcome| -> bool {
        let mut search = Search::new((wireframe, component), bender, task, options, wires);
        let order = |found: &Found| objective.order(wireframe, found);
        let (before, known) = (outcome.checks, outcome.is_clear.then(|| order(&outcome.best)));
        let found = search.run(&mut |checks, best| {
            let best = best.into_iter().chain(known).min().map(Order::so_far);
            should_continue(SearchProgress { checks: before + checks, best })
        });
        outcome.checks += search.checks;
        // From a chosen start these are not all walks.
        outcome.exhausted = search.exhausted && most == 1 && task.start.is_none();
        outcome.obstruction = farther(outcome.obstruction, search.obstruction);
        let is_found = found.is_some();
        if let Some(found) = found.filter(|found| !outcome.is_clear || order(found) < order(&outcome.best)) {
            (outcome.best, outcome.is_clear) = (found, true);
        }
        is_found
    };
    let mut too_few = 0;
    for wires in ladder(most) {
        if outcome.is_clear && !objective.may_pay(wires, &objective.order(wireframe, &outcome.best)) {
            break;
        }
        if attempt(wires, &mut outcome) && objective == Objective::InOrder {
            // Fewer than that, down to what was too few.
            while outcome.best.wires.len() > too_few + 1
                && attempt(outcome.best.wires.len() - 1, &mut outcome)
            {}
            break;
        }
        too_few = wires;
    }
    Some(outcome)
}

/// That of two which came farther.
fn farther(one: Option<Obstruction>, other: Option<Obstruction>) -> Option<Obstruction> {
    match (one, other) {
        (Some(one), Some(other)) => Some(if other.share() >= one.share() { other } else { one }),
        (one, other) => one.or(other),
    }
}

/// Numbers of wires to try, in wider and wider steps.
fn ladder(most: usize) -> impl Iterator<Item = usize> {
    let steps = std::iter::successors(Some(1_usize), |&wires| match wires {
        0..4 => Some(wires + 1),
        _ if wires.is_power_of_two() => Some(wires / 2 * 3),
        _ => Some(wires / 3 * 4),
    });
    steps.take_while(move |&wires| wires < most).chain((most > 0).then_some(most))
}

/// How a wire may stand about its own axis: with the first bend at the head's reference, to either side; and where `turned` says so, turned
/// to the sides, too, as far as the head reaches them.
fn orientations(limits: &HeadLimits, turned: bool) -> Vec<Orientation> {
    let aside = [45.0, -45.0, 90.0, -90.0, 135.0, -135.0].into_iter().filter(|_| turned);
    let all = [0.0, 180.0].into_iter().chain(aside).map(Orientation::of_degrees);
    all.filter(|orientation| orientation.is_reached(limits)).collect()
}

/// So many times the steps of 45° are halved.
const HALVINGS: u32 = 3;

/// The positions between those of [`orientations`], in steps of 22.5° first, then of 11.25° and of 5.625°; the nearest to the reference
/// come first.
fn orientations_between(limits: &HeadLimits) -> Vec<Orientation> {
    let halves = (1..=HALVINGS).map(|halving| 45.0 / 2.0_f64.powi(halving.cast_signed()));
    let between = halves.flat_map(|step| {
        let odd = std::iter::successors(Some(step), move |degrees| Some(degrees + 2.0 * step));
        odd.take_while(|&degrees| degrees < 180.0).flat_map(|degrees| [degrees, -degrees])
    });
    between.map(Orientation::of_degrees).filter(|orientation| orientation.is_reached(limits)).collect()
}

#[cfg(test)]
mod tests;
