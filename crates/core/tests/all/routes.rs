//! Routes: every edge is used, no cheaper doubling exists, and the wire does not fold back without need.

use std::collections::BTreeMap;

use nalgebra::Point3;
use proptest::prelude::*;
use wirebend_core::route::{
    Route, RouteError, RouteOptions, doubling, doublings, forced_bends, route, routes,
};
use wirebend_core::units::{Angle, Length};
use wirebend_core::wireframe::{Component, EdgeId, Vertex, VertexId, Wireframe};

fn wireframe(points: &[[f64; 3]], edges: &[(usize, usize)]) -> Wireframe {
    let mut w = Wireframe::new();
    let ids: Vec<VertexId> =
        points.iter().map(|&p| w.add_vertex(Vertex::at(Point3::from(p))).unwrap()).collect();
    for &(a, b) in edges {
        w.add_edge(ids[a], ids[b]).unwrap();
    }
    w
}

fn cube() -> Wireframe {
    let corner = |k: usize| [k & 1, k >> 1 & 1, k >> 2 & 1].map(|bit| if bit == 1 { 30.0 } else { 0.0 });
    let points: Vec<_> = (0..8).map(corner).collect();
    let edges: Vec<_> =
        (0..8_usize).flat_map(|a| [1, 2, 4].map(|bit| (a, a | bit))).filter(|(a, b)| a != b).collect();
    wireframe(&points, &edges)
}

/// A route uses each edge as often as it is asked for, in one unbroken walk.
fn assert_covers(w: &Wireframe, component: &Component, found: &Route, doubled: &[EdgeId]) {
    assert_all_cover(w, component, std::slice::from_ref(found), doubled);
}

/// Routes use each edge together as often as they are asked for, each in one unbroken walk.
fn assert_all_cover(w: &Wireframe, component: &Component, found: &[Route], doubled: &[EdgeId]) {
    let mut wanted: BTreeMap<EdgeId, usize> = BTreeMap::new();
    for &edge in component.edges.iter().chain(doubled) {
        *wanted.entry(edge).or_default() += 1;
    }
    let mut used: BTreeMap<EdgeId, usize> = BTreeMap::new();
    for route in found {
        let mut passed: BTreeMap<EdgeId, usize> = BTreeMap::new();
        for t in &route.traversals {
            let pass = passed.entry(t.edge).or_default();
            *pass += 1;
            assert_eq!(t.again, *pass > 1);
            let edge = w.edge(t.edge).unwrap();
            assert!((edge.a, edge.b) == (t.from, t.to) || (edge.b, edge.a) == (t.from, t.to));
        }
        for (edge, passes) in passed {
            *used.entry(edge).or_default() += passes;
        }
        assert!(route.traversals.windows(2).all(|pair| pair[0].to == pair[1].from));
    }
    assert_eq!(used, wanted);
}

/// How many bends of a route are beyond a limit, at each vertex that has one.
fn bends_beyond(w: &Wireframe, found: &Route, limit: Angle) -> BTreeMap<VertexId, usize> {
    let mut beyond = BTreeMap::new();
    for pair in found.traversals.windows(2) {
        let (one, next) = (w.direction(pair[0].edge, pair[0].from), w.direction(pair[1].edge, pair[1].from));
        if one.unwrap().angle(&next.unwrap()).to_degrees() > limit.deg() + 1e-6 {
            *beyond.entry(pair[0].to).or_default() += 1;
        }
    }
    beyond
}

fn fold_backs(found: &Route) -> usize {
    found.traversals.windows(2).filter(|pair| pair[0].edge == pair[1].edge).count()
}

