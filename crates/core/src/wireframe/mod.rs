//! The wireframe: the graph of struts that a person draws and a wire has to cover.
//!
//! Positions are millimetres in a right-handed frame. Vertices and edges carry ids that are never
//! used twice while a wireframe lives, so a diagnostic, a pin or an accepted doubling keeps
//! pointing at the same thing through edits, undo, files and plans.
//!
//! Changes are values: an [`Edit`] is resolved against a wireframe into a [`Delta`], the exact
//! difference, which can be committed, inverted and committed again.

mod components;
mod delta;
mod edits;
mod graph;
mod joint;
mod passing;
mod truss;
mod weld;
mod welder;

pub use components::Component;
pub use delta::{Change, Delta, StaleDelta};
pub use edits::{
    ChordLimits, Edit, EditError, FilletFault, FilletOutcome, MergeAt, MirrorMode, NEAR_LIMIT, Outcome,
    PolygonSize, Rest, ShapeOutcome, ShapePlane, reflection,
};
pub use graph::{Edge, EdgeId, NextIds, Vertex, VertexId, Wireframe, WireframeError};
pub use joint::{Joint, JointKind};
pub use passing::{crossings, points_passed};
pub use truss::{MAX_RINGS, TrussError, regular_depth, regular_strut, tetrahedral_truss};
pub use weld::WeldReport;
pub use welder::Welder;
