//! What the machine's driver and the machine itself say of limits and rates, put into the machine's profile: one set of
//! limits, each with its source, for whatever plans, checks, estimates or prints.

use serde_json::Value;
use wirebend_driver_host::api::{Axis, AxisLimit, AxisRate, DriverError, Extent, Limits};
use wirebend_driver_host::{HostError, OpenDriver};
use wirebend_profile::{MachineProfile, Origin, Resolved, Sourced};

use crate::error::{DriverProblem, PlanningError};
use crate::installation::{Board, Installation};
use crate::report::NoteReport;

/// What came of asking a driver.
#[derive(Debug, Clone, Default)]
pub struct Told {
    /// What a person should know of it.
    pub note: Option<NoteReport>,
    /// The driver, and why it does not take the profile's settings: with it the machine bends nothing.
    refused: Option<(String, DriverError)>,
    /// The machine itself, where it is connected and was heard.
    pub board: Option<Board>,
}

impl Told {
    /// Refuses to plan for a machine whose driver cannot be opened with the profile's settings.
    pub fn require_settings(&self) -> Result<(), PlanningError> {
        match self.refused.clone() {
            Some((driver, error)) => Err(DriverProblem::Settings { driver, error }.into()),
            None => Ok(()),
        }
    }
}

impl Installation {
    /// Asks the machine's driver what it takes with the profile's settings, and puts what is tighter into the profile.
    /// A driver that cannot be asked is noted: then only the profile's own limits are known.
    pub fn with_driver_limits(&self, machine: &mut Resolved<MachineProfile>) -> Told {
        if !self.asks_drivers {
            return Told::default();
        }
        let id = machine.profile.driver.id.clone().unwrap_or_default();
        let settings = Value::Object(machine.profile.driver.settings.clone().unwrap_or_default());
        let asked = self.driver(&id).and_then(|driver| Ok(told(&driver.open(&settings)?)?));
        match asked {
            Ok(limits) => {
                Merge { machine, by: format!("driver {id}") }.all(&limits, Merge::rate);
                Told::default()
            }
            Err(DriverProblem::Host(HostError::Refused { driver, error })) => {
                Told { refused: Some((driver, error)), ..Told::default() }
            }
            Err(error) => Told { note: Some(unknown(&id, &error)), ..Told::default() },
        }
    }
}

fn told(driver: &OpenDriver) -> Result<Limits, HostError> {
    driver.limits()
}

fn unknown(driver: &str, error: &DriverProblem) -> NoteReport {
    NoteReport {
        code: "driver-limits-unknown".into(),
        count: 1,
        message: format!(
            "the driver '{driver}' could not be asked for its limits, only those of the profile are checked: {error}"
        ),
        remedies: error.remedies(),
    }
}

impl Board {
    /// Puts what the machine says of itself into its profile, where that is tighter or slower.
    pub fn limit(&self, machine: &mut Resolved<MachineProfile>) {
        Merge { machine, by: format!("machine at {}", self.port) }.all(&self.limits, Merge::slower);
    }
}

/// What is put into a machine's profile, and where it comes from.
struct Merge<'a> {
    machine: &'a mut Resolved<MachineProfile>,
    by: String,
}

/// By less a rate that a machine counts in whole steps is not slower than the same in mm or degrees.
const SLOWER: f64 = 1e-3;

/// A figure of a profile.
type Figure = Option<Sourced<f64>>;