#[test]
fn a_cube_needs_three_doubled_edges_and_no_fold_back() {
    let w = cube();
    let component = w.components().remove(0);
    let odd = w.odd_vertices(&component, &[]);
    let none = RouteOptions::default();
    assert_eq!(route(&w, &component, &none), Err(RouteError::Odd { odd, allowed: 2 }));
    let open = doubling(&w, &component, None, false).unwrap();
    assert_eq!((open.edges.len(), open.added.mm()), (3, 90.0));
    let closed = doubling(&w, &component, None, true).unwrap();
    assert_eq!((closed.edges.len(), closed.added.mm()), (4, 120.0));
    for (doubled, closed) in [(open.edges, false), (closed.edges, true)] {
        let options = RouteOptions { doubled: doubled.clone(), closed, ..RouteOptions::default() };
        let found = route(&w, &component, &options).unwrap();
        assert_covers(&w, &component, &found, &doubled);
        assert_eq!(fold_backs(&found), 0);
        assert_eq!(found.vertices().first() == found.vertices().last(), closed);
        assert_eq!(route(&w, &component, &options).unwrap(), found, "the same on every run");
    }
}

#[test]
fn a_person_chooses_where_the_wire_starts() {
    let w = cube();
    let component = w.components().remove(0);
    for start in component.vertices.clone() {
        let doubled = doubling(&w, &component, Some(start), false).unwrap().edges;
        let options = RouteOptions { doubled, start: Some(start), ..RouteOptions::default() };
        let found = route(&w, &component, &options).unwrap();
        assert_eq!(found.vertices()[0], start);
        assert_eq!(found.reversed().vertices().last(), Some(&start));
        assert_covers(&w, &component, &found.reversed(), &options.doubled);
    }
}

#[test]
fn starts_and_doublings_that_do_not_fit_are_refused_by_name() {
    let w = wireframe(
        &[[0.; 3], [9., 0., 0.], [9., 9., 0.], [50., 0., 0.], [60., 0., 0.]],
        &[(0, 1), (1, 2), (3, 4)],
    );
    let component = w.components().remove(0);
    let start = |v| RouteOptions { start: Some(VertexId(v)), ..RouteOptions::default() };
    assert_eq!(
        route(&w, &component, &start(1)),
        Err(RouteError::Start { start: VertexId(1), ends: vec![VertexId(0), VertexId(2)] })
    );
    assert_eq!(route(&w, &component, &start(3)), Err(RouteError::StartElsewhere(VertexId(3))));
    let other = RouteOptions { doubled: vec![EdgeId(2)], ..RouteOptions::default() };
    assert_eq!(route(&w, &component, &other), Err(RouteError::DoubledElsewhere(EdgeId(2))));
    assert_eq!(route(&w, &Component::default(), &RouteOptions::default()), Err(RouteError::NoEdges));
}

