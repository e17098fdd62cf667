//! How far what stands sags, as a frame of nothing else.

use std::collections::BTreeSet;

use nalgebra::Vector3;
use wirebend_frame::{Assembly, Load, Member, Model, NodalLoad, NodeId, SectionId, Support};

use crate::Task;

/// The vertex that sags most, and how far, mm; none where it does not stand.
pub(crate) fn sag(task: &Task, edges: &[u32]) -> Option<(u32, f64)> {
    let ends: Vec<[u32; 2]> = edges.iter().map(|edge| task.edges[edge]).collect();
    let used: Vec<u32> = ends.iter().flatten().copied().collect::<BTreeSet<_>>().into_iter().collect();
    let place = |vertex: u32| used.binary_search(&vertex).map_or(NodeId(0), NodeId);
    let supports = used.iter().filter(|vertex| task.vertices[vertex].support);
    let model = Model {
        nodes: used.iter().map(|&vertex| task.at(vertex)).collect(),
        members: ends.iter().map(|ends| Member::new(place(ends[0]), place(ends[1]), SectionId(0))).collect(),
        sections: vec![task.section],
        supports: supports
            .map(|&vertex| Support { node: place(vertex), fixed: task.vertices[&vertex].fixed })
            .collect(),
    };
    let assembly = Assembly::new(&model).ok()?;
    // A gram is 1e-6 t.
    let joints = used.iter().map(|&vertex| NodalLoad {
        node: place(vertex),
        force: task.gravity * task.vertices[&vertex].joint_g * 1e-6,
        moment: Vector3::zeros(),
    });
    let load = Load { gravity: task.gravity, nodal: joints.collect(), ..Load::default() };
    let response = assembly.factor(&assembly.all()).ok()?.solve(&load).ok()?;
    let (node, mm) = response.max_displacement();
    Some((used[node.0], mm))
}
