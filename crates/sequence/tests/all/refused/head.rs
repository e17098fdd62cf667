//! Heads that cannot be where they are to be.

use nalgebra::{Point3, Vector3};
use wirebend_collide::{DirectionSet, Passage};
use wirebend_core::checks::sequence::Violation;
use wirebend_core::wireframe::{EdgeId, VertexId};
use wirebend_sequence::{Groups, Structure};
use wirebend_tests_brute::Fault;

use super::super::frames::assembly;
use super::{ARM_EDGE, BEAM_EDGE, Built, POST_EDGE, builder, frame};

#[test]
fn an_axis_that_is_no_direction() {
    let built = Built::stage();
    let place = built.place_of(POST_EDGE);
    let (step, vertex) = (place + 1, built.given[place].joints[0].vertex);
    let nothing: &[Vector3<f64>] = &[];
    let too_large = [Vector3::x() * 1e200];
    let axes = [[Vector3::zeros()], [Vector3::x() * f64::INFINITY], [Vector3::x() * f64::NAN], too_large];
    for none in axes.iter().map(<[_; 1]>::as_slice).chain([nothing]) {
        let (found, faults) = built.planted(|steps| steps[place].joints[0].directions = none.to_vec());
        assert_eq!(found, [Violation::NoDirection { step, vertex }]);
        assert_eq!(faults, [Fault::NoDirection { step, vertex: vertex.0 }]);
    }
}

/// Into the open the axis may lean by less than 60°, between what is built by less than 90°.
#[test]
fn an_axis_that_leans_over_its_way() {
    let built = Built::stage();
    for (edge, max, lean) in [(ARM_EDGE, 60.0, 70.0_f64), (BEAM_EDGE, 90.0, 100.0)] {
        let place = built.place_of(edge);
        let (step, from_left) =
            (place + 1, built.given[place].joints[0].vertex != VertexId(1) || edge == ARM_EDGE);
        let way = if from_left { 1.0 } else { -1.0 };
        let lean = lean.to_radians();
        let axis = Vector3::new(way * lean.cos(), 0.0, lean.sin());
        let (found, faults) = built.planted(|steps| steps[place].joints[0].directions = vec![axis]);
        assert!(
            matches!(&found[..], [Violation::Approach { step: at, angle, max: limit }]
                if *at == step && (angle.rad() - lean).abs() < 1e-9 && (limit.deg() - max).abs() < 1e-9),
            "{found:?}"
        );
        assert!(
            matches!(&faults[..], [Fault::Leans { step: at, deg }]
                if *at == step && (deg - lean.to_degrees()).abs() < 1e-9),
            "{faults:?}"
        );
    }
}

/// A direction that suits the way, and that a strut which stands takes.
#[test]
fn a_head_that_hits_a_strut() {
    let structure = Structure::new(&assembly("simple_frame")).unwrap();
    let groups = Groups::single(&structure);
    let built = Built::found(structure, groups, builder());
    let mut hits = 0;
    for (place, step) in built.given.iter().enumerate() {
        let from = step.joints[0].vertex;
        let strut = built.structure.struts()[built.structure.strut_of(step.edges[0]).unwrap()];
        let [a, b] = strut.ends.map(|node| built.structure.nodes()[node]);
        let way = if from == a.vertex { b.at - a.at } else { a.at - b.at };
        // Along the way the strut goes into the head where others go on from its end.
        let (found, faults) =
            built.planted(|steps| steps[place].joints[0].directions = vec![way.normalize()]);
        match (&found[..], &faults[..]) {
            ([], []) => {}
            (
                [Violation::HeadMeets { step, edge, distance, least }],
                [Fault::Hits { step: at, edge: hit, mm }],
            ) => {
                assert_eq!((*step, edge.0), (place + 1, *hit));
                assert_eq!(step, at);
                assert!((distance.mm() - mm).abs() < 0.01 && distance < least, "{distance:?} {mm}");
                hits += 1;
            }
            other => panic!("{other:?}"),
        }
    }
    assert!(hits > 5, "{hits}");
}

/// A post stands beside the middle of a beam and reaches above it. An upright head, which leans a little forward, is free before the
/// beam and behind it, and hits the post on its way.
#[test]
fn a_head_that_hits_a_strut_in_the_middle_of_its_way_alone() {
    const POST: u32 = 2;
    const BEAM: u32 = 3;
    let ends = [Point3::new(0.0, 0.0, 60.0), Point3::new(120.0, 0.0, 60.0)];
    let post = [Point3::new(60.0, 3.0, 0.0), Point3::new(60.0, 3.0, 70.0)];
    let foot = |top: &Point3<f64>| [top.x, top.y, 0.0];
    let points: Vec<[f64; 3]> = [&ends[0], &ends[1], &post[1]]
        .into_iter()
        .flat_map(|top| [foot(top), [top.x, top.y, top.z]])
        .collect();
    let structure = frame(&points, &[[0, 1], [2, 3], [4, 5], [1, 3]]);
    let groups = Groups::single(&structure);
    let built = Built::found(structure, groups, builder());
    let place = built.place_of(BEAM);
    assert_eq!(place, 3, "the beam comes last");
    let forward = if built.given[place].joints[0].vertex == VertexId(1) { 1.0 } else { -1.0 };
    let lean = 18_f64.to_radians();
    let axis = Vector3::new(forward * lean.sin(), 0.0, lean.cos());
    let (found, faults) = built.planted(|steps| steps[place].joints[0].directions = vec![axis]);
    assert!(
        matches!(&found[..], [Violation::HeadMeets { step: 4, edge: EdgeId(POST), distance, .. }] if distance.mm() < -0.5),
        "{found:?}"
    );
    assert!(matches!(&faults[..], [Fault::Hits { step: 4, edge: POST, mm }] if *mm < -0.5), "{faults:?}");
    // At both of its ends it is more than 20 mm from it.
    let axes = [nalgebra::UnitVector3::new_normalize(axis)];
    for end in &ends {
        let passage = Passage { motion: [end; 2], piece: [&post[0], &post[1]], limit: 20.0, tolerance: 0.01 };
        assert!(built.builder.head.meets(&passage, &axes, DirectionSet::first(1)).is_empty());
    }
}

#[test]
fn a_vertex_that_the_tip_does_not_reach() {
    let built = Built::stage();
    let mut small = builder();
    small.workspace = Some([Point3::new(-100.0, -100.0, 0.0), Point3::new(99.0, 300.0, 60.0)]);
    let (found, faults) = built.planted_for(&small, |_| {});
    let (arm, post) = (built.place_of(ARM_EDGE) + 1, built.place_of(POST_EDGE) + 1);
    let wanted = [(arm, 4), (post, 5)];
    let violation = |(step, vertex)| Violation::OutOfReach { step, vertex: VertexId(vertex) };
    assert_eq!(found, wanted.map(violation));
    assert_eq!(faults, wanted.map(|(step, vertex)| Fault::OutOfReach { step, vertex }));
}