impl Merge<'_> {
    fn all(&mut self, told: &Limits, rate: fn(&mut Self, &AxisRate)) {
        let limits = told.limits.iter().filter(|limit| limit.most.is_finite() && limit.most > 0.0);
        limits.for_each(|limit| self.limit(limit));
        let rates = told.rates.iter().filter(|rate| rate.per_s.is_finite() && rate.per_s > 0.0);
        rates.for_each(|told| rate(self, told));
    }

    fn limit(&mut self, limit: &AxisLimit) {
        let source = self.source(limit);
        let most = limit.most;
        let profile = &mut self.machine.profile;
        let (limits, bend) = (&mut profile.limits, &mut profile.bend);
        let tail = limits.tail_mm.as_ref().map_or(0.0, |tail| tail.value);
        // It is sent, and limits of wire are of what comes of it.
        let fed = |sent: f64| sent * profile.feed.scale.as_ref().map_or(1.0, |scale| scale.value);
        let range = |figure: &Figure| figure.as_ref().map_or(0.0, |figure| figure.value);
        let changed: &[Option<&str>] = match (limit.axis, limit.of) {
            (Axis::Feed, Extent::Step) => {
                &[keep(&mut limits.max_feed_mm, most, &source, "limits.max_feed_mm")]
            }
            // All feeds are the stock but for its tail.
            (Axis::Feed, Extent::Position) => {
                &[keep(&mut limits.max_stock_mm, fed(most) + tail, &source, "limits.max_stock_mm")]
            }
            (Axis::Rotate, of) => {
                let width = range(&limits.max_rotation_deg) - range(&limits.min_rotation_deg);
                // Within half of the largest step to either side no step is larger than it.
                let most = match of {
                    Extent::Position => most,
                    Extent::Step if width <= most => return,
                    Extent::Step => most / 2.0,
                };
                &[
                    keep(&mut limits.min_rotation_deg, -most, &source, "limits.min_rotation_deg"),
                    keep(&mut limits.max_rotation_deg, most, &source, "limits.max_rotation_deg"),
                ]
            }
            // A bend that counts on from the one before is no larger than where it ends may be.
            (Axis::Bend, _) => &[keep(&mut bend.axis_limit_deg, most, &source, "bend.axis_limit_deg")],
        };
        changed.iter().flatten().for_each(|key| self.said(key));
    }

    /// A rate of a driver: that of the profile holds unless the profile sets it for the driver.
    fn rate(&mut self, rate: &AxisRate) {
        let profile = &self.machine.profile;
        let set = profile.driver.settings.as_ref();
        let said: Vec<&str> = rate
            .settings
            .iter()
            .filter(|key| set.is_some_and(|set| set.contains_key(*key)))
            .map(String::as_str)
            .collect();
        if said.is_empty() {
            return;
        }
        let source = format!("driver setting {}", said.join(", "));
        self.set_rate(rate, source);
    }

    /// A rate that a machine does not exceed.
    fn slower(&mut self, rate: &AxisRate) {
        let (figure, _) = self.figure_of(rate.axis);
        if figure.as_ref().is_none_or(|stated| rate.per_s < stated.value * (1.0 - SLOWER)) {
            self.set_rate(rate, format!("its setting {}", rate.settings.join(", ")));
        }
    }

    fn set_rate(&mut self, rate: &AxisRate, source: String) {
        let (figure, key) = self.figure_of(rate.axis);
        *figure = Some(Sourced {
            value: rate.per_s,
            source,
            measured: false,
            within_95: None,
            within_95_before: None,
        });
        self.said(key);
    }

    const fn figure_of(&mut self, axis: Axis) -> (&mut Figure, &'static str) {
        let profile = &mut self.machine.profile;
        match axis {
            Axis::Feed => (&mut profile.feed.rate_mm_per_s, "feed.rate_mm_per_s"),
            Axis::Rotate => (&mut profile.rotate.rate_deg_per_s, "rotate.rate_deg_per_s"),
            Axis::Bend => (&mut profile.bend.rate_deg_per_s, "bend.rate_deg_per_s"),
        }
    }

    /// In words: which setting says it, or why it is so.
    fn source(&self, limit: &AxisLimit) -> String {
        let set = self.machine.profile.driver.settings.as_ref();
        match &limit.setting {
            Some(key) if set.is_some_and(|set| set.contains_key(key)) => format!("driver setting {key}"),
            Some(key) => format!("driver setting {key}, left at its default"),
            None => limit.reason.clone(),
        }
    }

    fn said(&mut self, key: &str) {
        let by = self.by.clone();
        self.machine.provenance.insert(key.to_owned(), Origin { id: by.clone(), file: by });
    }
}

/// Puts a limit in the place of one that is absent or farther from zero; gives the key where it did.
fn keep(figure: &mut Figure, most: f64, source: &str, key: &'static str) -> Option<&'static str> {
    if figure.as_ref().is_some_and(|stated| stated.value.abs() <= most.abs()) {
        return None;
    }
    *figure = Some(Sourced {
        value: most,
        source: source.to_owned(),
        measured: false,
        within_95: None,
        within_95_before: None,
    });
    Some(key)
}

#[cfg(test)]
mod tests {
    use wirebend_profile::Library;

    use super::*;

    /// A limit of the feed axis is one of what it is sent; stock is wire.
    #[test]
    fn the_stock_is_as_much_wire_as_the_feed_axis_gives_within_its_travel() {
        let stated = |value| Sourced {
            value,
            source: "a test".to_owned(),
            measured: false,
            within_95: None,
            within_95_before: None,
        };
        let travel = AxisLimit::known(Axis::Feed, Extent::Position, 300.0, "its travel");
        let board =
            Board { port: "a port".to_owned(), limits: Limits { limits: vec![travel], ..Limits::default() } };
        for (scale, wire_mm) in [(None, 300.0), (Some(0.9), 270.0), (Some(1.1), 330.0)] {
            let mut machine = Library::shipped().unwrap().machine("grbl-bender").unwrap();
            (machine.profile.feed.scale, machine.profile.limits.tail_mm) =
                (scale.map(stated), Some(stated(100.0)));
            machine.profile.limits.max_stock_mm = None;
            board.limit(&mut machine);
            let stock_mm = machine.profile.limits.max_stock_mm.unwrap().value;
            assert!((stock_mm - wire_mm - 100.0).abs() < 1e-9, "{scale:?}: {stock_mm}");
        }
    }
}
