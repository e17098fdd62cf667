//! Axes of the design, and the planes that shapes are laid on.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// An axis of the frame of the design.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum AxisName {
    X,
    Y,
    Z,
}

/// A plane of two axes. The first is the first of its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PlaneName {
    Xy,
    Xz,
    Yz,
}

/// A plane that is none of the axes. What lies on it is given along its first axis, along its second, and off it, from where it was put.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OwnPlane {
    /// Where it was put.
    pub origin_mm: [f64; 3],
    /// Its first axis, of any length.
    pub u: [f64; 3],
    /// Its second: of what it has across the first, the direction counts.
    pub v: [f64; 3],
}
