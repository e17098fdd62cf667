//! What the axes of a machine can be told.

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_core::simulate::Resolution;

use crate::PlanningError;
use crate::machine::{Setup, deg, mm};

/// The least that the axes of a machine go, by its profile.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct ResolutionReport {
    pub feed_mm: f64,
    pub rotate_deg: f64,
    pub bend_deg: f64,
}

impl From<Resolution> for ResolutionReport {
    fn from(Resolution { feed, rotate, bend }: Resolution) -> Self {
        Self { feed_mm: feed.mm(), rotate_deg: rotate.deg(), bend_deg: bend.deg() }
    }
}

/// The least that the axes of a machine go.
pub fn resolution(setup: &Setup) -> Result<Resolution, PlanningError> {
    let figures = setup.machine.figures()?;
    Ok(Resolution {
        feed: mm(figures.feed_resolution_mm)?,
        rotate: deg(figures.rotate_resolution_deg)?,
        bend: deg(figures.bend_resolution_deg)?,
    })
}
