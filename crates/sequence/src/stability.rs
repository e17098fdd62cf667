//! How far what stands of a frame sags under its own weight and that of its joints.

use nalgebra::Vector3;
use wirebend_frame::{
    Assembly, Flexibility, Load, Member, MemberId, MemberSet, Model, ModelError, NodeId, NodeMass, Section,
    SectionId, SolveError, Support, Unstable,
};

use super::structure::Structure;

/// What the struts are made of and what pulls at them.
#[derive(Debug, Clone, PartialEq)]
pub struct Weight {
    /// Their cross-section.
    pub section: Section,
    /// The acceleration that pulls at them, mm/s².
    pub gravity: Vector3<f64>,
}

/// How far a frame sags, and where.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sag {
    /// The largest displacement of a node, mm.
    pub mm: f64,
    /// The node that moves so far.
    pub node: usize,
}

/// The stiffness of a structure, for any part of it.
pub(super) struct Stability {
    assembly: Assembly,
    weight: Load,
}

/// The frame of a structure.
pub(super) fn model(structure: &Structure, section: &Section) -> Model {
    let member = |ends: [usize; 2]| Member::new(NodeId(ends[0]), NodeId(ends[1]), SectionId(0));
    let supports = structure.nodes().iter().enumerate().filter(|(_, node)| node.support);
    Model {
        nodes: structure.nodes().iter().map(|node| node.at).collect(),
        members: structure.struts().iter().map(|strut| member(strut.ends)).collect(),
        sections: vec![*section],
        supports: supports.map(|(node, there)| Support { node: NodeId(node), fixed: there.fixed }).collect(),
    }
}

impl Stability {
    pub fn new(structure: &Structure, weight: &Weight) -> Result<Self, ModelError> {
        let joints = structure.nodes().iter().enumerate().filter(|(_, node)| node.joint_g > 0.0);
        // Grams are 1e-6 t.
        let masses =
            joints.map(|(k, node)| NodeMass { node: NodeId(k), mass: node.joint_g * 1.0e-6 }).collect();
        let load = Load { gravity: weight.gravity, masses, ..Load::default() };
        Ok(Self { assembly: Assembly::new(&model(structure, &weight.section))?, weight: load })
    }

    /// The sag of some struts; zero of none.
    pub fn sag(&self, struts: impl IntoIterator<Item = usize>) -> Result<Sag, Unstable> {
        let mut members = MemberSet::empty(self.assembly.model().members.len());
        struts.into_iter().for_each(|strut| {
            members.insert(MemberId(strut));
        });
        if members.is_empty() {
            return Ok(Sag { mm: 0.0, node: 0 });
        }
        let response = match self.assembly.factor(&members)?.solve(&self.weight) {
            Ok(response) => response,
            Err(SolveError::Unstable(unstable)) => return Err(unstable),
            // The load is the weight of what is there.
            Err(SolveError::Load(_)) => return Err(Unstable::Mechanism { node: NodeId(0) }),
        };
        let (node, mm) = response.max_displacement();
        Ok(Sag { mm, node: node.0 })
    }

    /// The flexibility of nothing, to which struts are added.
    pub fn flexibility(&self) -> Flexibility<'_> {
        Flexibility::with_masses(&self.assembly, self.weight.gravity, &self.weight.masses)
    }
}

/// The node that is to blame for a part that does not stand, and how far it would move, mm, where that is known and beyond `most_mm`.
pub(super) fn unsteady(unstable: &Unstable, most_mm: f64) -> (usize, Option<f64>) {
    match unstable {
        Unstable::PartWithoutSupport { node, .. } | Unstable::Mechanism { node } => (node.0, None),
        Unstable::TooSoft { node, displacement_mm, .. } => {
            (node.0, Some(*displacement_mm).filter(|mm| mm.is_finite() && *mm > most_mm))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn how_far_a_node_would_move_is_known_of_what_is_too_soft_alone() {
        let soft = |displacement_mm| Unstable::TooSoft { node: NodeId(3), displacement_mm, size_mm: 20.0 };
        assert_eq!(unsteady(&soft(500.0), 0.65), (3, Some(500.0)));
        assert_eq!(unsteady(&soft(500.0), 1000.0), (3, None), "it is refused although so much is allowed");
        assert_eq!(unsteady(&soft(f64::INFINITY), 0.65), (3, None));
        assert_eq!(unsteady(&Unstable::Mechanism { node: NodeId(2) }, 0.65), (2, None));
    }
}
