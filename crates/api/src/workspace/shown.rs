//! The unit in which the person at the window reads lengths.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::units::DisplayUnit;
use wirebend_planning::text::show_lengths_in;

use super::Workspace;
use crate::{ApiError, Progress};

/// Chooses the unit of the lengths in messages. Figures that are numbers stay in millimetres.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ShowLengths {
    /// The unit.
    pub unit: ShownUnit,
}

/// What lengths in messages are written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ShownUnit {
    /// Millimetres.
    Mm,
    /// Inches.
    Inch,
}

/// How lengths are written from here on, in what is asked again.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct LengthsShown {
    pub unit: ShownUnit,
}

impl Workspace {
    pub(crate) fn show_lengths(
        &self,
        asked: &ShowLengths,
        _: &dyn Progress,
    ) -> Result<LengthsShown, ApiError> {
        show_lengths_in(match asked.unit {
            ShownUnit::Mm => DisplayUnit::Millimetre,
            ShownUnit::Inch => DisplayUnit::Inch,
        });
        Ok(LengthsShown { unit: asked.unit })
    }
}
