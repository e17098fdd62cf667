//! Head directions against those that FrameFab's authors published for their bunny.

use nalgebra::{Point3, Vector3};
use wirebend_collide::{DirectionSet, Head, Passage};
use wirebend_core::checks::sequence::{StepKind, Violation};
use wirebend_core::units::Angle;
use wirebend_core::wireframe::{Vertex, Wireframe};
use wirebend_sequence::{GivenJoint, GivenStep, Groups, HeadDirections, Structure, Task, check};

use super::frames::{HEAD, PublishedStep, abs, assembly, builder, bunny, published_bunny};

fn directions() -> HeadDirections {
    HeadDirections::each(Angle::from_deg(18.0).unwrap()).unwrap()
}

/// Our direction of which a published one, rounded to three decimals, tells.
fn ours_of(directions: &HeadDirections, published: [f64; 3]) -> usize {
    let published = Vector3::from(published);
    let near = |axis: &Vector3<f64>| (axis - published).norm() < 0.003;
    directions.all().iter().position(|axis| near(axis)).expect("a direction of the published grid")
}

/// How many of the published directions are free, and how many of ours, with the motion from end to end or tested at its ends alone.
/// Of each published step some are.
fn counted(steps: &[PublishedStep], ends_only: bool) -> [usize; 2] {
    let (head, directions) = (Head::new(&HEAD).unwrap(), directions());
    let [mut published, mut ours] = [0; 2];
    for (k, step) in steps.iter().enumerate().filter(|(_, step)| step.kind != "support") {
        let max = if step.kind == "create" { 60.0 } else { 90.0 };
        let mut free = directions.within(Angle::from_deg(max).unwrap(), &(step.to - step.from));
        let motions: &[[&Point3<f64>; 2]] =
            if ends_only { &[[&step.from; 2], [&step.to; 2]] } else { &[[&step.from, &step.to]] };
        for before in &steps[..k] {
            for &motion in motions {
                let passage =
                    Passage { motion, piece: [&before.from, &before.to], limit: -0.1, tolerance: 1e-3 };
                free = free.without(head.meets(&passage, directions.all(), free));
            }
        }
        ours += free.len();
        let of_step =
            step.directions.iter().filter(|given| free.contains(ours_of(&directions, **given))).count();
        assert!(of_step > 0, "step {k} is left without a direction");
        published += of_step;
    }
    [published, ours]
}

/// FrameFab looks at both ends and at eight triangles between them, and so misses struts that the head meets on its way. The
/// figures were computed by sampling each motion and each strut at 201 places.
#[test]
fn of_the_published_directions_those_are_free_that_dense_sampling_finds_free() {
    let steps = published_bunny();
    let given: usize =
        steps.iter().filter(|step| step.kind != "support").map(|step| step.directions.len()).sum();
    assert_eq!(given, 6_928);
    let whole = counted(&steps, false);
    assert!(whole[0].abs_diff(6_552) <= 6 && whole[1].abs_diff(7_387) <= 7, "{whole:?}");
    let ends = counted(&steps, true);
    assert!(ends[0] == 6_928 && ends[1].abs_diff(8_116) <= 8, "{ends:?}");
}

/// The published sequence as edges of a design, with three directions for each: what is within 0.02 mm is one vertex.
fn published_design(steps: &[PublishedStep]) -> (Wireframe, Vec<GivenStep>) {
    let mut made = Wireframe::new();
    let vertex_at = |at: Point3<f64>, support: bool, made: &mut Wireframe| {
        let there =
            made.vertices().find(|(_, vertex)| (vertex.position - at).norm() < 0.02).map(|(id, _)| id);
        there.unwrap_or_else(|| made.add_vertex(Vertex { support, ..Vertex::at(at) }).unwrap())
    };
    let given = steps.iter().map(|step| {
        let from = vertex_at(step.from, step.kind == "support", &mut made);
        let to = vertex_at(step.to, false, &mut made);
        let directions = step.directions.iter().take(3).map(|direction| Vector3::from(*direction)).collect();
        let kind = match step.kind.as_str() {
            "support" => StepKind::Ground,
            "create" => StepKind::Create,
            _ => StepKind::Connect,
        };
        GivenStep {
            edges: vec![made.add_edge(from, to).unwrap()],
            kind: Some(kind),
            joints: vec![GivenJoint { vertex: from, directions }],
        }
    });
    let given = given.collect();
    (made, given)
}

/// What stands of the published sequence never sags by more than the whole, as two other programs computed.
#[test]
fn the_published_sequence_hangs_together_and_stands_at_every_step() {
    let (design, given) = published_design(&published_bunny());
    let structure = Structure::new(&design).unwrap();
    let (builder, weight, groups) = (builder(), abs(), Groups::single(&structure));
    let task = Task { structure: &structure, groups: &groups, builder: &builder, weight: &weight };
    let checked = check(&task, &given);
    // Of the head it may say something: here it stays a strut's radius from the others, and FrameFab's touches them.
    let others = checked.violations.iter().filter(|found| !matches!(found, Violation::HeadMeets { .. }));
    assert_eq!(others.collect::<Vec<_>>(), [&Violation::Empty { step: 0 }; 0]);
    let sags: Vec<f64> = checked.sags_mm.iter().map(|sag| sag.unwrap()).collect();
    let (worst, whole) = (sags.iter().copied().fold(0.0, f64::max), sags.last().copied().unwrap());
    assert!(worst <= whole * (1.0 + 1e-9) && sags.len() == 179, "{worst} before {whole}");
    let free: usize = checked.free.iter().flatten().sum();
    let given: usize = given.iter().flat_map(|step| &step.joints).map(|joint| joint.directions.len()).sum();
    assert!(free > given / 2 && free <= given, "{free} of {given} are free");
}

/// The bits of all ordered pairs of struts: how often one is in the way of the head that goes along the other.
fn colliding(wireframe: &Wireframe) -> usize {
    let structure = Structure::new(wireframe).unwrap();
    let (head, directions) = (Head::new(&HEAD).unwrap(), directions());
    let all = DirectionSet::first(directions.all().len());
    let count = structure.struts().len();
    let met = (0..count)
        .flat_map(|strut| (0..count).filter(move |&other| other != strut).map(move |other| (strut, other)));
    met.map(|(strut, other)| {
        let passage = Passage {
            motion: structure.ends(strut),
            piece: structure.ends(other),
            limit: -0.1,
            tolerance: 1e-3,
        };
        head.meets(&passage, directions.all(), all).len()
    })
    .sum()
}

/// The figures were computed by sampling.
#[test]
fn struts_are_in_the_way_in_as_many_directions_as_brute_force_finds() {
    for (name, wireframe, wanted) in
        [("bunny", bunny(), 152_420_usize), ("C_shape", assembly("C_shape"), 191_540)]
    {
        let found = colliding(&wireframe);
        assert!(found.abs_diff(wanted) <= wanted / 500, "{name}: {found} instead of {wanted}");
    }
}
