//! Supports that do not hold all, and joints that weigh something.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use nalgebra::Point3;
use wirebend_core::checks::sequence::Violation;
use wirebend_core::units::Length;
use wirebend_core::wireframe::{Joint, JointKind, Vertex, VertexId, Wireframe};
use wirebend_sequence::{
    GivenStep, Groups, ObstacleRule, Outcome, Structure, StrutBuilder, Task, check, stiffest_order,
};

use super::brute;
use super::confirm;
use super::frames::{abs, builder, bunny};

type Fixed = BTreeMap<VertexId, [bool; 6]>;

const PINNED: [bool; 6] = [true, true, true, false, false, false];
/// It rests on the ground, and slides and turns on it.
const RESTING: [bool; 6] = [false, false, true, false, false, false];

/// What is at height 0 is a support; joints of so many grams.
fn frame(points: &[([f64; 3], f64)], edges: &[[u32; 2]]) -> Wireframe {
    let mut made = Wireframe::new();
    for (point, mass_g) in points {
        let mut vertex = Vertex::at(Point3::from(*point));
        vertex.support = point[2] == 0.0;
        vertex.joint = (*mass_g > 0.0).then_some(Joint { kind: JointKind::ZipTie, mass_g: *mass_g });
        made.add_vertex(vertex).unwrap();
    }
    for [a, b] in edges {
        made.add_edge(VertexId(*a), VertexId(*b)).unwrap();
    }
    made
}

/// The structure of a frame whose supports hold no more than this.
fn held(wireframe: &Wireframe, fixed: &Fixed) -> Structure {
    let mut made = Wireframe::new();
    for (id, mut vertex) in wireframe.vertices() {
        if let Some(fixed) = fixed.get(&id) {
            vertex.free = fixed.map(|fixed| !fixed);
        }
        made.insert_vertex(id, vertex).unwrap();
    }
    for (id, edge) in wireframe.edges() {
        made.insert_edge(id, edge).unwrap();
    }
    Structure::new(&made).unwrap()
}

fn searched(structure: &Structure, builder: &StrutBuilder) -> Outcome {
    confirm::searched(structure, &Groups::single(structure), builder)
}

fn agreed(structure: &Structure, builder: &StrutBuilder, outcome: &Outcome) -> Vec<f64> {
    let (weight, groups) = (abs(), Groups::single(structure));
    confirm::agreed(&Task { structure, groups: &groups, builder, weight: &weight }, outcome)
}

/// The sags of a sequence by brute force.
fn sags_of(structure: &Structure, outcome: &Outcome) -> Vec<f64> {
    let (builder, weight, groups) = (builder(), abs(), Groups::single(structure));
    let task = Task { structure, groups: &groups, builder: &builder, weight: &weight };
    let given: Vec<GivenStep> =
        outcome.steps.iter().map(|step| GivenStep::of(step, structure, &builder)).collect();
    brute::of_task(&task).sags(&brute::of_steps(&given))
}

/// A pillar with an arm, by the textbook: what a joint weighs counts from the strut that reaches it.
#[test]
fn a_joint_weighs_from_the_strut_that_reaches_it() {
    let (height, arm, top_g, tip_g) = (40.0, 40.0, 5.0, 0.2);
    let points = [([0.0; 3], 1000.0), ([0.0, 0.0, height], top_g), ([arm, 0.0, height], tip_g)];
    let structure = Structure::new(&frame(&points, &[[0, 1], [1, 2]])).unwrap();
    let outcome = searched(&structure, &builder());
    let sags = agreed(&structure, &builder(), &outcome);

    let (g, e, d) = (9806.33_f64, 3457.0, 1.5_f64);
    let (area, inertia) = (PI * d * d / 4.0, PI * d.powi(4) / 64.0);
    let q = 1210e-12 * area * g;
    let (top, tip) = (top_g * 1e-6 * g, tip_g * 1e-6 * g);
    let short = |load: f64| (load * height + q * height * height / 2.0) / (e * area);
    assert!((sags[0] - short(top)).abs() < 1e-9 * sags[0], "{sags:?}");
    let moment = tip * arm + q * arm * arm / 2.0;
    let aside = moment * height * height / (2.0 * e * inertia);
    let turned = moment * height / (e * inertia) * arm;
    let bent = (tip * arm.powi(3) / 3.0 + q * arm.powi(4) / 8.0) / (e * inertia);
    let down = short(top + tip + q * arm) + turned + bent;
    assert!((sags[1] - down.hypot(aside)).abs() < 1e-9 * sags[1], "{sags:?} {down} {aside}");

    // So heavy that the arm is too soft.
    let points = [points[0], points[1], (points[2].0, 2.0)];
    let structure = Structure::new(&frame(&points, &[[0, 1], [1, 2]])).unwrap();
    let rule = searched(&structure, &builder()).obstacle.unwrap().rule;
    assert!(
        matches!(rule, ObstacleRule::WholeFrame { node: 2, sag_mm: Some(sag) } if sag > 0.65),
        "{rule:?}"
    );
}