#[test]
fn a_dead_end_is_the_only_place_where_the_wire_folds_back() {
    // A square with a tail at two of its corners: closed, both tails are gone along twice.
    let square =
        [[0., 0., 0.], [30., 0., 0.], [30., 30., 0.], [0., 30., 0.], [-30., -30., 0.], [60., 60., 0.]];
    let w = wireframe(&square, &[(0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (2, 5)]);
    let component = w.components().remove(0);
    let doubled = doubling(&w, &component, None, true).unwrap().edges;
    assert_eq!(doubled, [EdgeId(4), EdgeId(5)]);
    let options = RouteOptions { doubled, closed: true, ..RouteOptions::default() };
    let found = route(&w, &component, &options).unwrap();
    // One of the two is where the wire begins and ends.
    assert_eq!(fold_backs(&found), 1);
}

#[test]
fn sharp_bends_are_avoided_where_the_edges_can_be_paired_otherwise() {
    // Two long thin loops through one vertex: crossing over bends by 20°, turning round by 160°.
    let far = |deg: f64| [100.0 * deg.to_radians().cos(), 100.0 * deg.to_radians().sin(), 0.0];
    let w = wireframe(
        &[[0.; 3], far(-10.0), far(10.0), far(170.0), far(190.0)],
        &[(0, 1), (1, 2), (2, 0), (0, 3), (3, 4), (4, 0)],
    );
    let component = w.components().remove(0);
    let limit = Some(Angle::from_deg(155.0).unwrap());
    let found = route(&w, &component, &RouteOptions { max_bend: limit, ..RouteOptions::default() }).unwrap();
    for pair in found.traversals.windows(2) {
        let (one, next) = (w.direction(pair[0].edge, pair[0].from), w.direction(pair[1].edge, pair[1].from));
        assert!(one.unwrap().angle(&next.unwrap()).to_degrees() < 155.0);
    }
}

/// A program settles the walk: along an edge twice where it goes back.
#[test]
fn a_walk_through_vertices_is_a_route() {
    let w = wireframe(&[[0.; 3], [10., 0., 0.], [10., 10., 0.], [0., 10., 0.]], &[(0, 1), (1, 2), (2, 0)]);
    let walk = [0, 1, 2, 0, 1].map(VertexId);
    let found = Route::through(&w, &walk).unwrap();
    assert_eq!(found.vertices(), walk);
    assert_eq!(found.traversals.iter().map(|t| t.again).collect::<Vec<_>>(), [false, false, false, true]);
    assert_covers(&w, &w.components()[0], &found, &[found.traversals[3].edge]);
    assert_eq!(Route::through(&w, &[VertexId(0), VertexId(3)]), None, "no edge joins them");
}

/// A wheel of triangles, at whose hub so many edges meet: evenly around it, so that each has one straight on.
fn wheel(spokes: usize) -> Wireframe {
    let rim = |k: usize| {
        let part = |k: usize| f64::from(u32::try_from(k).unwrap());
        let turn = part(k) / part(spokes) * std::f64::consts::TAU;
        [100.0 * turn.cos(), 100.0 * turn.sin(), 0.0]
    };
    let points: Vec<_> = std::iter::once([0.0; 3]).chain((0..spokes).map(rim)).collect();
    let triangles = (0..spokes / 2).flat_map(|k| [(0, 2 * k + 1), (2 * k + 1, 2 * k + 2), (2 * k + 2, 0)]);
    wireframe(&points, &triangles.collect::<Vec<_>>())
}

#[test]
fn a_hub_with_hundreds_of_edges_is_passed_almost_straight_on() {
    let w = wheel(500);
    let component = &w.components()[0];
    let found = route(&w, component, &RouteOptions::default()).unwrap();
    assert_covers(&w, component, &found, &[]);
    let vertices = found.vertices();
    let position = |vertex: VertexId| w.vertex(vertex).unwrap().position;
    let bends = vertices.windows(3).filter(|three| three[1] == VertexId(0)).map(|three| {
        let [from, at, to] = [three[0], three[1], three[2]].map(position);
        (at - from).angle(&(to - at)).to_degrees()
    });
    let bends: Vec<f64> = bends.collect();
    // Straight on closes many trails; where they are joined, each end goes on to a neighbour of the one that is opposite.
    let sharpest = bends.iter().copied().fold(0.0, f64::max);
    assert!(
        bends.len() >= 249 && sharpest < 2.0 * 360.0 / 500.0 + 1e-6,
        "{} bends up to {sharpest}",
        bends.len()
    );
}

#[test]
fn a_hub_with_more_edges_than_can_be_paired_is_refused() {
    let w = wheel(502);
    let refused = route(&w, &w.components()[0], &RouteOptions::default());
    assert_eq!(refused, Err(RouteError::TooManyEnds { vertex: VertexId(0), ends: 502, max: 500 }));
}

/// Connected graphs with a few vertices, some edges parallel.
fn any_wireframe(max_edges: usize) -> impl Strategy<Value = Wireframe> {
    let points = prop::collection::vec(prop::array::uniform3(-100.0..100.0_f64), 2..9);
    let extra = prop::collection::vec((0..100_usize, 0..100_usize), 0..max_edges);
    (points, extra, prop::collection::vec(0..100_usize, 8)).prop_map(|(points, extra, tree)| {
        let n = points.len();
        let mut edges: Vec<_> = (1..n).map(|k| (tree[k - 1] % k, k)).collect();
        edges.extend(extra.into_iter().map(|(a, b)| (a % n, b % n)).filter(|(a, b)| a != b));
        wireframe(&points, &edges)
    })
}

/// The least length of edges that leaves no more than `allowed` odd vertices, over all subsets.
fn min_by_trying(w: &Wireframe, component: &Component, allowed: usize, start: Option<VertexId>) -> f64 {
    let mut min = f64::INFINITY;
    for subset in 0..1_u32 << component.edges.len() {
        let chosen: Vec<EdgeId> =
            (0..component.edges.len()).filter(|k| subset >> k & 1 == 1).map(|k| component.edges[k]).collect();
        let odd = w.odd_vertices(component, &chosen);
        let closes = odd.is_empty() || odd.len() + 2 <= allowed;
        let starts = start.is_none_or(|start| closes || odd.contains(&start));
        if odd.len() <= allowed && starts {
            min = min.min(chosen.iter().map(|&e| w.edge_length(e).mm()).sum());
        }
    }
    min
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(120))]

    #[test]
    fn no_doubling_is_shorter(w in any_wireframe(5), closed: bool, start in prop::option::of(0..8_u32)) {
        let component = w.components().remove(0);
        let start = start.map(VertexId).filter(|v| component.vertices.contains(v));
        let found = doubling(&w, &component, start, closed).unwrap();
        let min = min_by_trying(&w, &component, if closed { 0 } else { 2 }, start.filter(|_| !closed));
        prop_assert!((found.added.mm() - min).abs() < 1e-4, "{} for {min}", found.added.mm());
    }

    #[test]
    fn a_route_covers_every_edge_and_folds_back_only_at_dead_ends(
        w in any_wireframe(14), closed: bool, start in prop::option::of(0..8_u32), limit in 60.0..180.0_f64,
    ) {
        let component = w.components().remove(0);
        let start = start.map(VertexId).filter(|v| component.vertices.contains(v));
        let doubled = doubling(&w, &component, start, closed).unwrap().edges;
        let max_bend = Some(Angle::from_deg(limit).unwrap());
        let options = RouteOptions { doubled: doubled.clone(), start, closed, max_bend, ..RouteOptions::default() };
        let found = route(&w, &component, &options).unwrap();
        assert_covers(&w, &component, &found, &doubled);
        prop_assert!(start.is_none() || found.vertices().first().copied() == start);
        for pair in found.traversals.windows(2).filter(|pair| pair[0].edge == pair[1].edge) {
            prop_assert_eq!(w.incident(pair[0].to).len(), 1, "folded back where other edges meet");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// Each further wire leaves two more vertices odd; it never adds more than the one before it saved.
    #[test]
    fn several_wires_share_all_edges(w in any_wireframe(8), wires in 1..5_usize, start in prop::option::of(0..8_u32)) {
        let component = w.components().remove(0);
        let start = start.map(VertexId).filter(|v| component.vertices.contains(v));
        let found = doublings(&w, &component, start, wires).unwrap();
        prop_assert!((1..=wires).contains(&found.len()));
        prop_assert_eq!(found[0].added, doubling(&w, &component, start, false).unwrap().added);
        let saved: Vec<f64> = found.windows(2).map(|pair| pair[0].added.mm() - pair[1].added.mm()).collect();
        prop_assert!(saved.iter().all(|&saved| saved > -1e-6));
        prop_assert!(saved.windows(2).all(|pair| pair[1] <= pair[0] + 1e-4), "{saved:?}");
        if component.edges.len() <= 11 {
            for (k, doubling) in found.iter().enumerate() {
                let min = min_by_trying(&w, &component, 2 * k + 2, start);
                prop_assert!((doubling.added.mm() - min).abs() < 1e-4, "{} for {min}", doubling.added.mm());
            }
        }
        let doubled = found.last().unwrap().edges.clone();
        let options = RouteOptions { doubled: doubled.clone(), start, wires, ..RouteOptions::default() };
        let routes = routes(&w, &component, &options).unwrap().routes;
        assert_all_cover(&w, &component, &routes, &doubled);
        let odd = w.odd_vertices(&component, &doubled);
        let starts_anew = odd.is_empty() || start.is_some_and(|start| !odd.contains(&start));
        prop_assert_eq!(routes.len(), odd.len() / 2 + usize::from(starts_anew));
        prop_assert!(start.is_none() || routes[0].vertices().first().copied() == start);
    }

    /// What is called forced is beyond the limit on every route that is found; the detours leave nothing forced but what has none.
    #[test]
    fn detours_lead_around_forced_bends(
        w in any_wireframe(12), limit in 60.0..170.0_f64, closed: bool, start in prop::option::of(0..8_u32),
    ) {
        let component = w.components().remove(0);
        let start = start.map(VertexId).filter(|v| component.vertices.contains(v));
        let doubled = doubling(&w, &component, start, closed).unwrap().edges;
        let limit = Angle::from_deg(limit).unwrap();
        let mut options = RouteOptions { doubled, start, closed, max_bend: Some(limit), ..RouteOptions::default() };
        let forced = forced_bends(&w, &component, &options).unwrap();
        let found = routes(&w, &component, &options).unwrap();
        prop_assert_eq!(&found.forced, &forced);
        let beyond = bends_beyond(&w, &found.routes[0], limit);
        for bend in &forced {
            prop_assert!(bend.bend > limit);
            // The ends of a closed wire may lie at one of several.
            prop_assert!(beyond.contains_key(&bend.vertex) || w.odd_vertices(&component, &options.doubled).is_empty());
        }
        options.doubled.extend(forced.iter().filter_map(|bend| bend.detour.clone()).flat_map(|detour| detour.edges));
        let around = route(&w, &component, &options).unwrap();
        assert_covers(&w, &component, &around, &options.doubled);
        let without: Vec<VertexId> = forced.iter().filter(|bend| bend.detour.is_none()).map(|bend| bend.vertex).collect();
        for left in forced_bends(&w, &component, &options).unwrap() {
            prop_assert!(without.contains(&left.vertex), "{left:?}");
        }
    }
}

/// Far more odd vertices than any dense matching is done with.
#[test]
fn thousands_of_odd_vertices_are_joined_by_the_shortest_length() {
    // A ladder with cells of 10 mm: every vertex but its four corners has three edges.
    let side = 3001;
    let at = |row: usize, column: usize| row * side + column;
    let (mut points, mut edges) = (Vec::new(), Vec::new());
    for row in 0..2 {
        for column in 0..side {
            points.push([f64::from(u32::try_from(column).unwrap()) * 10.0, f64::from(row) * 10.0, 0.0]);
        }
    }
    for column in 0..side {
        edges.push((at(0, column), at(1, column)));
        if column + 1 < side {
            edges.push((at(0, column), at(0, column + 1)));
            edges.push((at(1, column), at(1, column + 1)));
        }
    }
    let w = wireframe(&points, &edges);
    let component = w.components().remove(0);
    let closed = doubling(&w, &component, None, true).unwrap();
    // Each rung but the first and the last once more, or as much along the sides.
    assert_eq!(closed.added, Length::from_mm(10.0 * 2999.0).unwrap());
    let open = doubling(&w, &component, None, false).unwrap();
    assert_eq!(open.added, Length::from_mm(10.0 * 2998.0).unwrap());
    let options = RouteOptions { doubled: open.edges, ..RouteOptions::default() };
    assert_eq!(route(&w, &component, &options).unwrap().traversals.len(), edges.len() + 2998);
}
