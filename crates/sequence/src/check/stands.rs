//! The sag of what stands, as a frame of nothing else.

use nalgebra::Vector3;
use wirebend_core::wireframe::VertexId;
use wirebend_frame::{
    Assembly, Load, Member, Model, NodalLoad, NodeId, SectionId, SolveError, Support, Unstable,
};

use crate::search::Task;

/// Two ways to compute the same differ by less.
pub(super) const ROUNDING_MM: f64 = 1e-6;

pub(super) struct Sagging {
    /// None where it moves freely.
    pub mm: Option<f64>,
    pub vertex: VertexId,
}

pub(super) fn sag(task: &Task<'_>, standing: &[usize]) -> Sagging {
    let structure = task.structure;
    let mut used: Vec<usize> = standing.iter().flat_map(|&strut| structure.struts()[strut].ends).collect();
    used.sort_unstable();
    used.dedup();
    // Every node of a strut that stands is among those used.
    let place = |node: usize| NodeId(used.partition_point(|&before| before < node));
    let vertex = |node: NodeId| structure.nodes()[used.get(node.0).copied().unwrap_or(0)].vertex;
    let members = standing.iter().map(|&strut| {
        let [a, b] = structure.struts()[strut].ends;
        Member::new(place(a), place(b), SectionId(0))
    });
    let supports = used.iter().filter(|&&node| structure.nodes()[node].support);
    let model = Model {
        nodes: used.iter().map(|&node| structure.nodes()[node].at).collect(),
        members: members.collect(),
        sections: vec![task.weight.section],
        supports: supports
            .map(|&node| Support { node: place(node), fixed: structure.nodes()[node].fixed })
            .collect(),
    };
    let Ok(assembly) = Assembly::new(&model) else { return Sagging { mm: None, vertex: vertex(NodeId(0)) } };
    // Grams are 1e-6 t.
    let of_joints = used.iter().map(|&node| NodalLoad {
        node: place(node),
        force: task.weight.gravity * (structure.nodes()[node].joint_g * 1.0e-6),
        moment: Vector3::zeros(),
    });
    let load = Load { gravity: task.weight.gravity, nodal: of_joints.collect(), ..Load::default() };
    let response = match assembly.factor(&assembly.all()) {
        Ok(factor) => factor.solve(&load),
        Err(unstable) => Err(SolveError::Unstable(unstable)),
    };
    match response {
        Ok(response) => {
            let (node, mm) = response.max_displacement();
            Sagging { mm: Some(mm), vertex: vertex(node) }
        }
        Err(SolveError::Unstable(Unstable::TooSoft { node, displacement_mm, .. })) => {
            // It is refused however much is allowed.
            let most = task.builder.max_sag.mm() + ROUNDING_MM;
            let mm = Some(displacement_mm).filter(|mm| mm.is_finite() && *mm > most);
            Sagging { mm, vertex: vertex(node) }
        }
        Err(SolveError::Unstable(
            Unstable::PartWithoutSupport { node, .. } | Unstable::Mechanism { node },
        )) => Sagging { mm: None, vertex: vertex(node) },
        Err(SolveError::Load(_)) => Sagging { mm: None, vertex: vertex(NodeId(0)) },
    }
}
