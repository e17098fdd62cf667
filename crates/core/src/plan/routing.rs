//! From what was chosen to routes, or to why there is none.

use std::collections::BTreeSet;

use super::{DoublingChoice, Machine, PlanOptions, Stage};
use crate::checks::{Diagnostic, Fact, Location, Remedy, Severity, check_odd};
use crate::route::{
    Doubling, ForcedBend, Route, RouteError, RouteOptions, Routes, StartThere, Traversal, doubling,
    doublings, forced_bends, routes,
};
use crate::units::{Angle, Length};
use crate::wireframe::{Component, EdgeId, VertexId, Wireframe};

/// Starts at forced bends are tried where they take no more than so many edges in all: each takes a doubling of the whole wire.
const MAX_EDGES_OF_STARTS: usize = 20_000;

/// What arithmetic may add to a bend.
const ROUNDING_DEG: f64 = 1e-6;

/// The routes of a component, and what the checks need to know of the search for them.
pub(super) struct Routed {
    /// Edges that are travelled twice.
    pub doubled: Vec<EdgeId>,
    /// The cheapest doubling for what was chosen.
    pub proposal: Doubling,
    /// One for each wire; none where none is possible.
    pub routes: Vec<Route>,
    /// Bends beyond the limit that no route avoids; without a route none with the proposed doubling.
    pub forced: Vec<ForcedBend>,
    /// Why there is no route, where it is not for odd vertices.
    pub refusals: Vec<Diagnostic>,
}

/// Why no wires can run along a component, whichever machine bends them: what is chosen leaves too many odd vertices, or cannot be.
#[must_use]
pub fn check_walks(wireframe: &Wireframe, component: &Component, options: &PlanOptions) -> Vec<Diagnostic> {
    let Routed { doubled, proposal, refusals, .. } = find(wireframe, component, None, options, &mut |_| ());
    let proposal = Some(&proposal).filter(|proposal| !proposal.edges.is_empty());
    let odd = check_odd(wireframe, component, &doubled, allowed(options), proposal);
    odd.into_iter().chain(refusals).collect()
}

/// Finds the routes of a component. `max_bend`: the largest bend of the machine; none where any will do.
pub(super) fn find(
    wireframe: &Wireframe,
    component: &Component,
    max_bend: Option<Angle>,
    options: &PlanOptions,
    done: &mut dyn FnMut(Stage),
) -> Routed {
    let proposed = proposal(wireframe, component, options);
    let mut found = Routed {
        doubled: Vec::new(),
        proposal: Doubling::default(),
        routes: Vec::new(),
        forced: Vec::new(),
        refusals: Vec::new(),
    };
    match proposed {
        Ok(proposal) => found.proposal = proposal,
        Err(error) => found.refusals.push(refusal(error, None)),
    }
    found.doubled = match &options.doubling {
        _ if !options.settled.is_empty() => repeated(&options.settled),
        DoublingChoice::Accepted(edges) => edges.clone(),
        DoublingChoice::Cheapest => found.proposal.edges.clone(),
    };
    done(Stage::Doubling);
    if found.refusals.is_empty() {
        search(wireframe, component, options, max_bend, &mut found);
    }
    done(Stage::Route);
    found
}

fn search(
    wireframe: &Wireframe,
    component: &Component,
    options: &PlanOptions,
    max_bend: Option<Angle>,
    found: &mut Routed,
) {
    let mut wanted = RouteOptions {
        doubled: found.doubled.clone(),
        start: options.start,
        wires: options.wires,
        closed: options.closed,
        max_bend,
    };
    if options.detours && options.settled.is_empty() {
        wanted.doubled.extend(detours(wireframe, component, &wanted));
        found.doubled.clone_from(&wanted.doubled);
    }
    match find_routes(wireframe, component, &wanted, options) {
        Ok(Routes { routes, forced }) => {
            (found.routes, found.forced) = (routes, forced);
            try_starts(wireframe, component, options, &wanted, found);
        }
        // The check of odd vertices says it with the cheapest way out; what is in the way of that, a bend or too many edge ends, is said, too.
        Err(RouteError::Odd { .. }) => {
            let proposed = RouteOptions { doubled: found.proposal.edges.clone(), ..wanted };
            match forced_bends(wireframe, component, &proposed) {
                Ok(forced) => found.forced = forced,
                Err(RouteError::Odd { .. }) => {}
                Err(error) => found.refusals.push(refusal(error, None)),
            }
            try_starts(wireframe, component, options, &proposed, found);
        }
        Err(error) => {
            let offered = Some(&found.proposal).filter(|proposal| !proposal.edges.is_empty());
            let doubling = offered.map(|proposal| Remedy::double(proposal, wireframe));
            found.refusals.push(refusal(error, doubling));
        }
    }
}

