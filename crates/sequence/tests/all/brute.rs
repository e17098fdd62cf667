//! A task and a sequence as brute force takes them.

use wirebend_core::checks::sequence::StepKind;
use wirebend_sequence::{GivenStep, Task};
use wirebend_tests_brute as brute;

/// All that is wrong with a sequence, by brute force.
pub fn faults(task: &Task<'_>, steps: &[GivenStep]) -> Vec<brute::Fault> {
    of_task(task).faults(&of_steps(steps))
}

pub fn of_task(task: &Task<'_>) -> brute::Task {
    let (structure, builder) = (task.structure, task.builder);
    let vertices = structure.nodes().iter().map(|node| {
        let vertex =
            brute::Vertex { at: node.at, support: node.support, fixed: node.fixed, joint_g: node.joint_g };
        (node.vertex.0, vertex)
    });
    let edges = structure.struts().iter().map(|strut| {
        let ends = strut.ends.map(|node| structure.nodes()[node].vertex.0);
        (strut.edge.0, ends)
    });
    let section = task.weight.section;
    assert!(section.iy.to_bits() == section.iz.to_bits(), "a round section");
    brute::Task {
        vertices: vertices.collect(),
        edges: edges.collect(),
        section: brute::Section {
            radius_mm: section.radius,
            e_mpa: section.e,
            g_mpa: section.g,
            density_t_mm3: section.density,
        },
        gravity: task.weight.gravity,
        machine: brute::Machine {
            outline: builder.head.outline().to_vec(),
            places: builder.places,
            max_create_deg: builder.max_create.deg(),
            max_connect_deg: builder.max_connect.deg(),
            touch_mm: builder.touch.mm(),
            clearance_mm: builder.clearance.mm(),
            ground_first: builder.ground_first,
            max_sag_mm: builder.max_sag.mm(),
            workspace: builder.workspace,
        },
    }
}

pub fn of_steps(steps: &[GivenStep]) -> Vec<brute::Step> {
    let steps = steps.iter().map(|step| brute::Step {
        edges: step.edges.iter().map(|edge| edge.0).collect(),
        kind: step.kind.map(|kind| match kind {
            StepKind::Ground => brute::Kind::Ground,
            StepKind::Create => brute::Kind::Create,
            StepKind::Connect => brute::Kind::Connect,
        }),
        joints: step.joints.iter().map(|joint| (joint.vertex.0, joint.directions.clone())).collect(),
    });
    steps.collect()
}
