//! What is placed at once: a strut, or a wire or a rod of several.

use std::collections::HashSet;

use wirebend_core::wireframe::EdgeId;

use super::structure::Structure;

/// Why edges are no group of a structure.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum GroupError {
    /// A group names an edge that the design has not.
    #[error("there is no edge {edge}")]
    NoEdge {
        /// The edge.
        edge: EdgeId,
    },
    /// A group does not hang together.
    #[error("the group with edge {edge} does not hang together")]
    InPieces {
        /// Its first edge.
        edge: EdgeId,
    },
}

/// Struts that are placed at once.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Group {
    /// Its struts, by their places in [`Structure::struts`], rising.
    pub struts: Vec<usize>,
    /// The nodes that they touch, rising.
    pub nodes: Vec<usize>,
    /// Whether the ground holds one of its nodes.
    pub grounded: bool,
}

/// Every strut in exactly one group.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Groups {
    groups: Vec<Group>,
    of_strut: Vec<usize>,
}

impl Groups {
    /// Each strut alone.
    #[must_use]
    pub fn single(structure: &Structure) -> Self {
        Self::of((0..structure.struts().len()).map(|strut| vec![strut]).collect(), structure)
    }

    /// Struts that are placed together, such as those of a bent wire, by their edges. An edge that several groups name belongs to the
    /// first of them, and one that none names is placed alone.
    ///
    /// # Errors
    /// [`GroupError`].
    pub fn together(structure: &Structure, groups: &[Vec<EdgeId>]) -> Result<Self, GroupError> {
        let mut taken = vec![false; structure.struts().len()];
        let mut made = Vec::new();
        for edges in groups {
            let mut struts = Vec::new();
            for &edge in edges {
                let strut = structure.strut_of(edge).ok_or(GroupError::NoEdge { edge })?;
                if !std::mem::replace(&mut taken[strut], true) {
                    struts.push(strut);
                }
            }
            struts.sort_unstable();
            if let Some(&first) = struts.first() {
                if !hangs_together(structure, &struts) {
                    return Err(GroupError::InPieces { edge: structure.struts()[first].edge });
                }
                made.push(struts);
            }
        }
        made.extend((0..taken.len()).filter(|&strut| !taken[strut]).map(|strut| vec![strut]));
        made.sort_unstable();
        Ok(Self::of(made, structure))
    }

    fn of(groups: Vec<Vec<usize>>, structure: &Structure) -> Self {
        let mut of_strut = vec![0; structure.struts().len()];
        let made = groups.into_iter().enumerate().map(|(k, struts)| {
            for &strut in &struts {
                of_strut[strut] = k;
            }
            let mut nodes: Vec<usize> =
                struts.iter().flat_map(|&strut| structure.struts()[strut].ends).collect();
            nodes.sort_unstable();
            nodes.dedup();
            let grounded = nodes.iter().any(|&node| structure.nodes()[node].support);
            Group { struts, nodes, grounded }
        });
        let groups = made.collect();
        Self { groups, of_strut }
    }

    /// The groups, in order of their first struts.
    #[must_use]
    pub fn all(&self) -> &[Group] {
        &self.groups
    }

    /// The group of a strut.
    #[must_use]
    pub fn of_strut(&self, strut: usize) -> usize {
        self.of_strut[strut]
    }
}

/// Whether a walk along the struts leads from the first to each.
fn hangs_together(structure: &Structure, struts: &[usize]) -> bool {
    let mut unseen: HashSet<usize> = struts.iter().copied().collect();
    let mut open: Vec<usize> = struts.first().copied().into_iter().collect();
    while let Some(strut) = open.pop() {
        unseen.remove(&strut);
        let near = structure.struts()[strut].ends.into_iter().flat_map(|node| structure.around(node));
        open.extend(near.copied().filter(|next| unseen.remove(next)));
    }
    unseen.is_empty()
}
