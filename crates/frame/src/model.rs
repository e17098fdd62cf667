//! A frame as it is drawn: nodes, members, sections, supports.

use nalgebra::{Point3, Vector3};

use crate::section::Section;

/// A node, by its place in [`Model::nodes`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(pub usize);

/// A member, by its place in [`Model::members`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct MemberId(pub usize);

/// A section, by its place in [`Model::sections`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SectionId(pub usize);

/// A straight beam between two nodes, rigidly joined to both. Two members may join the same nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Member {
    /// Where it begins; local x points from here.
    pub a: NodeId,
    /// Where it ends.
    pub b: NodeId,
    /// Its cross-section.
    pub section: SectionId,
    /// A direction that is not along the member; local y = up × x, and z = x × y. `None` is z, and y for a member along z.
    /// It matters only where `iy` and `iz` differ, and for the local axes in which forces are told.
    pub up: Option<Vector3<f64>>,
}

impl Member {
    /// A member whose local axes are left to the default.
    #[must_use]
    pub fn new(a: NodeId, b: NodeId, section: SectionId) -> Self {
        Self { a, b, section, up: None }
    }
}

/// A node that something outside holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Support {
    /// Which node.
    pub node: NodeId,
    /// Which of its displacements along x, y, z and rotations about x, y, z are held at zero. Several supports of one node
    /// hold what any of them holds.
    pub fixed: [bool; 6],
}

impl Support {
    /// A node that is held altogether.
    #[must_use]
    pub fn clamped(node: NodeId) -> Self {
        Self { node, fixed: [true; 6] }
    }

    /// A node that cannot move and can turn freely.
    #[must_use]
    pub fn pinned(node: NodeId) -> Self {
        Self { node, fixed: [true, true, true, false, false, false] }
    }
}

/// A frame. [`Assembly::new`](crate::Assembly::new) checks it.
///
/// Passes of a wire that are locked together are made one node by a second model with the same members.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Model {
    /// mm. A node that no member touches takes no part.
    pub nodes: Vec<Point3<f64>>,
    /// The beams.
    pub members: Vec<Member>,
    /// What the members are made of.
    pub sections: Vec<Section>,
    /// What is held; none for a frame that floats freely, which has modes and no displacements.
    pub supports: Vec<Support>,
}
