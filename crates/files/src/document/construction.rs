//! Construction lines: drawn to measure and to snap to, and never bent.

use nalgebra::Point3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A straight line between two points that is no wire. It is in no wireframe, so that nothing plans, checks or exports it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConstructionLine {
    pub ends: [Point3<f64>; 2],
}

/// A line that is drawn to measure and to snap to, and never bent: its two ends, mm.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(rename = "ConstructionLine")]
pub(crate) struct ConstructionLineFile([[f64; 3]; 2]);

impl From<&ConstructionLine> for ConstructionLineFile {
    fn from(line: &ConstructionLine) -> Self {
        Self(line.ends.map(|end| end.coords.into()))
    }
}

impl From<ConstructionLineFile> for ConstructionLine {
    fn from(ConstructionLineFile(ends): ConstructionLineFile) -> Self {
        Self { ends: ends.map(Point3::from) }
    }
}
