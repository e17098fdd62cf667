use super::*;
use crate::checks::{Design, check_design};
use crate::plan::{PlanOptions, Stage, plan_wires};
use crate::route::Route;
use crate::testing::{chain, mm, published_machine, wireframe};
use crate::wireframe::Wireframe;

/// A strut, and a last edge that comes to lie 2 mm beside it by the bend at vertex 5: from its own side where `x` is 2, over it where
/// it is -2.
fn beside(x: f64) -> Wireframe {
    chain(&[
        [x, -80., 0.],
        [x, -20., 0.],
        [x, -20., 60.],
        [60., -20., 60.],
        [60., 0., 0.],
        [0., 0., 0.],
        [0., -100., 0.],
    ])
}

fn machine() -> Machine {
    let mut machine = published_machine();
    machine.compensation.bend.springback = None;
    machine
}

/// The wires of each part of a design, one part after the other.
fn wires(w: &Wireframe, options: &PlanOptions) -> Vec<WirePlan> {
    let plan = |component: &_| plan_wires(w, component, &machine(), options, |_: Stage| {});
    w.components().iter().flat_map(plan).collect()
}

/// What is said of the bend that closes the gap between two edges; none where no bend does.
fn closing(w: &Wireframe, edges: [u32; 2], wires: &[WirePlan]) -> Option<ClosingBend> {
    let components = w.components();
    let design =
        Design { wireframe: w, components: &components, weld_tolerance: mm(1e-3), diameter: mm(3.0) };
    let mut found = check_design(&design);
    found
        .retain(|one| matches!(one.fact, Fact::EdgesMeet { edges: found, .. } if found == edges.map(EdgeId)));
    assert_eq!(found.len(), 1, "{found:#?}");
    name_closing_bends(&mut found, wires, &machine());
    let Fact::EdgesMeet { closing, .. } = found[0].fact else { unreachable!() };
    closing
}

fn along(w: &Wireframe, start: u32, edges: &[u32]) -> PlanOptions {
    let edges: Vec<EdgeId> = edges.iter().copied().map(EdgeId).collect();
    let route = Route::along(w, VertexId(start), &edges).unwrap();
    PlanOptions { settled: vec![route], ..PlanOptions::default() }
}

#[test]
fn the_last_bend_before_the_later_place_closes_the_gap() {
    let bend = |x: f64, start: u32| {
        let w = beside(x);
        closing(
            &w,
            [0, 5],
            &wires(&w, &PlanOptions { start: Some(VertexId(start)), ..PlanOptions::default() }),
        )
    };
    let named = |vertex: u32, step, snaps_past| {
        Some(ClosingBend { vertex: VertexId(vertex), step: Some(step), snaps_past })
    };
    assert_eq!(bend(-2.0, 0), named(5, 4, true));
    assert_eq!(bend(2.0, 0), named(5, 4, false));
    // From the other end the strut is the later of the two.
    assert_eq!(bend(-2.0, 6), named(1, 4, false));
}

/// A wire runs back along the last edge, or along it first of all: only what is still to be bent is brought there.
#[test]
fn an_edge_that_is_passed_twice_is_closed_by_the_bend_of_either_pass() {
    let w = beside(-2.0);
    let there_and_back = closing(&w, [0, 5], &wires(&w, &along(&w, 0, &[0, 1, 2, 3, 4, 5, 5])));
    assert_eq!(there_and_back.map(|bend| (bend.vertex, bend.snaps_past)), Some((VertexId(5), true)));
    let first_of_all = closing(&w, [0, 5], &wires(&w, &along(&w, 5, &[5, 5, 4, 3, 2, 1, 0])));
    assert_eq!(first_of_all.map(|bend| (bend.vertex, bend.snaps_past)), Some((VertexId(1), false)));
}

/// The vertex at which a wire turns away lies on another edge: it is there before it is bent.
#[test]
fn a_vertex_is_brought_there_by_the_bend_before_it() {
    let w = chain(&[[0.; 3], [100., 0., 0.], [100., 60., 0.], [50., 2., 0.], [20., 60., 40.]]);
    let options = PlanOptions { start: Some(VertexId(0)), ..PlanOptions::default() };
    let bend = closing(&w, [0, 2], &wires(&w, &options)).unwrap();
    assert_eq!((bend.vertex, bend.step), (VertexId(2), Some(1)));
}

/// Each wire has steps of its own: the vertex alone says which bend it is. No bend brings two wires to each other.
#[test]
fn of_several_wires_the_bend_is_named_by_its_vertex() {
    let mut w = beside(-2.0);
    let far = [[500., 0., 0.], [600., 0., 0.]]
        .map(|at| w.add_vertex(crate::wireframe::Vertex::at(Point3::from(at))).unwrap());
    w.add_edge(far[0], far[1]).unwrap();
    let bend =
        closing(&w, [0, 5], &wires(&w, &PlanOptions { start: Some(VertexId(0)), ..PlanOptions::default() }))
            .unwrap();
    assert_eq!((bend.vertex, bend.step, bend.snaps_past), (VertexId(5), None, true));
    let apart = wireframe(&[[0.; 3], [80., 0., 0.], [40., -40., 2.], [40., 40., 2.]], &[(0, 1), (2, 3)]);
    assert_eq!(closing(&apart, [0, 1], &wires(&apart, &PlanOptions::default())), None);
}
