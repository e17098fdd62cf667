//! Edits of edges that belong together: detached, straightened, rounded.

use std::collections::BTreeSet;

use nalgebra::Point3;
use proptest::prelude::*;
use wirebend_core::units::{Angle, Length};
use wirebend_core::wireframe::{EdgeId, Edit, EditError, Vertex, VertexId, Wireframe};

fn mm(value: f64) -> Length {
    Length::from_mm(value).unwrap()
}

fn wireframe(points: &[[f64; 3]], edges: &[(u32, u32)]) -> Wireframe {
    let mut w = Wireframe::new();
    for &point in points {
        w.add_vertex(Vertex::at(Point3::from(point))).unwrap();
    }
    for &(a, b) in edges {
        w.add_edge(VertexId(a), VertexId(b)).unwrap();
    }
    w
}

/// Points one after the other.
fn line(points: &[[f64; 3]]) -> Wireframe {
    let edges: Vec<_> = (1..).take(points.len() - 1).map(|k| (k - 1, k)).collect();
    wireframe(points, &edges)
}

fn edges(ids: impl IntoIterator<Item = u32>) -> Vec<EdgeId> {
    ids.into_iter().map(EdgeId).collect()
}

fn at(w: &Wireframe, id: u32) -> Point3<f64> {
    w.vertex(VertexId(id)).unwrap().position
}

fn ends(w: &Wireframe) -> Vec<(u32, u32)> {
    w.edges().map(|(_, edge)| (edge.a.0, edge.b.0)).collect()
}

fn straighten(ids: impl IntoIterator<Item = u32>, tolerance: f64) -> Edit {
    Edit::Straighten { edges: edges(ids), tolerance: mm(tolerance) }
}

fn round(ids: impl IntoIterator<Item = u32>, tolerance: f64, step: f64, min: f64) -> Edit {
    Edit::Round {
        edges: edges(ids),
        tolerance: mm(tolerance),
        step: Angle::from_deg(step).unwrap(),
        min_edge: mm(min),
    }
}

#[test]
fn detached_edges_share_one_new_vertex_where_they_met_the_others() {
    // A cross; two of its arms come off together.
    let arms = [[0.; 3], [9., 0., 0.], [0., 9., 0.], [-9., 0., 0.], [0., -9., 0.]];
    let mut w = wireframe(&arms, &[(0, 1), (0, 2), (3, 0), (4, 0)]);
    let support = Edit::SetSupport { vertices: vec![VertexId(0)], support: true };
    w.apply(&support).unwrap();
    w.apply(&Edit::Detach { edges: edges([2, 1]) }).unwrap();
    assert_eq!(ends(&w), [(0, 1), (5, 2), (3, 5), (4, 0)]);
    assert_eq!((w.vertex(VertexId(5)), w.components().len()), (w.vertex(VertexId(0)), 2));
    // Nothing stays: nothing changes.
    assert!(Edit::Detach { edges: edges(0..4) }.resolve(&w).unwrap().is_empty());
}

#[test]
fn what_is_no_chain_is_said() {
    let star = [[0.; 3], [9., 0., 0.], [0., 9., 0.], [0., 0., 9.], [9., 9., 0.]];
    let w = wireframe(&star, &[(0, 1), (0, 2), (0, 3), (1, 4), (4, 2)]);
    for (ids, error) in [
        (vec![0], EditError::ChainCount(1)),
        (vec![], EditError::ChainCount(0)),
        (vec![0, 1, 2], EditError::Branched { vertex: VertexId(0), edges: 3 }),
        (vec![0, 1, 3, 4], EditError::ClosedChain),
        (vec![2, 3], EditError::BrokenChain(EdgeId(3))),
        (vec![0, 0], EditError::RepeatedEdge(EdgeId(0))),
        (vec![0, 9], EditError::NoEdge(EdgeId(9))),
    ] {
        assert_eq!(straighten(ids.clone(), 1.0).resolve(&w), Err(error.clone()), "{ids:?}");
        assert_eq!(round(ids, 1.0, 15.0, 0.0).resolve(&w), Err(error));
    }
    assert_eq!(Edit::Detach { edges: edges([1, 1]) }.resolve(&w), Err(EditError::RepeatedEdge(EdgeId(1))));
    // The straight edge would lie on one that is there.
    let triangle = wireframe(&star[..3], &[(0, 1), (0, 2), (1, 2)]);
    assert_eq!(
        straighten([0, 2], 50.0).resolve(&triangle),
        Err(EditError::Connected(VertexId(0), VertexId(2)))
    );
}

