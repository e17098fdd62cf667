//! A sequence as somebody gives it: by edges, vertices and vectors.

use nalgebra::Vector3;
use wirebend_core::checks::sequence::StepKind;
use wirebend_core::wireframe::{EdgeId, VertexId};

use crate::builder::StrutBuilder;
use crate::outcome::Step;
use crate::structure::Structure;

/// A direction of unit length written with three digits is no farther off than this, rad.
pub(super) const ROUNDING_RAD: f64 = 1e-3;

/// What is placed at once.
#[derive(Debug, Clone, PartialEq)]
pub struct GivenStep {
    /// Its edges; one, unless a wire or rod is placed.
    pub edges: Vec<EdgeId>,
    /// What it is said to be, where it is.
    pub kind: Option<StepKind>,
    /// Where the head stands: for a strut the end from which it is drawn.
    pub joints: Vec<GivenJoint>,
}

/// Where the head stands.
#[derive(Debug, Clone, PartialEq)]
pub struct GivenJoint {
    /// The vertex.
    pub vertex: VertexId,
    /// Directions of its axis, from the tip into the head; one of them has to be free.
    pub directions: Vec<Vector3<f64>>,
}

impl GivenStep {
    /// A step that was found, with the direction that was chosen.
    #[must_use]
    pub fn of(step: &Step, structure: &Structure, builder: &StrutBuilder) -> Self {
        let joints = step.joints.iter().map(|joint| GivenJoint {
            vertex: structure.nodes()[joint.node].vertex,
            directions: vec![builder.directions.all()[joint.direction].into_inner()],
        });
        Self {
            edges: step.struts.iter().map(|&strut| structure.struts()[strut].edge).collect(),
            kind: Some(step.kind),
            joints: joints.collect(),
        }
    }
}
