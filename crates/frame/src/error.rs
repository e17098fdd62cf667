//! What can be wrong with a model, a load or a frame.

use thiserror::Error;

use crate::model::{MemberId, NodeId, SectionId};

/// A model that describes no frame.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ModelError {
    /// A coordinate is not a number, or infinite.
    #[error("node {} has a coordinate that is no finite number", node.0)]
    NodeNotFinite { node: NodeId },
    /// A member ends at a node that is not there.
    #[error("member {} ends at node {}, and there are {nodes} nodes", member.0, node.0)]
    UnknownNode { member: MemberId, node: NodeId, nodes: usize },
    /// A member has a section that is not there.
    #[error("member {} has section {}, and there are {sections} sections", member.0, section.0)]
    UnknownSection { member: MemberId, section: SectionId, sections: usize },
    /// Both ends of a member are at the same place.
    #[error("member {} has no length: nodes {} and {} are at the same place", member.0, a.0, b.0)]
    NoLength { member: MemberId, a: NodeId, b: NodeId },
    /// The direction that tells local y lies along the member, or is none.
    #[error("member {} has an up that is along it, or no direction", member.0)]
    UpAlongMember { member: MemberId },
    /// A figure of a section that has to be above zero is not, or is not finite. A density may be zero.
    #[error("section {} has {value} for its {figure}", section.0)]
    SectionFigure { section: SectionId, figure: &'static str, value: f64 },
    /// A support holds a node that is not there.
    #[error("a support holds node {}, and there are {nodes} nodes", node.0)]
    UnknownSupport { node: NodeId, nodes: usize },
    /// Memory does not hold its equations.
    #[error("the equations of {nodes} nodes do not fit into memory")]
    TooLarge { nodes: usize },
}

/// A frame that cannot stand.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum Unstable {
    /// Nothing holds these members, which hang together.
    #[error("a part of {} members, with node {}, has no support", members.len(), node.0)]
    PartWithoutSupport {
        /// Its first node.
        node: NodeId,
        /// All its members.
        members: Vec<MemberId>,
    },
    /// It can move without bending anything.
    #[error("the frame is a mechanism: node {} can move or turn freely", node.0)]
    Mechanism {
        /// A node that moves or turns.
        node: NodeId,
    },
    /// A displacement is far larger than the model, as of a frame that hardly stands: what was computed means nothing.
    #[error("node {} would move by {displacement_mm} mm in a frame of {size_mm} mm", node.0)]
    TooSoft {
        /// The node that moves most.
        node: NodeId,
        /// How far.
        displacement_mm: f64,
        /// The diagonal of the box around the model.
        size_mm: f64,
    },
}

/// A load that does not belong to the frame.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum LoadError {
    /// It acts on a member that is not among those solved for.
    #[error("a load acts on member {}, which is not there", member.0)]
    AbsentMember { member: MemberId },
    /// It acts on a node that no member among those solved for touches.
    #[error("a load acts on node {}, which no member that is there touches", node.0)]
    AbsentNode { node: NodeId },
    /// A figure is not a number, or infinite.
    #[error("a load has a figure that is no finite number")]
    NotFinite,
}

/// Why there is no response.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SolveError {
    /// The load is wrong.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// The frame does not stand under it.
    #[error(transparent)]
    Unstable(#[from] Unstable),
}

/// Why there are no modes.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ModesError {
    /// There is no member.
    #[error("a frame without members has no modes")]
    NoMembers,
    /// A shift that is not above zero, or not finite.
    #[error("modes are looked for from {shift_hz} Hz, which has to be above zero")]
    Shift { shift_hz: f64 },
    /// A section weighs nothing, so that its members vibrate at no frequency.
    #[error("section {} has no density", section.0)]
    Weightless { section: SectionId },
    /// A mass below zero or not finite, or of a node that is not there.
    #[error("the mass at node {} has to be finite and not below zero, and the node in the model", node.0)]
    Mass { node: NodeId },
    /// There is not one strut named for each member.
    #[error("struts are named for {struts} of {members} members")]
    Struts { struts: usize, members: usize },
    /// The search has not come to an end.
    #[error("{found} of {wanted} modes were found among {vectors} directions")]
    NotConverged { found: usize, wanted: usize, vectors: usize },
    /// So many modes are equal that the search has not come upon all of them.
    #[error("{found} modes were found below {below_hz} Hz, where there are {there}")]
    LeftOut { found: usize, there: usize, below_hz: f64 },
    /// A figure is so large or small that what was computed is no number.
    #[error("the modes are no finite numbers")]
    NotFinite,
}
