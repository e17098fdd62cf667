//! Which members hang together.

use crate::assembly::Assembly;
use crate::error::Unstable;
use crate::member_set::MemberSet;
use crate::model::{MemberId, NodeId};

/// Sets of nodes that members join, found by halving paths.
pub(crate) struct Parts {
    parent: Vec<usize>,
}

impl Parts {
    pub fn new(assembly: &Assembly, members: &MemberSet) -> Self {
        let mut parts = Self { parent: (0..assembly.model().nodes.len()).collect() };
        for member in members.iter() {
            let member = &assembly.model().members[member.0];
            let (a, b) = (parts.root(member.a.0), parts.root(member.b.0));
            parts.parent[a.max(b)] = a.min(b);
        }
        parts
    }

    /// The first node of the part that a node belongs to.
    pub fn root(&mut self, node: usize) -> usize {
        let mut at = node;
        while self.parent[at] != at {
            self.parent[at] = self.parent[self.parent[at]];
            at = self.parent[at];
        }
        at
    }
}

/// Refuses a part that nothing holds. Whether what holds it is enough, its stiffness says.
pub(crate) fn check(assembly: &Assembly, members: &MemberSet) -> Result<(), Unstable> {
    let mut parts = Parts::new(assembly, members);
    let mut holds = vec![false; assembly.model().nodes.len()];
    for support in &assembly.model().supports {
        if support.fixed.contains(&true) {
            holds[parts.root(support.node.0)] = true;
        }
    }
    let root_of = |parts: &mut Parts, member: MemberId| parts.root(assembly.model().members[member.0].a.0);
    let Some(root) = members.iter().map(|member| root_of(&mut parts, member)).find(|&root| !holds[root])
    else {
        return Ok(());
    };
    let members = members.iter().filter(|&member| root_of(&mut parts, member) == root).collect();
    Err(Unstable::PartWithoutSupport { node: NodeId(root), members })
}
