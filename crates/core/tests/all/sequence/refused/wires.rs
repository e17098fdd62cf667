//! Bent wires that are placed at once.

use nalgebra::Vector3;
use wirebend_core::sequence::{Groups, Violation};
use wirebend_core::wireframe::{EdgeId, VertexId};
use wirebend_tests_brute::Fault;

use super::{Built, builder, frame};

/// A wire of two legs and a bar, on two posts:
///
/// ```text
///     1 ─── 3
///     │     │
///     0     2
/// ```
fn arch() -> Built {
    let points = [[0.0; 3], [0.0, 0.0, 40.0], [60.0, 0.0, 0.0], [60.0, 0.0, 40.0]];
    let structure = frame(&points, &[[0, 1], [1, 3], [3, 2]]);
    let groups = Groups::together(&structure, &[vec![EdgeId(0), EdgeId(1), EdgeId(2)]]).unwrap();
    let built = Built::found(structure, groups, builder());
    assert_eq!((built.given.len(), built.given[0].joints.len()), (1, 2));
    built
}

#[test]
fn a_wire_that_is_not_fastened_at_one_of_its_feet() {
    let built = arch();
    let (found, faults) = built.planted(|steps| {
        steps[0].joints.retain(|joint| joint.vertex == VertexId(0));
    });
    assert_eq!(found, [Violation::JointMissing { step: 1, vertex: VertexId(2) }]);
    assert_eq!(faults, [Fault::JointMissing { step: 1, vertex: 2 }]);
}

#[test]
fn a_head_that_hits_the_wire_which_it_fastens() {
    let built = arch();
    // Along the leg that stands there, up to the bar.
    let (found, faults) = built.planted(|steps| {
        let joint = steps[0].joints.iter_mut().find(|joint| joint.vertex == VertexId(2)).unwrap();
        joint.directions = vec![Vector3::z()];
    });
    assert!(
        matches!(&found[..], [Violation::HeadMeets { step: 1, edge: EdgeId(1), distance, .. }] if distance.mm() < -1.0),
        "{found:?}"
    );
    assert!(matches!(&faults[..], [Fault::Hits { step: 1, edge: 1, mm }] if *mm < -1.0), "{faults:?}");
}

#[test]
fn a_wire_with_an_edge_that_was_placed_before() {
    let built = arch();
    let (found, faults) = built.planted(|steps| steps.push(steps[0].clone()));
    let edges = [0, 1, 2];
    assert_eq!(found, edges.map(|edge| Violation::Twice { step: 2, edge: EdgeId(edge), first: 1 }));
    assert_eq!(faults, edges.map(|edge| Fault::BuiltTwice { step: 2, edge, first: 1 }));
}