#[test]
fn a_bowed_chain_becomes_one_straight_edge_that_keeps_what_hangs_on_it() {
    // Vertex 2 carries a strut, vertex 3 is held; the list is out of order.
    let points =
        [[0., 0., 0.], [10., 0.3, 0.], [20., 0.4, 0.], [30., 0.2, 0.], [40., 0., 0.], [20., 30., 0.]];
    let drawn = [(0, 1), (2, 1), (2, 3), (3, 4), (2, 5)];
    let mut w = wireframe(&points, &drawn);
    w.apply(&straighten([3, 0, 2, 1], 0.5)).unwrap();
    // The edge that stays keeps its id and its direction.
    assert_eq!(ends(&w), [(0, 2), (2, 4), (2, 5)]);
    assert_eq!((at(&w, 2), at(&w, 5)), (Point3::new(20., 0., 0.), Point3::new(20., 30., 0.)));
    let mut w = wireframe(&points, &drawn);
    w.apply(&Edit::SetSupport { vertices: vec![VertexId(3)], support: true }).unwrap();
    w.apply(&straighten(0..4, 0.5)).unwrap();
    assert_eq!(at(&w, 3), Point3::new(30., 0.2, 0.), "a support stays where it is");
    assert_eq!(ends(&w), [(0, 2), (2, 3), (3, 4), (2, 5)]);
    // A tolerance that the bow exceeds leaves its highest point.
    let mut w = line(&points[..5]);
    w.apply(&straighten(0..4, 0.25)).unwrap();
    assert_eq!(ends(&w), [(0, 2), (2, 4)]);
}

/// Two struts that hang on a zigzag cannot both go onto the line: they would change places on it.
#[test]
fn vertices_with_other_edges_follow_each_other_on_the_line() {
    let points = [[0., 0., 0.], [30., 1., 0.], [10., 2., 0.], [40., 0., 0.], [30., 9., 0.], [10., 9., 0.]];
    let mut w = wireframe(&points, &[(0, 1), (1, 2), (2, 3), (1, 4), (2, 5)]);
    w.apply(&straighten(0..3, 5.0)).unwrap();
    assert_eq!(ends(&w), [(0, 1), (1, 2), (2, 3), (1, 4), (2, 5)]);
    assert!(w.edges().all(|(id, _)| w.edge_length(id) > mm(1.0)));
}

/// A lead-in, three quarters of a circle of radius 20 in steps of 5°, and a lead-out.
fn hook() -> Vec<[f64; 3]> {
    let mut points = vec![[20., -50., 4.]];
    points.extend((0..=54).map(|k| {
        let angle = f64::from(5 * k).to_radians();
        [20. * angle.cos(), 20. * angle.sin(), 4.]
    }));
    points.push([-40., -20., 4.]);
    points
}

