//! Figures of closed frames.

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_accuracy::Expected;

/// Figures of closed frames.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct ClosingFigures {
    /// How far the vertices of the faces are from the planes that fit them best, RMS; without faces how far all are from where they
    /// should be.
    pub surface_rms_mm: f64,
    /// How far all vertices are from where they should be, after the motion of the whole that fits them best, RMS: without faces the
    /// same.
    pub vertices_rms_mm: f64,
    /// Force along a strut, RMS over the struts.
    pub axial_rms_n: f64,
    /// Von Mises stress, RMS over the struts, at four points of the surface all along them.
    pub von_mises_rms_mpa: f64,
    /// The largest force that pulls a pass of the wire to its vertex; null where joints are rigid from the start.
    pub largest_pull_n: Option<f64>,
    /// What is stored in the wire.
    pub energy_n_mm: f64,
    /// How far passes through one vertex are apart at most before they are pulled together; null for an expectation, and where no vertex
    /// is passed twice.
    pub gap_mm: Option<f64>,
}

impl From<Expected> for ClosingFigures {
    fn from(expected: Expected) -> Self {
        Self {
            surface_rms_mm: expected.surface_rms,
            vertices_rms_mm: expected.vertices_rms,
            axial_rms_n: expected.axial_rms,
            von_mises_rms_mpa: expected.von_mises_rms,
            largest_pull_n: expected.largest_pull,
            energy_n_mm: expected.energy,
            gap_mm: None,
        }
    }
}
