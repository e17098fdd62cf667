//! How a document names vertices, edges and stencils.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::wireframe::{EdgeId, VertexId};

/// Names a stencil within its document.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(transparent)]
pub struct StencilId(pub u32);

/// A remark that a person pinned to a place of the design.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Pin {
    /// The place.
    pub on: PinTarget,
    /// The remark.
    pub text: String,
}

/// What a pin sticks to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PinTarget {
    Vertex(VertexId),
    Edge(EdgeId),
}

/// A remark on a vertex or an edge.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Pin")]
pub(crate) struct PinFile {
    /// What it sticks to.
    on: TargetFile,
    /// The remark.
    text: String,
}

/// A vertex or an edge by its id.
#[derive(Debug, Clone, Copy, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(rename = "PinTarget")]
enum TargetFile {
    Vertex(u32),
    Edge(u32),
}

impl From<&Pin> for PinFile {
    fn from(pin: &Pin) -> Self {
        let on = match pin.on {
            PinTarget::Vertex(id) => TargetFile::Vertex(id.0),
            PinTarget::Edge(id) => TargetFile::Edge(id.0),
        };
        Self { on, text: pin.text.clone() }
    }
}

impl From<PinFile> for Pin {
    fn from(pin: PinFile) -> Self {
        let on = match pin.on {
            TargetFile::Vertex(id) => PinTarget::Vertex(VertexId(id)),
            TargetFile::Edge(id) => PinTarget::Edge(EdgeId(id)),
        };
        Self { on, text: pin.text }
    }
}