#[test]
fn a_faceted_hook_becomes_a_line_an_arc_and_a_line() {
    let mut w = line(&hook());
    // The sagitta of 5° at radius 20 is 0.019 mm; 270° in steps of up to 40° are 7 edges.
    w.apply(&round(0..56, 0.02, 40.0, 0.0)).unwrap();
    assert_eq!((w.vertex_count(), w.edge_count()), (10, 9));
    let on_arc: Vec<Point3<f64>> =
        w.vertices().map(|(_, vertex)| vertex.position).filter(|p| p.y > -20.1 && p.x > -39.).collect();
    assert_eq!(on_arc.len(), 8);
    for point in on_arc {
        assert!((point.x.hypot(point.y) - 20.0).abs() < 1e-9 && (point.z - 4.0).abs() < 1e-9, "{point}");
    }
    // An edge of 270°/7 is 2·20·sin(135°/7) = 13.2 mm long; of 15 mm there are 6, of 25 mm 3, of 29 mm 2 and
    // of more than 2·20·sin(67.5°) = 36.96 mm none.
    for (min, count) in [(13.0, 7), (15.0, 6), (25.0, 3), (29.0, 2)] {
        let mut w = line(&hook());
        w.apply(&round(0..56, 0.02, 40.0, min)).unwrap();
        assert_eq!(w.edge_count(), count + 2, "{min}");
        assert!(w.edges().all(|(id, _)| w.edge_length(id) >= mm(min)));
    }
    let error = line(&hook()).apply(&round(0..56, 0.02, 40.0, 37.0)).unwrap_err();
    let EditError::SmallArc { radius, min_edge } = error else { panic!("{error}") };
    assert!((radius.mm() - 20.0).abs() < 0.01 && min_edge == mm(37.0), "{radius}, {min_edge}");
    for step in [0.0, -5.0, 181.0] {
        let error = line(&hook()).apply(&round(0..56, 0.02, step, 0.0)).unwrap_err();
        assert_eq!(error, EditError::ArcStep(Angle::from_deg(step).unwrap()));
    }
    let error = line(&hook()).apply(&round(0..56, 0.02, 1e-5, 0.0)).unwrap_err();
    assert!(matches!(error, EditError::TooMuch { .. }), "{error}");
}

#[test]
fn what_hangs_on_an_arc_stays_and_divides_it() {
    let mut points = hook();
    points.push([0., 20., 50.]);
    let mut drawn: Vec<(u32, u32)> = (1..57).map(|k| (k - 1, k)).collect();
    // Vertex 19 is at 90°.
    drawn.push((19, 57));
    let mut w = wireframe(&points, &drawn);
    w.apply(&round(0..56, 0.02, 45.0, 0.0)).unwrap();
    assert_eq!(at(&w, 19), Point3::from(points[19]));
    assert_eq!(w.edge_count(), 1 + 2 + 4 + 1 + 1);
    assert_eq!(w.incident(VertexId(19)).len(), 3);
}

/// A wireframe without loops and parallel edges, whatever else it is like.
fn any_wireframe() -> impl Strategy<Value = Wireframe> {
    let points = prop::collection::vec(prop::array::uniform3(-40.0..40.0_f64), 2..14);
    (points, prop::collection::btree_set((0..14_u32, 0..14_u32), 1..40)).prop_map(|(points, pairs)| {
        let count = u32::try_from(points.len()).unwrap();
        let pairs: BTreeSet<_> = pairs.into_iter().map(|(a, b)| (a % count, b % count)).collect();
        let pairs: Vec<_> = pairs.into_iter().filter(|(a, b)| a < b).collect();
        wireframe(&points, &pairs)
    })
}

/// How far a point is from a polyline. Along a segment the distance falls and then rises: the third with the larger
/// end is dropped until nothing is left.
fn distance(point: &Point3<f64>, polyline: &[Point3<f64>]) -> f64 {
    let nearest = polyline.windows(2).map(|pair| {
        let away = |t: f64| (pair[0] + (pair[1] - pair[0]) * t - point).norm();
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..80 {
            let third = (high - low) / 3.0;
            if away(low + third) < away(high - third) { high -= third } else { low += third }
        }
        away(low).min(away(high))
    });
    nearest.fold(f64::INFINITY, f64::min)
}

/// The points of the only wire from vertex 0 on.
fn walk(w: &Wireframe, to: u32) -> Vec<Point3<f64>> {
    let (mut last, mut came, mut points) = (VertexId(0), None, vec![at(w, 0)]);
    while last != VertexId(to) {
        // Struts that hang on the chain end at vertices of 1000 and more.
        let onward = w.incident(last).into_iter().find(|&id| {
            Some(id) != came && w.edge(id).is_some_and(|edge| edge.a.0 < 1000 && edge.b.0 < 1000)
        });
        came = onward;
        last = w.edge(onward.unwrap()).unwrap().other(last);
        points.push(w.vertex(last).unwrap().position);
    }
    points
}

