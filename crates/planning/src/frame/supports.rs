//! What holds a frame.

use schemars::JsonSchema;
use serde::Deserialize;

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