/// One leg is held altogether, the other only rests on the ground: it stands once it leans on the first, and not before.
#[test]
fn a_leg_that_only_rests_on_the_ground_comes_second() {
    let points = [([0.0; 3], 0.0), ([60.0, 0.0, 0.0], 0.0), ([30.0, 0.0, 50.0], 0.5)];
    let wireframe = frame(&points, &[[1, 2], [0, 2]]);
    let fixed = Fixed::from([(VertexId(1), RESTING)]);
    let structure = held(&wireframe, &fixed);
    let outcome = searched(&structure, &builder());
    let order: Vec<usize> = outcome.steps.iter().map(|step| step.struts[0]).collect();
    assert_eq!(order, [1, 0]);
    let sags = agreed(&structure, &builder(), &outcome);
    let clamped = Structure::new(&wireframe).unwrap();
    let stiffer = sags_of(&clamped, &outcome);
    assert!((sags[0] - stiffer[0]).abs() < 1e-12 && sags[1] > 1.01 * stiffer[1], "{sags:?} {stiffer:?}");
    // The other way round it falls over at once.
    let (builder, weight, groups) = (builder(), abs(), Groups::single(&structure));
    let task = Task { structure: &structure, groups: &groups, builder: &builder, weight: &weight };
    let mut given: Vec<GivenStep> =
        outcome.steps.iter().map(|step| GivenStep::of(step, &structure, &builder)).collect();
    given.reverse();
    given[0].joints[0].vertex = VertexId(1);
    let checked = check(&task, &given);
    assert_eq!(checked.sags_mm[0], None);
    assert!(
        checked.violations.iter().any(|found| matches!(found, Violation::Sags { step: 1, sag: None, .. })),
        "{:?}",
        checked.violations
    );
    // The order by stiffness alone knows it, too.
    assert_eq!(stiffest_order(&task).unwrap().0, [1, 0]);
}

/// With its feet pinned the bunny sags by 0.436273 mm, as two other programs say. But no pillar stands alone on a foot that turns.
#[test]
fn feet_that_turn_hold_the_finished_bunny_and_no_first_pillar() {
    let wireframe = bunny();
    let feet = wireframe.vertices().filter(|(_, vertex)| vertex.support).map(|(id, _)| (id, PINNED));
    let structure = held(&wireframe, &feet.collect());
    let mut exact = builder();
    exact.max_sag = Length::from_mm(0.43).unwrap();
    let rule = searched(&structure, &exact).obstacle.unwrap().rule;
    assert!(
        matches!(rule, ObstacleRule::WholeFrame { sag_mm: Some(sag), .. } if (sag - 0.436_273).abs() < 1e-5 * sag),
        "{rule:?}"
    );
    let outcome = searched(&structure, &builder());
    assert!(!outcome.is_found() && outcome.proved, "it is known without trying every order");
    assert!(matches!(outcome.obstacle.unwrap().rule, ObstacleRule::Sags { .. }));
}

/// The bunny on ten feet that are held and two that rest, with joints that weigh a fifth of it: each of its 179 steps as brute force
/// has it.
#[test]
fn every_step_of_the_bunny_is_as_brute_force_has_it() {
    let drawn = bunny();
    let mut wireframe = Wireframe::new();
    for (id, mut vertex) in drawn.vertices() {
        vertex.joint = Some(Joint { kind: JointKind::Solder, mass_g: 0.01 + 0.0005 * f64::from(id.0) });
        wireframe.insert_vertex(id, vertex).unwrap();
    }
    for (id, edge) in drawn.edges() {
        wireframe.insert_edge(id, edge).unwrap();
    }
    let feet: Vec<VertexId> =
        drawn.vertices().filter(|(_, vertex)| vertex.support).map(|(id, _)| id).collect();
    let fixed = Fixed::from([(feet[0], RESTING), (feet[7], PINNED)]);
    let structure = held(&wireframe, &fixed);
    let mut builder = builder();
    builder.ground_first = false;
    let outcome = searched(&structure, &builder);
    assert!(outcome.is_found(), "{:?}", outcome.obstacle);
    let sags = agreed(&structure, &builder, &outcome);
    assert_eq!(sags.len(), 179);
    assert!(sags[178] > 1.15 * 0.427_187, "the joints count: {}", sags[178]);
}
