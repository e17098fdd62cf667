//! Frames small enough to see what has to come out.

use std::ops::ControlFlow;

use nalgebra::{Point3, Vector3};
use wirebend_core::checks::sequence::{StepKind, Violation};
use wirebend_core::units::Length;
use wirebend_core::wireframe::{EdgeId, VertexId};
use wirebend_sequence::{
    GivenJoint, GivenStep, Groups, ObstacleRule, Partial, SearchOptions, Structure, StrutBuilder, Task,
    check, search, search_by_paper,
};

use super::confirm::searched;
use super::frames::{abs, builder, frame};

/// Each leg alone sags by millimetres, `q L⁴/8EI` as a beam; leaning on each other they do not. So whichever is first, none can be.
#[test]
fn two_legs_that_need_each_other_are_proved_impossible() {
    let structure = frame(&[[0.0; 3], [300.0, 0.0, 0.0], [150.0, 0.0, 150.0]], &[[0, 2], [1, 2]]);
    let outcome = searched(&structure, &Groups::single(&structure), &builder());
    assert!(!outcome.is_found() && outcome.proved);
    let obstacle = outcome.obstacle.unwrap();
    assert!(
        matches!(obstacle.rule, ObstacleRule::Sags { node: 2, sag_mm: Some(sag) } if sag > 0.65),
        "{obstacle:?}"
    );
    assert_eq!(obstacle.step, 2);
    // Placed as one bent wire they stand.
    let wire = Groups::together(&structure, &[vec![EdgeId(0), EdgeId(1)]]).unwrap();
    let outcome = searched(&structure, &wire, &builder());
    assert_eq!(outcome.steps.len(), 1);
    assert_eq!(outcome.steps[0].joints.len(), 2, "it is fastened at both feet");
}

/// What a step is, and how many directions are free at each of its joints, is found out whatever the file says.
#[test]
fn a_check_tells_what_each_step_is_and_which_of_its_joints_are_free() {
    let structure = frame(&[[0.0; 3], [300.0, 0.0, 0.0], [150.0, 0.0, 150.0]], &[[0, 2], [1, 2]]);
    let (builder, weight) = (builder(), abs());
    let wire = Groups::together(&structure, &[vec![EdgeId(0), EdgeId(1)]]).unwrap();
    let task = Task { structure: &structure, groups: &wire, builder: &builder, weight: &weight };
    let joint = |vertex: u32, axis: [f64; 3]| GivenJoint {
        vertex: VertexId(vertex),
        directions: vec![Vector3::from(axis).normalize()],
    };
    // Away from the wire at one foot, and along its leg at the other.
    let joints = vec![joint(0, [-1.0, 0.0, 1.0]), joint(1, [-1.0, 0.0, 1.0])];
    let step = GivenStep { edges: vec![EdgeId(0), EdgeId(1)], kind: None, joints };
    let checked = check(&task, &[step]);
    assert_eq!(checked.kinds, [Some(StepKind::Ground)]);
    assert_eq!(checked.free, [[1, 0]]);
    assert!(
        matches!(checked.violations[..], [Violation::HeadMeets { step: 1, .. }]),
        "{:?}",
        checked.violations
    );
}

#[test]
fn a_frame_that_sags_when_it_is_finished_is_not_searched() {
    let structure = frame(&[[0.0; 3], [0.0, 0.0, 20.0], [250.0, 0.0, 20.0]], &[[0, 1], [1, 2]]);
    let outcome = searched(&structure, &Groups::single(&structure), &builder());
    assert!(!outcome.is_found() && outcome.proved);
    assert!(matches!(outcome.obstacle.unwrap().rule, ObstacleRule::WholeFrame { node: 2, sag_mm: Some(_) }));
}

/// The head has to stay 80 mm from struts that do not share a node with its own, and the pillars are 30 mm apart.
#[test]
fn a_head_that_can_stand_nowhere_is_named_with_what_is_in_its_way() {
    let structure =
        frame(&[[0.0; 3], [0.0, 0.0, 40.0], [30.0, 0.0, 40.0], [30.0, 0.0, 0.0]], &[[0, 1], [1, 2], [3, 2]]);
    let mut wide = builder();
    wide.clearance = Length::from_mm(80.0).unwrap();
    let outcome = searched(&structure, &Groups::single(&structure), &wide);
    assert!(!outcome.is_found() && outcome.proved);
    let obstacle = outcome.obstacle.unwrap();
    assert_eq!(obstacle.rule, ObstacleRule::NoDirection);
    assert!(!obstacle.struts.is_empty() && obstacle.strut.is_some());
    // With the clearance of the machine the beam comes last, and from either pillar.
    let outcome = searched(&structure, &Groups::single(&structure), &builder());
    let kinds: Vec<StepKind> = outcome.steps.iter().map(|step| step.kind).collect();
    assert_eq!(kinds, [StepKind::Ground, StepKind::Ground, StepKind::Connect]);
    assert_eq!(outcome.steps[2].struts, [1]);
}