proptest! {
    #[test]
    fn detached_edges_share_no_vertex_with_others(
        w in any_wireframe(), picked in prop::collection::btree_set(0..40_u32, 0..12)
    ) {
        let all: Vec<EdgeId> = w.edges().map(|(id, _)| id).collect();
        let picked: Vec<EdgeId> = picked.into_iter().map(EdgeId).filter(|id| all.contains(id)).collect();
        let mut after = w.clone();
        let delta = after.apply(&Edit::Detach { edges: picked.clone() }).unwrap();
        let touched = |of: &Wireframe, taken: bool| -> BTreeSet<VertexId> {
            let some = of.edges().filter(|(id, _)| picked.contains(id) == taken);
            some.flat_map(|(_, edge)| [edge.a, edge.b]).collect()
        };
        prop_assert!(touched(&after, true).is_disjoint(&touched(&after, false)));
        prop_assert_eq!(after.edge_count(), w.edge_count());
        let shared = touched(&w, true).intersection(&touched(&w, false)).count();
        prop_assert_eq!(after.vertex_count(), w.vertex_count() + shared, "one for each that was shared");
        for id in all {
            prop_assert!((after.edge_length(id).mm() - w.edge_length(id).mm()).abs() < 1e-12);
        }
        after.commit(&delta.inverse()).unwrap();
        prop_assert_eq!(after, w);
    }

    #[test]
    fn a_straightened_chain_stays_within_the_tolerance(
        points in prop::collection::vec(prop::array::uniform3(-20.0..20.0_f64), 3..20),
        carrying in prop::collection::btree_set(1..19_u32, 0..5),
        tolerance in 0.0..30.0_f64,
    ) {
        let last = u32::try_from(points.len()).unwrap() - 1;
        let mut w = line(&points);
        let carrying: Vec<u32> = carrying.into_iter().filter(|&k| k < last).collect();
        for (&k, id) in carrying.iter().zip(1000..) {
            w.insert_vertex(VertexId(id), Vertex::at(at(&w, k) + nalgebra::Vector3::z() * 50.0)).unwrap();
            w.add_edge(VertexId(k), VertexId(id)).unwrap();
        }
        let before = w.clone();
        let delta = w.apply(&straighten(0..last, tolerance)).unwrap();
        let straight = walk(&w, last);
        for (k, &point) in points.iter().enumerate() {
            let point = Point3::from(point);
            prop_assert!(distance(&point, &straight) <= tolerance + 1e-6, "vertex {} of {:?}", k, straight);
        }
        for &k in &carrying {
            prop_assert!((at(&w, k) - at(&before, k)).norm() <= tolerance + 1e-9);
            prop_assert!(straight.contains(&at(&w, k)));
        }
        prop_assert_eq!((straight[0], straight[straight.len() - 1]), (at(&before, 0), at(&before, last)));
        prop_assert_eq!(w.edge_count(), straight.len() - 1 + carrying.len());
        w.commit(&delta.inverse()).unwrap();
        prop_assert_eq!(w, before);
    }

    #[test]
    fn a_rounded_chain_stays_within_its_tolerance_and_sagitta(
        radius in 5.0..60.0_f64, facets in 8..60_u32, sweep in 60.0..330.0_f64, step in 5.0..60.0_f64,
    ) {
        let arc: Vec<[f64; 3]> = (0..=facets)
            .map(|k| {
                let angle = (sweep * f64::from(k) / f64::from(facets)).to_radians();
                [radius * angle.cos(), radius * angle.sin(), 0.0]
            })
            .collect();
        let sagitta = |deg: f64| radius * (1.0 - (deg / 2.0).to_radians().cos());
        let tolerance = sagitta(sweep / f64::from(facets)) + 1e-6;
        let mut w = line(&arc);
        let delta = w.apply(&round(0..facets, tolerance, step, 0.0)).unwrap();
        let drawn = walk(&w, facets);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // up to 66
        let expected = (sweep / step - 1e-9).ceil().max(2.0) as usize;
        prop_assert_eq!(drawn.len() - 1, expected);
        for point in &drawn {
            prop_assert!((point.coords.norm() - radius).abs() < 1e-6);
        }
        for &point in &arc {
            prop_assert!(distance(&Point3::from(point), &drawn) <= tolerance + sagitta(step) + 1e-6);
        }
        let rounded = w.clone();
        w.commit(&delta.inverse()).unwrap();
        prop_assert_eq!(&w, &line(&arc));
        w.commit(&delta).unwrap();
        prop_assert_eq!(w, rounded);
    }
}
