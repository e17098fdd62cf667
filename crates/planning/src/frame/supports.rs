//! What holds a frame.

use schemars::JsonSchema;
use serde::Deserialize;
use wirebend_core::wireframe::{Edit, VertexId, Wireframe};
use wirebend_error::InputName;

use crate::PlanningError;
use crate::design::Opened;

/// Where a frame is held; a vertex that is held can neither move nor turn.
#[derive(Debug, Clone, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FrameSupports {
    /// At the supports of the design.
    #[default]
    Design,
    /// Nowhere: it floats.
    Free,
    /// At these vertices.
    Vertices(Vec<u32>),
}

impl FrameSupports {
    /// The vertices that are held, each once.
    pub(crate) fn vertices(&self, opened: &Opened) -> Result<Vec<VertexId>, PlanningError> {
        let wireframe = &opened.document.wireframe;
        let mut held: Vec<VertexId> = match self {
            Self::Free => Vec::new(),
            Self::Design => {
                wireframe.vertices().filter(|(_, vertex)| vertex.support).map(|(id, _)| id).collect()
            }
            Self::Vertices(ids) => ids.iter().copied().map(VertexId).collect(),
        };
        held.sort_unstable();
        held.dedup();
        match held.iter().find(|&&id| wireframe.vertex(id).is_none()) {
            Some(&VertexId(vertex)) => Err(opened.no_vertex(vertex, InputName::Supports)),
            None => Ok(held),
        }
    }

    /// The wireframe of a design, held by these supports in place of its own.
    pub(crate) fn hold(&self, opened: &Opened) -> Result<Wireframe, PlanningError> {
        let mut wireframe = opened.document.wireframe.clone();
        if *self == Self::Design {
            return Ok(wireframe);
        }
        let held = self.vertices(opened)?;
        let all: Vec<VertexId> = wireframe.vertices().map(|(id, _)| id).collect();
        for (vertices, support) in [(all, false), (held, true)] {
            wireframe.apply(&Edit::SetSupport { vertices, support }).map_err(|error| {
                PlanningError::NoFrame { name: opened.name.clone(), reason: error.to_string() }
            })?;
        }
        Ok(wireframe)
    }
}
