//! Changes with which a search that has found nothing finds wires that meet nothing: each is tried.

use nalgebra::{Point3, Vector3};

use super::PlanObserver;
use super::searching::{Doubled, Searching};
use crate::route::Route;
use crate::search::{Change, ChangeKind, Help, Helps, MovedVertex, SearchOptions};
use crate::units::Length;
use crate::wireframe::{EdgeId, Edit, VertexId, Wireframe};

/// How far a vertex is moved, mm: the least that helps is of interest, to a design that is still the same.
const DISTANCES: [f64; 5] = [1.0, 2.0, 5.0, 10.0, 20.0];
/// So many vertices are moved at most, one at a time.
const MOVED: usize = 8;
/// So many edges are run along twice at most, one at a time: together they have as much of the effort as the search.
const DOUBLED: usize = 40;
/// So many times as many wires are tried.
const TIMES_AS_MANY: usize = 4;
/// So much of the effort each trial of a move or of an edge has, and the trial of more wires.
const SHARE_OF_ONE: u64 = 40;
const SHARE_OF_WIRES: u64 = 4;

/// Looks with one change after the other until a person has had enough.
struct Trials<'a> {
    routes: &'a [Route],
    observer: &'a mut dyn PlanObserver,
    /// How many steps were checked, and how many may be.
    looked: u64,
    of: u64,
    ended: bool,
}

impl Trials<'_> {
    /// The walks that meet nothing, if some are found.
    fn look(
        &mut self,
        searching: &Searching,
        doubled: Doubled,
        options: &SearchOptions,
    ) -> Option<Vec<Route>> {
        if self.ended {
            return None;
        }
        let (before, of, observer, ended) = (self.looked, self.of, &mut *self.observer, &mut self.ended);
        let found = searching.look(self.routes, doubled, options, &mut |progress| {
            *ended |= !observer.trying((before + progress.checks).min(of), of);
            !*ended
        })?;
        self.looked += found.checks;
        found.is_clear.then(|| found.best.wires.into_iter().map(|wire| wire.route).collect())
    }
}

