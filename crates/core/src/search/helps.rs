//! Changes with which a search finds what it has not found without them.

use nalgebra::Point3;

use crate::route::Route;
use crate::units::Length;
use crate::wireframe::{EdgeId, VertexId};

/// What was tried after a search that has found nothing, and what of it helps.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Helps {
    /// One of a kind at most.
    pub found: Vec<Help>,
    /// The kinds that were tried until one helped, or to the end.
    pub tried: Vec<ChangeKind>,
    /// Whether a person has ended the search or these trials: there may be kinds that were not tried, or not to the end.
    pub ended: bool,
}

/// A change that helps, and the walks that meet nothing then.
#[derive(Debug, Clone, PartialEq)]
pub struct Help {
    /// What is changed.
    pub change: Change,
    /// One a wire.
    pub routes: Vec<Route>,
}

/// What is changed.
#[derive(Debug, Clone, PartialEq)]
pub enum Change {
    /// As many wires as there are walks, more than were allowed.
    MoreWires,
    /// Edges are run along once more than before.
    Doubled {
        /// Which.
        edges: Vec<EdgeId>,
        /// What they add to the wire.
        added: Length,
    },
    /// A vertex lies elsewhere.
    Moved(MovedVertex),
}

/// The same without its figures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChangeKind {
    /// More wires than were allowed.
    MoreWires,
    /// An edge that is run along twice.
    Doubled,
    /// A vertex that lies elsewhere.
    Moved,
}

impl Change {
    /// Its kind.
    #[must_use]
    pub const fn kind(&self) -> ChangeKind {
        match self {
            Self::MoreWires => ChangeKind::MoreWires,
            Self::Doubled { .. } => ChangeKind::Doubled,
            Self::Moved(_) => ChangeKind::Moved,
        }
    }
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
