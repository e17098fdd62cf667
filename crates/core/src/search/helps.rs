//! Changes with which a search finds what it has not found without them.

use nalgebra::Point3;

use crate::units::Length;
use crate::wireframe::VertexId;

/// What helps.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Helps {
    /// So many wires, more than were allowed.
    pub wires: Option<usize>,
    /// A vertex that lies elsewhere.
    pub moved: Option<MovedVertex>,
}

/// A vertex that is moved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MovedVertex {
    /// Which.
    pub vertex: VertexId,
    /// Where it goes.
    pub to: Point3<f64>,
    /// How far that is.
    pub by: Length,
}