impl Searching<'_> {
    /// What helps where nothing was found, by trying. `obstacle`: the vertex whose bend was in the way.
    pub(super) fn helps(
        &self,
        (routes, doubled): (&[Route], &[EdgeId]),
        obstacle: Option<VertexId>,
        options: &SearchOptions,
        observer: &mut dyn PlanObserver,
    ) -> Helps {
        let most = options.max_wires.max(1);
        let more = SearchOptions {
            effort: options.effort / SHARE_OF_WIRES,
            max_wires: most * TIMES_AS_MANY,
            ..options.clone()
        };
        let few = SearchOptions {
            effort: (options.effort / SHARE_OF_ONE).max(1),
            max_wires: most.min(routes.len().max(1)),
            ..options.clone()
        };
        let as_it_is = Doubled { edges: doubled, is_free: self.is_free() };
        let may_be_more = !self.options.closed && most < SearchOptions::default().max_wires;
        let twice = self.once_more(doubled, few.max_wires);
        let near = obstacle.map(|obstacle| self.near(obstacle)).unwrap_or_default();
        let moves: Vec<MovedVertex> = DISTANCES
            .into_iter()
            .flat_map(|by| near.iter().flat_map(move |&vertex| moves(self.wireframe, vertex, by)))
            .collect();
        let of_wires = if may_be_more { more.most_checks() } else { 0 };
        let of_each = few.most_checks().saturating_mul((twice.len() + moves.len()) as u64);
        let of = of_wires.saturating_add(of_each);
        let mut trials = Trials { routes, observer, looked: 0, of, ended: false };
        let mut helps = Helps::default();

        if may_be_more {
            let found = trials.look(self, as_it_is, &more);
            helps.take(ChangeKind::MoreWires, found.map(|routes| (Change::MoreWires, routes)), trials.ended);
        }
        if !twice.is_empty() {
            let found = twice.into_iter().find_map(|edge| {
                let edges: Vec<EdgeId> = doubled.iter().copied().chain([edge]).collect();
                let routes = trials.look(self, Doubled { edges: &edges, is_free: false }, &few)?;
                let added = self.wireframe.edge_length(edge);
                Some((Change::Doubled { edges: vec![edge], added }, routes))
            });
            helps.take(ChangeKind::Doubled, found, trials.ended);
        }
        if !moves.is_empty() {
            let found = moves.into_iter().find_map(|moved| {
                let place = Edit::Place { vertex: moved.vertex, position: moved.to };
                let mut wireframe = self.wireframe.clone();
                wireframe.commit(&place.resolve(self.wireframe).ok()?).ok()?;
                let elsewhere = Searching { wireframe: &wireframe, ..*self };
                Some((Change::Moved(moved), trials.look(&elsewhere, as_it_is, &few)?))
            });
            helps.take(ChangeKind::Moved, found, trials.ended);
        }
        helps.ended = trials.ended;
        helps
    }

    /// Edges that can be run along once more than those that are, the shortest first: so many wires pass all of them then.
    fn once_more(&self, doubled: &[EdgeId], wires: usize) -> Vec<EdgeId> {
        let ends = if self.options.closed { 0 } else { 2 * wires };
        let can_be = |edge: &EdgeId| {
            let all: Vec<EdgeId> = doubled.iter().copied().chain([*edge]).collect();
            !doubled.contains(edge) && self.wireframe.odd_vertices(self.component, &all).len() <= ends
        };
        let mut edges: Vec<EdgeId> = self.component.edges.iter().copied().filter(can_be).collect();
        edges.sort_by(|&one, &other| {
            self.wireframe.edge_length(one).mm().total_cmp(&self.wireframe.edge_length(other).mm())
        });
        edges.truncate(DOUBLED);
        edges
    }

    /// A vertex and those of its part of the design that are nearest to it, in the order of their distance. What the design holds fixed is
    /// not moved.
    fn near(&self, id: VertexId) -> Vec<VertexId> {
        let place = |id: VertexId| self.wireframe.vertex(id).map(|vertex| vertex.position);
        let Some(here) = place(id) else { return Vec::new() };
        let far = |id: &VertexId| place(*id).map_or(f64::INFINITY, |there| (there - here).norm());
        let mut near = self.component.vertices.clone();
        near.retain(|&id| self.wireframe.vertex(id).is_some_and(|vertex| !vertex.support));
        near.sort_by(|one, other| far(one).total_cmp(&far(other)));
        near.truncate(MOVED);
        near
    }
}

impl Helps {
    /// Notes what came of the trials of a kind; of those that a person has ended that nothing was found says nothing.
    fn take(&mut self, kind: ChangeKind, found: Option<(Change, Vec<Route>)>, ended: bool) {
        if found.is_some() || !ended {
            self.tried.push(kind);
        }
        self.found.extend(found.map(|(change, routes)| Help { change, routes }));
    }
}

/// Moves of a vertex by so many mm: along the axes, and to and from where its neighbours are.
fn moves(wireframe: &Wireframe, id: VertexId, by: f64) -> impl Iterator<Item = MovedVertex> {
    let at = wireframe.vertex(id).map_or_else(Point3::origin, |vertex| vertex.position);
    let neighbours = wireframe.incident(id).into_iter().filter_map(|edge| {
        let edge = wireframe.edge(edge)?;
        Some(wireframe.vertex(if edge.a == id { edge.b } else { edge.a })?.position - at)
    });
    let towards = neighbours.sum::<Vector3<f64>>().try_normalize(1e-9);
    let ways = [Vector3::x(), Vector3::y(), Vector3::z()].into_iter().chain(towards);
    ways.flat_map(|way| [way, -way]).map(move |way| MovedVertex {
        vertex: id,
        to: at + way * by,
        by: Length::computed(by),
    })
}
