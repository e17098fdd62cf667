//! Changes with which a search that has found nothing finds wires that meet nothing: each is tried.

use nalgebra::{Point3, Vector3};

use super::PlanObserver;
use super::searching::Searching;
use crate::route::Route;
use crate::search::{Helps, MovedVertex, SearchOptions};
use crate::units::Length;
use crate::wireframe::{EdgeId, Edit, VertexId, Wireframe};

/// How far a vertex is moved, mm: the least that helps is of interest, to a design that is still the same.
const DISTANCES: [f64; 5] = [1.0, 2.0, 5.0, 10.0, 20.0];
/// So many vertices are moved at most, one at a time.
const MOVED: usize = 8;
/// So many times as many wires are tried.
const TIMES_AS_MANY: usize = 4;
/// So much of the effort each trial of a move has, and the trial of more wires. All moves together have as much as the search.
const SHARE_OF_MOVE: u64 = 40;
const SHARE_OF_WIRES: u64 = 4;

impl Searching<'_> {
    /// What helps where nothing was found, by trying. `obstacle`: the vertex whose bend was in the way.
    pub(super) fn helps(
        &self,
        (routes, doubled): (&[Route], &[EdgeId]),
        obstacle: Option<VertexId>,
        options: &SearchOptions,
        observer: &mut impl PlanObserver,
    ) -> Helps {
        let most = options.max_wires.max(1);
        let more = SearchOptions {
            effort: options.effort / SHARE_OF_WIRES,
            max_wires: most * TIMES_AS_MANY,
            ..options.clone()
        };
        let few = SearchOptions {
            effort: (options.effort / SHARE_OF_MOVE).max(1),
            max_wires: most.min(routes.len().max(1)),
            ..options.clone()
        };
        let may_be_more = !self.options.closed && most < SearchOptions::default().max_wires;
        let near = obstacle.map(|obstacle| self.near(obstacle)).unwrap_or_default();
        let moves: Vec<MovedVertex> = DISTANCES
            .into_iter()
            .flat_map(|by| near.iter().flat_map(move |&vertex| moves(self.wireframe, vertex, by)))
            .collect();
        let of_wires = if may_be_more { more.most_checks() } else { 0 };
        let of = of_wires.saturating_add(options.effort);
        let mut looked = 0;
        let mut tried = |searching: &Searching, options: &SearchOptions| -> Option<usize> {
            let before = looked;
            let found =
                searching.look((routes, doubled), options, |checks| observer.trying(before + checks, of))?;
            looked += found.checks;
            found.is_clear.then_some(found.best.wires.len())
        };
        let wires = if may_be_more { tried(self, &more) } else { None };
        let moved = moves.into_iter().find(|moved| {
            let place = Edit::Place { vertex: moved.vertex, position: moved.to };
            let mut wireframe = self.wireframe.clone();
            let is_moved = place.resolve(self.wireframe).is_ok_and(|delta| wireframe.commit(&delta).is_ok());
            is_moved && tried(&Searching { wireframe: &wireframe, ..*self }, &few).is_some()
        });
        Helps { wires, moved }
    }

    /// A vertex and those of its part of the design that are nearest to it, in the order of their distance.
    fn near(&self, id: VertexId) -> Vec<VertexId> {
        let place = |id: VertexId| self.wireframe.vertex(id).map(|vertex| vertex.position);
        let Some(here) = place(id) else { return Vec::new() };
        let far = |id: &VertexId| place(*id).map_or(f64::INFINITY, |there| (there - here).norm());
        let mut near = self.component.vertices.clone();
        near.sort_by(|one, other| far(one).total_cmp(&far(other)));
        near.truncate(MOVED);
        near
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
