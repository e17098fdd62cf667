//! How far what stands of a frame sags under its own weight.

use nalgebra::Vector3;
use wirebend_frame::{
    Assembly, Flexibility, Load, Member, MemberId, MemberSet, Model, ModelError, NodeId, Section, SectionId,
    SolveError, Support, Unstable,
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
    gravity: Vector3<f64>,
}

/// The frame of a structure, supports held altogether.
pub(super) fn model(structure: &Structure, section: &Section) -> Model {
    let member = |ends: [usize; 2]| Member::new(NodeId(ends[0]), NodeId(ends[1]), SectionId(0));
    let supports = structure.nodes().iter().enumerate().filter(|(_, node)| node.support);
    Model {
        nodes: structure.nodes().iter().map(|node| node.at).collect(),
        members: structure.struts().iter().map(|strut| member(strut.ends)).collect(),
        sections: vec![*section],
        supports: supports.map(|(node, _)| Support::clamped(NodeId(node))).collect(),
    }
}

impl Stability {
    pub fn new(structure: &Structure, weight: &Weight) -> Result<Self, ModelError> {
        let load = Load { gravity: weight.gravity, ..Load::default() };
        let assembly = Assembly::new(&model(structure, &weight.section))?;
        Ok(Self { assembly, weight: load, gravity: weight.gravity })
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
        Flexibility::new(&self.assembly, self.gravity)
    }
}

/// The node that is to blame for a part that does not stand.
pub(super) fn unsteady_node(unstable: &Unstable) -> usize {
    match unstable {
        Unstable::PartWithoutSupport { node, .. }
        | Unstable::Mechanism { node }
        | Unstable::TooSoft { node, .. } => node.0,
    }
}
