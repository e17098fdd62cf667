//! The step that a stop has interrupted: how much of it is done.

use wirebend_driver_api::Step;

use super::wire_run::{Hold, WireRun};
use crate::settings::Settings;

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct InterruptedStep {
    pub step: u32,
    /// Feed and head where the step began, and the bend axis where the wire began, in mm and degrees as positions are
    /// reported; none where the position is not known.
    pub from: Option<Step>,
    /// What the step feeds and rotates, mm and degrees.
    pub whole: [f64; 2],
    /// Differences that the reports cannot show, mm and degrees.
    pub tolerance: [f64; 2],
    /// The machine stood still before it was reset, so no steps are lost.
    pub exact: bool,
}

/// What has stopped the machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum StoppedBy {
    /// Reset in motion: grbl warns that steps may be lost.
    Reset,
    /// A limit switch, lost power, a line that was refused or changed on its way: the counted position may be wrong, or the wire is not what it
    /// stands for.
    Fault,
}

impl InterruptedStep {
    /// The step of a run that is under way, if one is.
    pub fn of(run: &WireRun, settings: &Settings, by: StoppedBy) -> Option<Self> {
        let (step, from, end) = run.under_way()?;
        let units = [settings.feed_units_per_mm, settings.rotate_units_per_deg];
        let whole = std::array::from_fn(|axis| (end[axis] - from[axis]) / units[axis]);
        let tolerance = run.tolerance().map_or([0.0; 2], |all| [all[0] / units[0], all[1] / units[1]]);
        let began = run.began_at.filter(|_| by != StoppedBy::Fault);
        let from = began.map(|began| Step {
            feed_mm: began.feed_mm + from[0] / settings.feed_units_per_mm,
            rotate_deg: began.rotate_deg + from[1] / settings.rotate_units_per_deg,
            bend_deg: began.bend_deg,
            approach_deg: None,
        });
        let exact = run.hold == Hold::Held;
        Some(Self { step, from, whole, tolerance, exact })
    }
}
