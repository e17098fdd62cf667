//! What acts on a frame.

use nalgebra::Vector3;

use crate::model::{MemberId, NodeId};

/// Standard gravity, mm/s² (3rd CGPM, 1901).
pub const STANDARD_GRAVITY: f64 = 9806.65;

/// A force and a moment at a node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NodalLoad {
    /// Which node.
    pub node: NodeId,
    /// N.
    pub force: Vector3<f64>,
    /// N mm.
    pub moment: Vector3<f64>,
}

/// A mass at a node, such as that of a joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NodeMass {
    /// Which node.
    pub node: NodeId,
    /// t.
    pub mass: f64,
}

/// A force spread evenly along a member.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineLoad {
    /// Which member.
    pub member: MemberId,
    /// N/mm of the member's length, in the model's axes.
    pub force: Vector3<f64>,
}

/// A member that does not fit between its nodes as drawn, and is forced to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Misfit {
    /// Which member.
    pub member: MemberId,
    /// How much longer it is, mm.
    pub extra_length: f64,
    /// By how much its end at `a` is turned against the joint that it is made to, a small rotation vector in the model's
    /// axes, radian: a joint that stays as drawn turns the end of the member by this.
    pub rotation_a: Vector3<f64>,
    /// The same at `b`.
    pub rotation_b: Vector3<f64>,
}

/// The general misfit: how the ends of a member are moved beside what their nodes do. Its forces are `K_e (u + ends)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EndMotion {
    /// Which member.
    pub member: MemberId,
    /// Displacement and rotation of its end at `a`, then of that at `b`, in the model's axes, mm and radian.
    pub ends: [f64; 12],
}

/// All that acts on a frame at once. The default is nothing.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Load {
    /// Forces and moments at nodes.
    pub nodal: Vec<NodalLoad>,
    /// Forces along members.
    pub line: Vec<LineLoad>,
    /// The acceleration that pulls at every member that is there, and at masses, mm/s²; zero for none.
    pub gravity: Vector3<f64>,
    /// Masses at nodes. A node at which no member that is there ends has none.
    pub masses: Vec<NodeMass>,
    /// Members that do not fit.
    pub misfits: Vec<Misfit>,
    /// Members that do not fit, in general. It adds to their misfit.
    pub end_motions: Vec<EndMotion>,
}

impl Load {
    /// The weight of the frame, with [`STANDARD_GRAVITY`] against z.
    #[must_use]
    pub fn self_weight() -> Self {
        Self { gravity: Vector3::new(0.0, 0.0, -STANDARD_GRAVITY), ..Self::default() }
    }
}
