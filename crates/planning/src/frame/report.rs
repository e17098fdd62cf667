//! What is told of a frame under load.

use schemars::JsonSchema;
use serde::Serialize;

/// What a support does to the frame.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ReactionReport {
    pub vertex: u32,
    pub force_n: [f64; 3],
    pub moment_n_mm: [f64; 3],
}

/// What a strut carries.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MemberReport {
    pub edge: u32,
    /// Tension in its middle; negative is compression.
    pub axial_n: f64,
    /// The largest bending moment along it.
    pub moment_n_mm: f64,
    pub torque_n_mm: f64,
    /// The largest along it; null where its section is no solid round, so that the place of the largest is not known.
    pub von_mises_mpa: Option<f64>,
    /// The largest stress as a share of the yield strength; null where either is not known.
    pub utilisation: Option<f64>,
    /// Compression as a share of the Euler load of the strut with pinned ends: from 0.5 on, a linear result no longer holds.
    pub buckling_ratio: f64,
}

/// What loads do to the frame.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct StaticReport {
    pub max_displacement_mm: f64,
    /// The vertex that moves farthest.
    pub at_vertex: u32,
    /// What the loads have done on their way.
    pub work_n_mm: f64,
    pub reactions: Vec<ReactionReport>,
    /// By edge.
    pub members: Vec<MemberReport>,
    /// How far forces are from balance at a vertex, as a share of the largest.
    pub residual: f64,
}
