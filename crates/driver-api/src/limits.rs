//! What a driver knows of its machine before anything moves: how far the axes go, and how fast.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{Axis, Capability, Step};

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
    /// Where the cutter is, on a machine that has one: how far its blade is, along the feed, from the place where the tip of a wire is as
    /// that begins, mm. Below zero it is inside the machine, from where the wire comes. Since 1.7.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cutter_mm: Option<f64>,
    /// What the driver can and this machine cannot. Since 1.6.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub lacks: Vec<Lack>,
}

/// Something that a driver can and its machine cannot.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Lack {
    /// What.
    pub capability: Capability,
    /// Why, for a person: "firmware 1.12; it needs 1.13".
    pub reason: String,
    /// What to do about it.
    pub help: String,
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

/// A step that is beyond a limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beyond<'a> {
    /// Which, from 1.
    pub step: u32,
    /// How far it goes, or where the axis stands after it: mm or degrees.
    pub value: f64,
    /// What it is beyond.
    pub limit: &'a AxisLimit,
}

/// Closer than this to a limit is rounding: mm or degrees.
const ROUNDING: f64 = 1e-6;

impl Limits {
    /// The first step of a wire that is beyond a limit; those before `from`, counted from 1, are done.
    #[must_use]
    pub fn beyond(&self, steps: &[Step], from: u32) -> Option<Beyond<'_>> {
        let mut at = [0.0; 3];
        (1_u32..).zip(steps).find_map(|(n, step)| {
            let amounts = [step.feed_mm, step.rotate_deg, step.bend_deg];
            at.iter_mut().zip(amounts).for_each(|(at, amount)| *at += amount);
            let mut hold =
                self.limits.iter().filter(|limit| n >= from && limit.most.is_finite() && limit.most > 0.0);
            hold.find_map(|limit| {
                let of = if limit.of == Extent::Step { amounts } else { at };
                let value = of[limit.axis as usize];
                (value.abs() > limit.most + ROUNDING).then_some(Beyond { step: n, value, limit })
            })
        })
    }
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
