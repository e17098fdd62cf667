//! Which errors move a wire most: each kind alone, and those of each step.

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_core::simulate::{
    BadErrorTerm, ErrorModel, ErrorSource, SimulationInput, SourceEffect, StepEffect, first_order,
};
use wirebend_files::document::JobWire;

/// What can be off.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ErrorSourceName {
    /// The length of a feed.
    Feed,
    /// The rotation before a bend.
    Rotation,
    /// The angle of a bend.
    Bend,
    /// The bow of a strut.
    Curvature,
}

impl From<ErrorSource> for ErrorSourceName {
    fn from(source: ErrorSource) -> Self {
        match source {
            ErrorSource::Feed => Self::Feed,
            ErrorSource::Rotation => Self::Rotation,
            ErrorSource::Bend => Self::Bend,
            ErrorSource::Curvature => Self::Curvature,
        }
    }
}

/// How far one kind of error moves the wire where nothing else is off, to first order.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct SourceShare {
    pub source: ErrorSourceName,
    /// Root mean square of the distance of all vertices from where they should be, mm.
    pub rms_mm: f64,
}

/// How far the errors of one step move the wire where nothing else is off, to first order, as root mean square over all vertices.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct StepShare {
    /// From 1.
    pub step: usize,
    /// The vertex at which it ends.
    pub vertex: u32,
    /// Those of its feed and of the bow of its strut, mm.
    pub feed_mm: f64,
    /// Those of its rotation, mm.
    pub rotate_mm: f64,
    /// Those of its bend, mm.
    pub bend_mm: f64,
}

pub(super) fn shares(
    wire: &JobWire,
    input: &SimulationInput,
    errors: &ErrorModel,
) -> Result<(Vec<SourceShare>, Vec<StepShare>), BadErrorTerm> {
    let found = first_order(input, errors)?;
    let mut sources = found
        .sources
        .map(|SourceEffect { source, rms_mm }| SourceShare { source: source.into(), rms_mm })
        .to_vec();
    sources.sort_by(|a, b| b.rms_mm.total_cmp(&a.rms_mm));
    let ends = wire.spans.iter().map(|&[_, end]| wire.vertices.get(end).copied().unwrap_or_default());
    let steps = found.steps.iter().zip(ends).enumerate();
    let steps = steps.map(|(k, (&StepEffect { feed_mm, rotate_mm, bend_mm }, vertex))| StepShare {
        step: k + 1,
        vertex,
        feed_mm,
        rotate_mm,
        bend_mm,
    });
    Ok((sources, steps.collect()))
}
