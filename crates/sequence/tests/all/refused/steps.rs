//! Steps that say what cannot be.

use wirebend_core::checks::sequence::{StepKind, Violation};
use wirebend_core::wireframe::{EdgeId, VertexId};
use wirebend_tests_brute::{Fault, Kind};

use super::{ARM_EDGE, BEAM_EDGE, Built, POST_EDGE};

#[test]
fn an_edge_that_the_design_has_not() {
    let built = Built::stage();
    let step = built.place_of(POST_EDGE) + 1;
    let (found, faults) = built.planted(|steps| steps[step - 1].edges = vec![EdgeId(9999)]);
    let edges = vec![EdgeId(POST_EDGE)];
    assert_eq!(found, [Violation::UnknownEdge { step, edge: EdgeId(9999) }, Violation::Missing { edges }]);
    assert_eq!(
        faults,
        [Fault::UnknownEdge { step, edge: 9999 }, Fault::NeverBuilt { edges: vec![POST_EDGE] }]
    );
}

#[test]
fn a_step_without_an_edge() {
    let built = Built::stage();
    let step = built.place_of(POST_EDGE) + 1;
    let (found, faults) = built.planted(|steps| steps[step - 1].edges.clear());
    assert_eq!(found, [Violation::Empty { step }, Violation::Missing { edges: vec![EdgeId(POST_EDGE)] }]);
    assert_eq!(faults, [Fault::Empty { step }, Fault::NeverBuilt { edges: vec![POST_EDGE] }]);
}

#[test]
fn a_strut_that_is_never_built() {
    let built = Built::stage();
    let (found, faults) = built.planted(|steps| {
        steps.remove(built.place_of(POST_EDGE));
    });
    assert_eq!(found, [Violation::Missing { edges: vec![EdgeId(POST_EDGE)] }]);
    assert_eq!(faults, [Fault::NeverBuilt { edges: vec![POST_EDGE] }]);
}

#[test]
fn a_strut_that_is_built_twice() {
    let built = Built::stage();
    let first = built.place_of(BEAM_EDGE) + 1;
    let (found, faults) = built.planted(|steps| steps.push(steps[first - 1].clone()));
    let step = built.given.len() + 1;
    assert_eq!(found, [Violation::Twice { step, edge: EdgeId(BEAM_EDGE), first }]);
    assert_eq!(faults, [Fault::BuiltTwice { step, edge: BEAM_EDGE, first }]);
}

#[test]
fn a_head_that_begins_where_the_strut_does_not_end() {
    let built = Built::stage();
    let step = built.place_of(POST_EDGE) + 1;
    let (found, faults) = built.planted(|steps| steps[step - 1].joints[0].vertex = VertexId(3));
    assert_eq!(found, [Violation::NotAnEnd { step, vertex: VertexId(3) }]);
    assert_eq!(faults, [Fault::NotAnEnd { step, vertex: 3 }]);
}

#[test]
fn a_head_that_begins_at_the_end_in_the_open() {
    let built = Built::stage();
    let step = built.place_of(POST_EDGE) + 1;
    let (found, faults) = built.planted(|steps| steps[step - 1].joints[0].vertex = VertexId(5));
    let edge = EdgeId(POST_EDGE);
    assert_eq!(found, [Violation::Floating { step, edge, vertex: Some(VertexId(5)) }]);
    assert_eq!(faults, [Fault::NothingBuilt { step, vertex: 5 }]);
}

#[test]
fn a_head_that_begins_nowhere() {
    let built = Built::stage();
    let step = built.place_of(POST_EDGE) + 1;
    let (found, faults) = built.planted(|steps| steps[step - 1].joints.clear());
    assert_eq!(found, [Violation::JointMissing { step, vertex: VertexId(4) }]);
    assert_eq!(faults, [Fault::JointMissing { step, vertex: 4 }]);
}

#[test]
fn a_step_that_is_said_to_be_another() {
    let built = Built::stage();
    for (edge, said, wrong, is, right) in [
        (ARM_EDGE, StepKind::Connect, Kind::Connect, StepKind::Create, Kind::Create),
        (BEAM_EDGE, StepKind::Create, Kind::Create, StepKind::Connect, Kind::Connect),
        (0, StepKind::Create, Kind::Create, StepKind::Ground, Kind::Ground),
    ] {
        let step = built.place_of(edge) + 1;
        let (found, faults) = built.planted(|steps| steps[step - 1].kind = Some(said));
        assert_eq!(found, [Violation::WrongKind { step, said, is }]);
        assert_eq!(faults, [Fault::OtherKind { step, said: wrong, is: right }]);
    }
}
