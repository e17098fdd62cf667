//! Steps in an order in which the frame does not hold.

use std::f64::consts::PI;

use nalgebra::Vector3;
use wirebend_core::checks::sequence::Violation;
use wirebend_core::wireframe::{EdgeId, Vertex, VertexId, Wireframe};
use wirebend_sequence::{GivenJoint, GivenStep, Groups, Structure};
use wirebend_tests_brute::Fault;

use super::{ARM, ARM_EDGE, BEAM_EDGE, Built, LONE_PILLAR_EDGE, POST_EDGE, builder};

/// The beam keeps the pillar from being bent by the arm. Without it the end of the arm sags too far, by the textbook: pillar and arm are
/// two cantilevers, one on the other.
#[test]
fn two_steps_in_the_wrong_order_that_sag() {
    let built = Built::stage();
    let (beam, arm) = (built.place_of(BEAM_EDGE), built.place_of(ARM_EDGE));
    assert_eq!(beam + 1, arm, "the beam, then the arm");
    let (found, faults) = built.planted(|steps| steps.swap(beam, arm));

    let (g, e, d, height) = (9806.33_f64, 3457.0, 1.5_f64, 40.0);
    let (area, inertia) = (PI * d * d / 4.0, PI * d.powi(4) / 64.0);
    let q = 1210e-12 * area * g;
    let moment = q * ARM * ARM / 2.0;
    let short = (q * ARM * height + q * height * height / 2.0) / (e * area);
    let down = short + moment * height / (e * inertia) * ARM + q * ARM.powi(4) / (8.0 * e * inertia);
    let wanted = down.hypot(moment * height * height / (2.0 * e * inertia));
    assert!(wanted > 0.7);
    let near = |mm: f64| (mm - wanted).abs() < 1e-6 * wanted;
    // The swapped step is the one after which it sags, and only there.
    let step = beam + 1;
    assert!(
        matches!(&found[..], [Violation::Sags { step: at, vertex: VertexId(4), sag: Some(sag), max }]
            if *at == step && near(sag.mm()) && *max == builder().max_sag),
        "{found:?} instead of {wanted}"
    );
    assert!(
        matches!(&faults[..], [Fault::Sags { step: at, vertex: 4, mm }] if *at == step && near(*mm)),
        "{faults:?} instead of {wanted}"
    );
}

/// One leg is held altogether, the other only rests on the ground, and stands once it leans on the first.
#[test]
fn two_steps_in_the_wrong_order_of_which_the_first_falls() {
    let mut made = Wireframe::new();
    let [none, sideways] = [[false; 6], [true, true, false, true, true, true]];
    for (at, free) in [([0.0, 0.0, 0.0], none), ([60.0, 0.0, 0.0], sideways), ([30.0, 0.0, 50.0], none)] {
        made.add_vertex(Vertex { support: at[2] <= 0.0, free, ..Vertex::at(at.into()) }).unwrap();
    }
    let held = made.add_edge(VertexId(0), VertexId(2)).unwrap();
    let resting = made.add_edge(VertexId(1), VertexId(2)).unwrap();
    let structure = Structure::new(&made).unwrap();
    let groups = Groups::single(&structure);
    let built = Built::found(structure, groups, builder());
    assert_eq!((&built.given[0].edges, &built.given[1].edges), (&vec![held], &vec![resting]));
    let along = |edge: EdgeId, foot: u32, x: f64| GivenStep {
        edges: vec![edge],
        kind: None,
        joints: vec![GivenJoint {
            vertex: VertexId(foot),
            directions: vec![Vector3::new(x, 0.0, 1.0).normalize()],
        }],
    };
    // Each head leans away from the other leg.
    let right = [along(held, 0, -0.3), along(resting, 1, 0.3)];
    let (found, faults) = built.planted(|steps| *steps = right.to_vec());
    assert_eq!((found, faults), (Vec::new(), Vec::new()));
    let (found, faults) = built.planted(|steps| *steps = [right[1].clone(), right[0].clone()].to_vec());
    assert!(matches!(found[..], [Violation::Sags { step: 1, sag: None, .. }]), "{found:?}");
    assert_eq!(faults, [Fault::Falls { step: 1 }]);
}

#[test]
fn a_strut_before_the_one_that_it_hangs_on() {
    let mut built = Built::stage();
    let (arm, post) = (built.place_of(ARM_EDGE), built.place_of(POST_EDGE));
    // The head comes from the side, where it hits the post neither before nor after.
    let aside = 50_f64.to_radians();
    built.given[arm].joints[0].directions = vec![Vector3::new(aside.cos(), aside.sin(), 0.0)];
    assert_eq!(built.planted(|_| {}), (Vec::new(), Vec::new()));
    let (found, faults) = built.planted(|steps| {
        let moved = steps.remove(post);
        steps.insert(arm, moved);
    });
    let (step, edge) = (arm + 1, EdgeId(POST_EDGE));
    assert!(
        matches!(&found[..], [
            Violation::Floating { step: one, edge: first, vertex: None },
            Violation::Floating { step: two, edge: second, vertex: Some(VertexId(4)) },
            Violation::Sags { step: three, sag: None, .. },
        ] if [*one, *two, *three] == [step; 3] && [*first, *second] == [edge; 2]),
        "{found:?}"
    );
    assert_eq!(
        faults,
        [Fault::Floating { step }, Fault::NothingBuilt { step, vertex: 4 }, Fault::Falls { step }]
    );
}

#[test]
fn a_pillar_after_what_is_not_on_the_ground() {
    let built = Built::stage();
    let pillar = built.place_of(LONE_PILLAR_EDGE);
    let late = |steps: &mut Vec<GivenStep>| {
        let moved = steps.remove(pillar);
        steps.push(moved);
    };
    let (found, faults) = built.planted(late);
    let step = built.given.len();
    assert_eq!(found, [Violation::GroundLate { step, edge: EdgeId(LONE_PILLAR_EDGE) }]);
    assert_eq!(faults, [Fault::GroundLate { step }]);
    // A machine that does not mind takes it.
    let mut builder = builder();
    builder.ground_first = false;
    assert_eq!(built.planted_for(&builder, late), (Vec::new(), Vec::new()));
}