/// The cost of the paper orders frames differently, and what keeps a frame from being built is the same.
#[test]
fn by_the_cost_of_the_paper_too_it_is_named_what_is_in_the_way() {
    let by_paper = |structure: &Structure, builder: &StrutBuilder, stop: bool| {
        let (weight, groups) = (abs(), Groups::single(structure));
        let task = Task { structure, groups: &groups, builder, weight: &weight };
        let layers = vec![0; structure.struts().len()];
        let outcome = search_by_paper(&task, &layers, 100, &mut |_| {
            if stop { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        let outcome = outcome.unwrap();
        assert!(!outcome.is_found());
        outcome
    };
    let soft = frame(&[[0.0; 3], [0.0, 0.0, 20.0], [250.0, 0.0, 20.0]], &[[0, 1], [1, 2]]);
    let outcome = by_paper(&soft, &builder(), false);
    assert!(outcome.proved, "whatever the order, it ends with the whole frame");
    assert!(matches!(outcome.obstacle.unwrap().rule, ObstacleRule::WholeFrame { node: 2, sag_mm: Some(_) }));
    let legs = frame(&[[0.0; 3], [300.0, 0.0, 0.0], [150.0, 0.0, 150.0]], &[[0, 2], [1, 2]]);
    let obstacle = by_paper(&legs, &builder(), false).obstacle.unwrap();
    assert!(
        matches!(obstacle.rule, ObstacleRule::SagsWith { node: 2, sag_mm: Some(sag) } if sag > 0.65),
        "{obstacle:?}"
    );
    assert!(obstacle.step == 1 && obstacle.strut.is_some(), "{obstacle:?}");
    let pillars =
        frame(&[[0.0; 3], [0.0, 0.0, 40.0], [30.0, 0.0, 40.0], [30.0, 0.0, 0.0]], &[[0, 1], [1, 2], [3, 2]]);
    let mut wide = builder();
    wide.clearance = Length::from_mm(80.0).unwrap();
    let outcome = by_paper(&pillars, &wide, false);
    assert_eq!((outcome.partial.first.len(), outcome.partial.last.len()), (1, 0), "a pillar stands");
    let obstacle = outcome.obstacle.unwrap();
    assert_eq!((obstacle.step, obstacle.rule), (2, ObstacleRule::NoDirection));
    assert!(!obstacle.struts.is_empty() && obstacle.strut.is_some(), "{obstacle:?}");
    let stopped = by_paper(&pillars, &builder(), true);
    assert_eq!((stopped.obstacle, stopped.proved), (None, false), "nothing was in the way of it");
    assert_eq!(stopped.partial, Partial::default(), "nor did anything stand");
}

#[test]
fn a_search_that_is_stopped_says_that_nothing_is_certain() {
    let structure = frame(&[[0.0; 3], [0.0, 0.0, 40.0], [30.0, 0.0, 40.0]], &[[0, 1], [1, 2]]);
    let (builder, weight, groups) = (builder(), abs(), Groups::single(&structure));
    let task = Task { structure: &structure, groups: &groups, builder: &builder, weight: &weight };
    let mut asked = 0;
    let outcome = search(&task, &SearchOptions::default(), &mut |progress| {
        asked += 1;
        if progress.taken > 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    let outcome = outcome.unwrap();
    assert!(!outcome.is_found() && !outcome.proved && asked > 1);
}

#[test]
fn a_group_that_cannot_be_placed_at_once_is_refused() {
    use wirebend_sequence::GroupError;
    let structure =
        frame(&[[0.0; 3], [0.0, 0.0, 40.0], [30.0, 0.0, 40.0], [30.0, 0.0, 0.0]], &[[0, 1], [1, 2], [3, 2]]);
    let of = |groups: &[Vec<EdgeId>]| Groups::together(&structure, groups);
    assert_eq!(of(&[vec![EdgeId(0), EdgeId(2)]]), Err(GroupError::InPieces { edge: EdgeId(0) }));
    assert_eq!(of(&[vec![EdgeId(7)]]), Err(GroupError::NoEdge { edge: EdgeId(7) }));
    assert_eq!(of(&[vec![EdgeId(1), EdgeId(2)]]).unwrap().all().len(), 2, "the rest is placed alone");
}

#[test]
fn a_vertex_that_the_tip_does_not_reach_is_named() {
    let structure = frame(&[[0.0; 3], [0.0, 0.0, 40.0], [30.0, 0.0, 40.0]], &[[0, 1], [1, 2]]);
    let mut small = builder();
    small.workspace = Some([Point3::new(-10.0, -10.0, 0.0), Point3::new(10.0, 10.0, 100.0)]);
    let outcome = searched(&structure, &Groups::single(&structure), &small);
    assert!(!outcome.is_found() && outcome.proved);
    assert_eq!(outcome.obstacle.unwrap().rule, ObstacleRule::OutOfReach { node: 2 });
    let (weight, groups) = (abs(), Groups::single(&structure));
    let task = Task { structure: &structure, groups: &groups, builder: &small, weight: &weight };
    let steps = searched(&structure, &groups, &builder()).steps;
    let given: Vec<GivenStep> = steps.iter().map(|step| GivenStep::of(step, &structure, &small)).collect();
    let vertex = VertexId(2);
    assert_eq!(check(&task, &given).violations, [Violation::OutOfReach { step: 2, vertex }]);
}
