//! The walks that a person has taken for the wires, instead of those that are found anew each time.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::wireframe::{EdgeId, VertexId};

/// The way of one wire along the edges.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Walk {
    /// Where the wire starts.
    pub start: VertexId,
    /// The edges in the order in which it runs along them; one that is laid twice comes twice.
    pub edges: Vec<EdgeId>,
}

/// The way of one wire along the edges.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Walk")]
pub(super) struct WalkFile {
    /// The vertex that the wire starts at, by id.
    start: u32,
    /// The edges in the order in which the wire runs along them, by id.
    edges: Vec<u32>,
}

impl From<&Walk> for WalkFile {
    fn from(walk: &Walk) -> Self {
        Self { start: walk.start.0, edges: walk.edges.iter().map(|id| id.0).collect() }
    }
}

impl From<WalkFile> for Walk {
    fn from(file: WalkFile) -> Self {
        Self { start: VertexId(file.start), edges: file.edges.into_iter().map(EdgeId).collect() }
    }
}
