//! What a driver knows of its machine before anything moves: how far the axes go, and how fast.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::Axis;

/// Reply of [`Call::Limits`](crate::Call::Limits): what the driver and its machine take with the settings that the
/// driver was opened with. The program plans within it, so that nothing is refused in the middle of a wire.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Limits {
    /// How far axes go. Of several for an axis all hold.
    #[serde(default)]
    pub limits: Vec<AxisLimit>,
    /// How fast axes go. An axis is left out where the driver does not know.
    #[serde(default)]
    pub rates: Vec<AxisRate>,
}

/// How far an axis goes, to either side.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct AxisLimit {
    /// The axis.
    pub axis: Axis,
    /// What is held against it.
    pub of: Extent,
    /// The largest that is taken: mm for the feed, degrees for the others; above zero.
    pub most: f64,
    /// The key of the setting that says so; absent where none does.
    #[serde(default)]
    pub setting: Option<String>,
    /// Where the limit comes from, for a person; may be empty where a setting says so.
    #[serde(default)]
    pub reason: String,
}

/// What is held against a limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Extent {
    /// The amount of a single step.
    Step,
    /// Where the axis stands after a step, counted from the beginning of the wire: the sum of all steps so far.
    Position,
}

/// How fast an axis goes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct AxisRate {
    /// The axis. The bend axis: the mean of its way out and back.
    pub axis: Axis,
    /// mm/s for the feed, degrees/s for the others; above zero.
    pub per_s: f64,
    /// The keys of the settings that say so. The rate replaces that of the machine's profile where the profile has
    /// set one of them; what is left at its default says nothing of a machine.
    pub settings: Vec<String>,
}

impl AxisLimit {
    /// A limit that a setting says.
    #[must_use]
    pub fn of_setting(axis: Axis, of: Extent, most: f64, setting: &str) -> Self {
        Self { axis, of, most, setting: Some(setting.to_owned()), reason: String::new() }
    }

    /// A limit that no setting says.
    #[must_use]
    pub fn known(axis: Axis, of: Extent, most: f64, reason: &str) -> Self {
        Self { axis, of, most, setting: None, reason: reason.to_owned() }
    }
}

impl AxisRate {
    /// A rate that settings say.
    #[must_use]
    pub fn new(axis: Axis, per_s: f64, settings: &[&str]) -> Self {
        Self { axis, per_s, settings: settings.iter().map(|&key| key.to_owned()).collect() }
    }
}
