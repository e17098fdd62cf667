//! What is known of the machine.

use std::collections::BTreeMap;
use std::time::Duration;

use wirebend_driver_api::{SettingCheck, Step};

use super::displacement::ReportedPosition;
use super::status::{Position, State, Status};
use crate::program::trimmed;
use crate::settings::{Homing, Settings};

const MM_PER_INCH: f64 = 25.4;
/// The controller writes its settings with three decimals.
const SAME: f64 = 0.000_5;

#[derive(Debug, Default)]
pub(super) struct Machine {
    /// Its greeting, without the hint at its end.
    pub greeting: Option<String>,
    /// Version and date of its firmware, and what its owner has added.
    pub build: Option<String>,
    /// Its settings as it writes them.
    pub settings: BTreeMap<String, String>,
    /// What it was doing when it was last heard of.
    pub state: Option<State>,
    /// Whether the axes have been where their zero is, and nothing has happened since that makes it doubtful.
    pub homed: bool,
    /// When it was last sent a reset.
    pub reset_at: Option<Duration>,
    /// How many axes it reports.
    pub axes: usize,
    /// From the machine's zero to the program's, in its units, as it last reported.
    offset: Vec<f64>,
    /// The same before a reset that has taken G92 away: positions count from there until it is homed.
    offset_before_reset: Option<Vec<f64>>,
    /// It counts anew, from an unknown place, until it is homed.
    lost: bool,
    /// Where it was last heard of.
    reported: Option<Position>,
    position: Option<Step>,
}

impl Machine {
    /// What it says that it is.
    pub fn identity(&self) -> String {
        let words = [self.greeting.as_deref(), self.build.as_deref()];
        words.into_iter().flatten().collect::<Vec<_>>().join(", ")
    }

    /// Forgets what a reset changes. A soft reset takes G92 away and keeps the position; one that was not asked for may
    /// have been the board's own, or its power, after which it counts from zero (`main.c`).
    pub fn was_reset(&mut self, asked_for: bool) {
        let offset = std::mem::take(&mut self.offset);
        self.has_greeted();
        if asked_for {
            self.offset_before_reset.get_or_insert(offset);
        } else {
            self.lost = true;
        }
    }

    /// It has greeted. Where it stands is reported then, even where it was reported before.
    pub fn has_greeted(&mut self) {
        self.offset.clear();
        (self.state, self.reported, self.position) = (None, None, None);
    }

    /// Its axes are where their zero is.
    pub fn set_homed(&mut self) {
        (self.homed, self.lost, self.offset_before_reset) = (true, false, None);
    }

    /// Where the axes stood at the last report, counted as the controller reports it.
    pub fn reported(&self, settings: &Settings) -> Option<ReportedPosition> {
        let (Position::Machine(values) | Position::Work(values)) = self.reported.as_ref()?;
        let (unit, digit) = if self.reports_inches() { (MM_PER_INCH, 1e-4) } else { (1.0, 1e-3) };
        let [feed, rotate, bend] = settings.axes().map(|(_, axis)| {
            let steps = self.settings.get(&format!("$10{}", axis.index()));
            (values.get(axis.index()), steps.and_then(|steps| steps.parse().ok()))
        });
        Some(ReportedPosition {
            at: [feed.0? * unit, rotate.0? * unit, bend.0? * unit],
            steps: [feed.1, rotate.1, bend.1],
            digit: digit * unit,
        })
    }

    /// What a report says of where the axes are.
    pub fn reports(&mut self, status: &Status) {
        if let Some(offset) = &status.offset {
            self.offset.clone_from(offset);
        }
        let (Position::Machine(values) | Position::Work(values)) = &status.position;
        self.axes = values.len();
        self.reported = Some(status.position.clone());
    }

    /// Where the axes are in mm and degrees, unless that was reported already or is not known.
    pub fn moved_to(&mut self, settings: &Settings) -> Option<Step> {
        let position = self.position(settings)?;
        (self.position.replace(position) != Some(position)).then_some(position)
    }