/// Tries to start the wire at the vertex of each forced bend, where the start is open and no edges beyond the cheapest are doubled.
fn try_starts(
    wireframe: &Wireframe,
    component: &Component,
    options: &PlanOptions,
    now: &RouteOptions,
    Routed { proposal, forced, routes: found, .. }: &mut Routed,
) {
    if options.closed {
        for bend in &mut *forced {
            bend.start = StartThere::HelpsNot;
        }
    }
    let length = |edges: &[EdgeId]| edges.iter().map(|&edge| wireframe.edge_length(edge)).sum::<Length>();
    let now_added = length(&now.doubled);
    let is_open = options.start.is_none() && !options.closed && options.wires < 2 && !options.detours;
    if !is_open
        || forced.is_empty()
        || !options.settled.is_empty()
        || !proposal.is_matched_by(now_added)
        || forced.len() * component.edges.len() > MAX_EDGES_OF_STARTS
    {
        return;
    }
    let sharp = |routes: &[Route]| -> Vec<VertexId> {
        routes.iter().flat_map(|route| sharp_vertices(wireframe, route, now.max_bend)).collect()
    };
    let sharp_of = |options: &RouteOptions| Some(sharp(&routes(wireframe, component, options).ok()?.routes));
    let known = (!found.is_empty()).then(|| sharp(found));
    let Some(sharp_now) = known.or_else(|| sharp_of(now)) else { return };
    for bend in forced {
        let start = Some(bend.vertex);
        let Ok(Doubling { edges: doubled, added }) = doubling(wireframe, component, start, false) else {
            continue;
        };
        let there = RouteOptions { doubled, start, ..now.clone() };
        let Some(sharp_there) = sharp_of(&there) else { continue };
        // Elsewhere there may be bends and folds that there are not now.
        let helps = sharp_there.len() < sharp_now.len() && !sharp_there.contains(&bend.vertex);
        bend.start = if helps { StartThere::Adds(added - now_added) } else { StartThere::HelpsNot };
    }
}

/// The vertices at which a wire is bent by more than the machine can, or back along itself.
fn sharp_vertices(wireframe: &Wireframe, route: &Route, max_bend: Option<Angle>) -> Vec<VertexId> {
    let along = |traversal: &Traversal| wireframe.direction(traversal.edge, traversal.from);
    let bend = |pair: &[Traversal]| Some(along(&pair[0])?.angle(&along(&pair[1])?).to_degrees());
    let is_sharp = |pair: &&[Traversal]| {
        max_bend.zip(bend(pair)).is_some_and(|(most, bend)| bend > most.deg() + ROUNDING_DEG)
    };
    route.traversals.windows(2).filter(is_sharp).map(|pair| pair[0].to).collect()
}

/// The cheapest doubling for what was chosen.
pub(super) fn proposal(
    wireframe: &Wireframe,
    component: &Component,
    options: &PlanOptions,
) -> Result<Doubling, RouteError> {
    if !options.settled.is_empty() {
        return Ok(Doubling::default());
    }
    if options.closed || options.wires < 2 {
        return doubling(wireframe, component, options.start, options.closed);
    }
    let mut found = doublings(wireframe, component, options.start, options.wires)?;
    Ok(found.pop().unwrap_or_default())
}

/// How many vertices may be odd.
pub(super) const fn allowed(options: &PlanOptions) -> usize {
    if !options.settled.is_empty() {
        2 * options.settled.len()
    } else if options.closed {
        0
    } else {
        2 * options.wires
    }
}

/// The largest bend that the machine makes of this wire, to whichever side.
pub(super) fn largest_bend(machine: &Machine) -> Angle {
    let limits = &machine.limits;
    let to = |limit: Angle| limit.abs().min(machine.compensation.bend.max_bend(limit));
    to(limits.max_bend.value).max(to(limits.min_bend.value))
}

/// The edges of detours around all bends beyond the limit that have one.
fn detours(wireframe: &Wireframe, component: &Component, wanted: &RouteOptions) -> Vec<EdgeId> {
    // Without a route there is nothing to go around; the search for one says why.
    let forced = forced_bends(wireframe, component, wanted).unwrap_or_default();
    forced.into_iter().filter_map(|bend| bend.detour).flat_map(|detour| detour.edges).collect()
}

/// The edges that wires together pass more than once, as often as beyond the first time.
pub(super) fn repeated(routes: &[Route]) -> Vec<EdgeId> {
    let mut passed = BTreeSet::new();
    let all = routes.iter().flat_map(|route| &route.traversals);
    all.filter(|traversal| !passed.insert(traversal.edge)).map(|traversal| traversal.edge).collect()
}

/// The edges that a walk passes once more.
pub(super) fn again(walk: &Route) -> Vec<EdgeId> {
    let traversals = walk.traversals.iter();
    traversals.filter(|traversal| traversal.again).map(|traversal| traversal.edge).collect()
}

fn find_routes(
    wireframe: &Wireframe,
    component: &Component,
    wanted: &RouteOptions,
    options: &PlanOptions,
) -> Result<Routes, RouteError> {
    let mut found = if options.settled.is_empty() {
        routes(wireframe, component, wanted)?
    } else {
        Routes { routes: options.settled.clone(), forced: Vec::new() }
    };
    if options.reversed {
        found.routes = found.routes.iter().map(Route::reversed).collect();
    }
    Ok(found)
}

/// The finding of a route that cannot be had.
fn refusal(error: RouteError, doubling: Option<Remedy>) -> Diagnostic {
    let location = match &error {
        RouteError::Start { start, .. } | RouteError::StartElsewhere(start) => {
            Location::at_vertices([*start])
        }
        RouteError::DoubledElsewhere(edge) => Location::at_edges([*edge]),
        RouteError::Odd { odd, .. } => Location::at_vertices(odd.iter().copied()),
        RouteError::NoEdges | RouteError::TooLong => Location::default(),
        RouteError::TooManyEnds { vertex, .. } => Location::at_vertices([*vertex]),
    };
    let mut remedies = match error {
        RouteError::TooLong | RouteError::TooManyEnds { .. } => vec![Remedy::SplitDesign],
        RouteError::NoEdges => vec![Remedy::DrawEdges],
        RouteError::Start { .. }
        | RouteError::StartElsewhere(_)
        | RouteError::DoubledElsewhere(_)
        | RouteError::Odd { .. } => vec![Remedy::ChooseStart, Remedy::LeaveStartOpen],
    };
    // A start that no walk has is possible once the proposed edges are doubled.
    remedies.extend(doubling.filter(|_| matches!(error, RouteError::Start { .. })));
    Diagnostic { severity: Severity::Error, location, fact: Fact::RouteRefused(error), remedies }
}
