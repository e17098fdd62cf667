//! Bent wires that are placed at once.

use nalgebra::Vector3;
use wirebend_core::checks::sequence::Violation;
use wirebend_core::wireframe::{EdgeId, VertexId};
use wirebend_sequence::{GivenStep, Groups, StrutBuilder};
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

/// Two posts and a bar of rods.
fn rods() -> Built {
    let points = [[0.0; 3], [0.0, 0.0, 40.0], [60.0, 0.0, 0.0], [60.0, 0.0, 40.0]];
    let structure = frame(&points, &[[0, 1], [2, 3], [1, 3]]);
    let groups = Groups::single(&structure);
    let built = Built::found(structure, groups, StrutBuilder { places: true, ..builder() });
    assert_eq!((built.given.len(), built.given[2].joints.len()), (3, 2), "the bar is fastened at both posts");
    built
}

#[test]
fn a_rod_that_is_not_fastened_at_one_of_its_ends() {
    let (found, faults) = rods().planted(|steps| {
        steps[2].joints.retain(|joint| joint.vertex == VertexId(1));
    });
    assert_eq!(found, [Violation::JointMissing { step: 3, vertex: VertexId(3) }]);
    assert_eq!(faults, [Fault::JointMissing { step: 3, vertex: 3 }]);
}

/// A head that draws an arm may lean along it; where it is placed, the arm is in its way.
#[test]
fn a_head_that_hits_the_rod_which_it_fastens() {
    let structure = frame(&[[0.0; 3], [0.0, 0.0, 40.0], [60.0, 0.0, 40.0]], &[[0, 1], [1, 2]]);
    let groups = Groups::single(&structure);
    let built = Built::found(structure, groups, StrutBuilder { places: true, ..builder() });
    let along = |steps: &mut Vec<GivenStep>| steps[1].joints[0].directions = vec![Vector3::x()];
    let (found, faults) = built.planted(along);
    assert!(
        matches!(&found[..], [Violation::HeadMeets { step: 2, edge: EdgeId(1), distance, .. }] if distance.mm() < -1.0),
        "{found:?}"
    );
    assert!(matches!(&faults[..], [Fault::Hits { step: 2, edge: 1, mm }] if *mm < -1.0), "{faults:?}");
    assert_eq!(built.planted_for(&builder(), along), (Vec::new(), Vec::new()), "it may be drawn so");
}
