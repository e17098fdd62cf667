//! A sequence checked by brute force: motion and struts sampled, each frame that stands solved from nothing.

use std::collections::BTreeSet;

use nalgebra::{Point3, Vector3};
use wirebend_core::sequence::{GivenStep, Task};
use wirebend_core::wireframe::VertexId;
use wirebend_frame::{Assembly, Load, Member, Model, NodalLoad, NodeId, SectionId, Support};

/// How many places of a motion and of a strut are looked at.
const PLACES: u32 = 30;

/// How deep a point is in FrameFab's head.
fn depth(from_tip: &Vector3<f64>, axis: &Vector3<f64>) -> f64 {
    let z = from_tip.dot(axis);
    let rho = from_tip.cross(axis).norm();
    let angle = 30_f64.to_radians();
    [z * angle.sin() - rho * angle.cos(), 11.547 - rho, z, 120.0 - z]
        .into_iter()
        .fold(f64::INFINITY, f64::min)
}

/// What is wrong with steps of one strut each.
pub fn faults(task: &Task<'_>, steps: &[GivenStep]) -> Vec<String> {
    let structure = task.structure;
    let at = |vertex: VertexId| structure.nodes().iter().find(|node| node.vertex == vertex).unwrap();
    let ends = |step: &GivenStep| {
        structure.struts()[structure.strut_of(step.edges[0]).unwrap()]
            .ends
            .map(|node| structure.nodes()[node].vertex)
    };
    let mut faults = Vec::new();
    let mut built: BTreeSet<VertexId> =
        structure.nodes().iter().filter(|node| node.support).map(|node| node.vertex).collect();
    let mut standing: Vec<[VertexId; 2]> = Vec::new();
    for (k, step) in steps.iter().enumerate() {
        let (strut, joint) = (ends(step), &step.joints[0]);
        if !built.contains(&joint.vertex) {
            faults.push(format!("step {k} starts where nothing is built"));
        }
        let to = if strut[0] == joint.vertex { strut[1] } else { strut[0] };
        let (begin, way) = (at(joint.vertex).at, at(to).at - at(joint.vertex).at);
        let axis = joint.directions[0];
        let max: f64 = if built.contains(&to) { 90.0 } else { 60.0 };
        if axis.angle(&way).to_degrees() >= max {
            faults.push(format!("step {k} leans over its way"));
        }
        for other in &standing {
            let shared = other.iter().any(|end| strut.contains(end));
            let apart = task.builder.clearance.mm() + task.weight.section.radius;
            let allowed = if shared { task.builder.touch.mm() } else { -apart };
            let deepest = deepest([begin, begin + way], other.map(|vertex| at(vertex).at), &axis);
            // Outside the head the depth is what the search keeps to: minus a bound below the distance. A sampled point is only ever less
            // deep than the deepest.
            if deepest > allowed + 0.002 {
                faults.push(format!("step {k} has {other:?} {deepest} mm deep in the head"));
            }
        }
        built.extend(strut);
        standing.push(strut);
        let sag = sag(task, &standing);
        if sag > task.builder.max_sag.mm() {
            faults.push(format!("after step {k} it sags by {sag} mm"));
        }
    }
    if standing.iter().collect::<BTreeSet<_>>().len() != structure.struts().len() {
        faults.push("struts are missing".to_owned());
    }
    faults
}

fn deepest(motion: [Point3<f64>; 2], strut: [Point3<f64>; 2], axis: &Vector3<f64>) -> f64 {
    let part = |k: u32| f64::from(k) / f64::from(PLACES);
    // No point moves farther from the middle than half of both.
    let middle = nalgebra::center(&strut[0], &strut[1]) - nalgebra::center(&motion[0], &motion[1]);
    let half = f64::midpoint((motion[1] - motion[0]).norm(), (strut[1] - strut[0]).norm());
    if depth(&middle, axis) + half < 0.0 {
        return f64::NEG_INFINITY;
    }
    let mut deepest = f64::NEG_INFINITY;
    for i in 0..=PLACES {
        let tip = motion[0] + (motion[1] - motion[0]) * part(i);
        for j in 0..=PLACES {
            deepest = deepest.max(depth(&(strut[0] + (strut[1] - strut[0]) * part(j) - tip), axis));
        }
    }
    deepest
}

/// The sag after each of some steps of one strut; infinite where it does not stand.
pub fn sags(task: &Task<'_>, steps: &[GivenStep]) -> Vec<f64> {
    let structure = task.structure;
    let mut standing: Vec<[VertexId; 2]> = Vec::new();
    let sags = steps.iter().map(|step| {
        let strut = structure.struts()[structure.strut_of(step.edges[0]).unwrap()];
        standing.push(strut.ends.map(|node| structure.nodes()[node].vertex));
        sag(task, &standing)
    });
    sags.collect()
}

/// The sag of a frame of what stands and nothing else.
fn sag(task: &Task<'_>, standing: &[[VertexId; 2]]) -> f64 {
    let used: Vec<VertexId> =
        standing.iter().flatten().copied().collect::<BTreeSet<_>>().into_iter().collect();
    let place = |vertex: VertexId| NodeId(used.iter().position(|used| *used == vertex).unwrap());
    let node = |vertex: VertexId| task.structure.nodes().iter().find(|node| node.vertex == vertex).unwrap();
    let model = Model {
        nodes: used.iter().map(|&vertex| node(vertex).at).collect(),
        members: standing
            .iter()
            .map(|ends| Member::new(place(ends[0]), place(ends[1]), SectionId(0)))
            .collect(),
        sections: vec![task.weight.section],
        supports: used
            .iter()
            .filter(|&&vertex| node(vertex).support)
            .map(|&vertex| Support { node: place(vertex), fixed: node(vertex).fixed })
            .collect(),
    };
    let assembly = Assembly::new(&model).unwrap();
    let joints = used.iter().map(|&vertex| NodalLoad {
        node: place(vertex),
        force: task.weight.gravity * node(vertex).joint_g * 1e-6,
        moment: Vector3::zeros(),
    });
    let load = Load { gravity: task.weight.gravity, nodal: joints.collect(), ..Load::default() };
    let response = assembly.factor(&assembly.all()).map(|factor| factor.solve(&load));
    // What does not stand at all sags without end.
    response.ok().and_then(Result::ok).map_or(f64::INFINITY, |response| response.max_displacement().1)
}
