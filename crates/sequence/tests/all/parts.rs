//! Frames of two parts, each on its own ground.

use nalgebra::Vector3;
use wirebend_core::checks::sequence::Violation;
use wirebend_core::wireframe::{EdgeId, Vertex, VertexId, Wireframe};
use wirebend_sequence::{GivenStep, Groups, LayerOptions, Structure, Task, check, layers};
use wirebend_tests_brute::Fault;

use super::brute;
use super::confirm::{confirmed, searched};
use super::frames::{abs, assembly, builder};

/// A frame twice, the second one so far aside.
fn twice(name: &str, aside: Vector3<f64>) -> Structure {
    let drawn = assembly(name);
    let count = u32::try_from(drawn.vertex_count()).unwrap();
    let mut made = Wireframe::new();
    for shift in [Vector3::zeros(), aside] {
        for (_, vertex) in drawn.vertices() {
            made.add_vertex(Vertex { position: vertex.position + shift, ..vertex }).unwrap();
        }
    }
    for first in [0, count] {
        for (_, edge) in drawn.edges() {
            made.add_edge(VertexId(edge.a.0 + first), VertexId(edge.b.0 + first)).unwrap();
        }
    }
    Structure::new(&made).unwrap()
}

/// 8 mm apart, so that the head has to keep out of the other part.
#[test]
fn two_parts_beside_each_other_are_both_built() {
    let structure = twice("simple_frame", Vector3::new(38.0, 0.0, 0.0));
    let (builder, weight, groups) = (builder(), abs(), Groups::single(&structure));
    let outcome = searched(&structure, &groups, &builder);
    assert!(outcome.is_found(), "{:?}", outcome.obstacle);
    assert_eq!(outcome.steps.len(), 38);
    let task = Task { structure: &structure, groups: &groups, builder: &builder, weight: &weight };
    let given = confirmed(&task, &outcome);

    // The two know of each other: a direction that is free in one part alone hits the other.
    let others: usize = given.iter().filter(|step| step.edges[0].0 >= 19).count();
    assert_eq!(others, 19);
    let alone = Structure::new(&assembly("simple_frame")).unwrap();
    let by_itself = searched(&alone, &Groups::single(&alone), &builder);
    let free = |steps: &[wirebend_sequence::Step]| -> usize {
        steps.iter().flat_map(|step| &step.joints).map(|joint| joint.free.len()).sum()
    };
    assert!(free(&outcome.steps) < 2 * free(&by_itself.steps), "{}", free(&outcome.steps));

    // One part alone is not all of it.
    let half: Vec<GivenStep> = given.iter().filter(|step| step.edges[0].0 < 19).cloned().collect();
    let missing: Vec<u32> = (19..38).collect();
    let edges = missing.iter().copied().map(EdgeId).collect();
    assert_eq!(check(&task, &half).violations, [Violation::Missing { edges }]);
    assert_eq!(brute::faults(&task, &half), [Fault::NeverBuilt { edges: missing }]);

    let layer = layers(&task, &[], &LayerOptions::default()).unwrap();
    assert_eq!(layer.len(), 38);
}

/// Both sag as one of them does alone.
#[test]
fn parts_far_from_each_other_are_built_as_each_alone() {
    let builder = builder();
    let alone = Structure::new(&assembly("simple_frame")).unwrap();
    let sag = |structure: &Structure| {
        let outcome = searched(structure, &Groups::single(structure), &builder);
        outcome.steps.last().unwrap().max_sag_mm
    };
    let both = sag(&twice("simple_frame", Vector3::new(0.0, 900.0, 0.0)));
    assert!((both - sag(&alone)).abs() < 1e-9 * both);
}