    /// Where the axes are in mm and degrees, unless that is not known. A reset that was asked for changes nothing of where it
    /// counts from.
    pub fn position(&self, settings: &Settings) -> Option<Step> {
        if self.lost {
            return None;
        }
        let reported = self.reported.as_ref()?;
        let (Position::Machine(values) | Position::Work(values)) = reported;
        // What is counted from another zero cannot be computed without both zeros.
        let unrelated = self
            .offset_before_reset
            .as_ref()
            .is_some_and(|before| before.is_empty() || self.offset.is_empty());
        if unrelated && matches!(reported, Position::Work(_)) {
            return None;
        }
        let known = |offset: &[f64], at: usize| offset.get(at).copied().unwrap_or_default();
        // From what is reported to what positions count from.
        let from = |at| match (reported, &self.offset_before_reset) {
            (Position::Machine(_), None) => known(&self.offset, at),
            (Position::Machine(_), Some(before)) => known(before, at),
            (Position::Work(_), None) => 0.0,
            (Position::Work(_), Some(before)) => known(before, at) - known(&self.offset, at),
        };
        let unit = if self.reports_inches() { MM_PER_INCH } else { 1.0 };
        let [feed, rotate, bend] = settings.axes().map(|(_, axis)| {
            let index = axis.index();
            values.get(index).map(|value| (value - from(index)) * unit)
        });
        Some(Step {
            feed_mm: feed? / settings.feed_units_per_mm,
            rotate_deg: rotate? / settings.rotate_units_per_deg,
            bend_deg: bend? / settings.bend_units_per_deg,
            approach_deg: None,
        })
    }

    /// `$13`: the controller turns all of its axes into inches then, those in degrees too.
    fn reports_inches(&self) -> bool {
        self.settings.get("$13").is_some_and(|value| value == "1")
    }

    /// What it says of a setting.
    pub fn setting(&self, key: &str) -> Option<f64> {
        self.settings.get(key)?.parse().ok()
    }

    /// The settings that are not what they should be.
    pub fn differences(&self, settings: &Settings) -> Vec<SettingCheck> {
        // With laser mode the pin's output follows the rate of motion, and goes off at rest.
        let mut expected = BTreeMap::from([("$32".to_owned(), 0.0)]);
        if settings.homing == Homing::Switches {
            expected.insert("$22".to_owned(), 1.0);
        }
        expected.extend(settings.expected.clone());
        let differs = |(key, wanted): (&String, &f64)| {
            let machine = self.settings.get(key);
            let value = machine.and_then(|value| value.parse::<f64>().ok());
            if value.is_some_and(|value| (value - wanted).abs() <= SAME) {
                return None;
            }
            Some(SettingCheck {
                name: named(key),
                machine: machine.cloned().unwrap_or_else(|| "not there".to_owned()),
                expected: trimmed(*wanted),
                matters: matters(key),
            })
        };
        expected.iter().filter_map(differs).collect()
    }
}

/// A setting on the machine and for people.
fn named(key: &str) -> String {
    let axis = |at: usize| ["X", "Y", "Z", "A", "B", "C"].get(at).copied().unwrap_or("axis");
    let number: usize = key.trim_start_matches('$').parse().unwrap_or_default();
    let name = match number {
        1 => "how long motors are held, ms".to_owned(),
        3 => "directions of the axes".to_owned(),
        13 => "reports in inches".to_owned(),
        20 => "soft limits".to_owned(),
        21 => "hard limits".to_owned(),
        22 => "homing".to_owned(),
        23 => "directions of homing".to_owned(),
        30 => "spindle output fully on at".to_owned(),
        32 => "laser mode".to_owned(),
        100..=109 => format!("steps of {} per mm or degree", axis(number - 100)),
        110..=119 => format!("fastest {} per minute", axis(number - 110)),
        120..=129 => format!("acceleration of {} per s\u{b2}", axis(number - 120)),
        130..=139 => format!("travel of {}", axis(number - 130)),
        _ => return key.to_owned(),
    };
    format!("{key} {name}")
}

/// Whether wires come out wrong with another value: directions, steps, and what the pin does.
fn matters(key: &str) -> bool {
    let number: u32 = key.trim_start_matches('$').parse().unwrap_or_default();
    matches!(number, 3 | 30..=32 | 100..=109)
}
