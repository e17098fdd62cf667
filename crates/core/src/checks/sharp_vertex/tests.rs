//! Bends beyond the limit that no route avoids.

use super::super::tests::{measured_deg, on};
use super::super::{Code, Remedy};
use crate::plan::{PlanOptions, plan_wires};
use crate::testing::{deg, published_machine, wireframe};
use crate::wireframe::{EdgeId, VertexId};

/// A design with many odd vertices is drawn for long before it has a route.
#[test]
fn a_vertex_that_no_wire_can_pass_is_told_before_there_is_a_route() {
    // Four spikes: at each tip two edges at 170°, and no route since four feet are odd.
    let tip = |k: f64| {
        let along = [k * 40.0, 0.0, 0.0];
        let spread = 100.0 * f64::to_radians(5.0).tan();
        [along, [along[0] - spread, 100.0, 0.0], [along[0] + spread, 100.0, 0.0]]
    };
    let mut points = Vec::new();
    let mut edges = Vec::new();
    for k in 0..4_u32 {
        let first = points.len();
        points.extend(tip(f64::from(k)));
        edges.extend([(first, first + 1), (first, first + 2)]);
    }
    // A hub that all eight ends meet, and two more ends of it.
    points.extend([[60., 400., 0.], [60., 500., 0.], [160., 500., 0.], [-40., 500., 0.]]);
    let hub = points.len() - 4;
    edges.extend((0..4).flat_map(|k| [(3 * k + 1, hub), (3 * k + 2, hub)]));
    edges.extend([(hub, hub + 1), (hub, hub + 2), (hub, hub + 3)]);
    let w = wireframe(&points, &edges);
    let plan =
        plan_wires(&w, &w.components()[0], &published_machine(), &PlanOptions::default(), |_| ()).remove(0);
    assert!(plan.route.is_none(), "three ends and a hub of eleven edges are odd");
    let sharp: Vec<_> = plan.diagnostics.iter().filter(|d| d.code() == Code::BendTooSharp).collect();
    let tips: Vec<_> = sharp.iter().map(|d| d.location.vertices[0].0).collect();
    // At the hub eight edges point down and three or four do not: not each of the eight has one of these to go on to.
    assert_eq!(tips, [0, 3, 6, 9, 12], "{:#?}", plan.diagnostics);
    // The edges of a tip are 10° apart: the wire turns by 170°.
    assert!(sharp[0].is_error() && (measured_deg(sharp[0]) - 170.0).abs() < 1e-9, "{:?}", sharp[0]);
    // Closed, the three others are doubled: the hub can be passed, and the ends may lie at one tip only.
    let closed = on(&published_machine(), &w, &PlanOptions { closed: true, ..PlanOptions::default() });
    assert_eq!(closed.iter().filter(|d| d.code() == Code::BendTooSharp && d.is_error()).count(), 4);
    // With the axis cut short nothing else is out of reach before than behind: the same tips, by another limit.
    let mut short_axis = published_machine();
    short_axis.limits.max_bend.value = deg(175.0);
    short_axis.limits.min_bend.value = deg(-175.0);
    short_axis.compensation.bend.axis_limit = Some(deg(130.0));
    let found = on(&short_axis, &w, &PlanOptions::default());
    assert!(
        found.iter().any(|d| d.code() == Code::BendOutOfReach && d.location.vertices == [VertexId(3)]),
        "{found:#?}"
    );
}

/// A closed wire has its ends where it would be bent too far.
#[test]
fn the_ends_of_a_closed_wire_lie_at_its_only_sharp_vertex() {
    let spread = 100.0 * f64::to_radians(5.0).tan();
    let tip = [[0.; 3], [-spread, 100., 0.], [-100., 200., 0.], [100., 200., 0.], [spread, 100., 0.]];
    // Round the tip, and a chord that makes two vertices odd.
    let w = wireframe(&tip, &[(0, 1), (1, 2), (2, 3), (3, 4), (4, 0), (1, 4)]);
    let closed = PlanOptions { closed: true, ..PlanOptions::default() };
    let sharp = |options: &PlanOptions| {
        let found = on(&published_machine(), &w, options);
        found
            .iter()
            .filter(|d| d.code() == Code::BendTooSharp)
            .map(|d| d.location.vertices[0].0)
            .collect::<Vec<_>>()
    };
    assert_eq!(sharp(&closed), [0_u32; 0]);
    // Where it starts elsewhere, it has to pass the tip.
    assert_eq!(sharp(&PlanOptions { start: Some(VertexId(2)), ..closed.clone() }), [0]);
    assert_eq!(sharp(&PlanOptions::default()), [0]);
}

/// One edge up and three down: whichever way, two of the three follow each other.
#[test]
fn a_detour_leads_around_a_bend_that_no_route_avoids() {
    let down = |deg: f64| [200.0 * deg.to_radians().sin(), -200.0 * deg.to_radians().cos(), 0.0];
    // Above, a triangle to turn round in; below, three feet of which two are joined.
    let points =
        [[0.; 3], [0., 100., 0.], [-60., 160., 0.], [60., 160., 0.], down(-10.0), down(0.0), down(10.0)];
    let w = wireframe(&points, &[(0, 1), (1, 2), (2, 3), (3, 1), (0, 4), (0, 5), (0, 6), (4, 5)]);
    let sharp = |options: &PlanOptions| {
        let found = on(&published_machine(), &w, options);
        found.into_iter().filter(|d| d.code() == Code::BendTooSharp).collect::<Vec<_>>()
    };
    let found = sharp(&PlanOptions::default());
    let [forced] = found.as_slice() else { panic!("{found:#?}") };
    assert_eq!(forced.location.vertices, [VertexId(0)]);
    // Up once more, round the triangle the other way and down again: 100 + 2 · 60√2 + 120 + 100 mm.
    let added = 320.0 + 120.0 * 2f64.sqrt();
    let detour = forced.remedies.iter().find_map(|remedy| match remedy {
        Remedy::Detour { edges, added } => Some((edges.clone(), added.mm())),
        _ => None,
    });
    let (edges, length) = detour.unwrap();
    assert_eq!(edges, [0, 0, 1, 2, 3].map(EdgeId));
    assert!((length - added).abs() < 1e-9, "{length} for {added}");
    assert_eq!(sharp(&PlanOptions { detours: true, ..PlanOptions::default() }), []);
}

/// Started at one tip, a leaf of four edges has the same bend at the other. A key that is started where its ring is sharp folds back at
/// the end of its bar.
#[test]
fn a_start_is_offered_only_where_fewer_bends_are_beyond_the_limit() {
    let leaf = [[0., 0., 0.], [100., 20., 0.], [200., 0., 0.], [100., -20., 0.]];
    let key = [[0., 0., 0.], [100., 20., 0.], [100., -20., 0.], [100., 20., 80.]];
    for (points, edges) in [(leaf, [(0, 1), (1, 2), (2, 3), (3, 0)]), (key, [(0, 1), (1, 2), (2, 0), (1, 3)])]
    {
        let found = on(&published_machine(), &wireframe(&points, &edges), &PlanOptions::default());
        let sharp = found.iter().find(|found| found.code() == Code::BendTooSharp).unwrap();
        assert!(sharp.is_error() && sharp.remedies == [Remedy::OpenAngle], "{sharp:?}");
    }
}
