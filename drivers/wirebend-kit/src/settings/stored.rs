//! What the firmware stores, from what a person sets.

use wirebend_driver_api::SettingCheck;

use super::Settings;
use crate::protocol::SETTINGS;

/// What a controller says of one setting, and what it should.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Difference {
    /// Index into `SETTINGS`.
    index: usize,
    pub machine: i32,
    pub expected: i32,
}

/// Below this a setting differs by the rounding of units: one step in a thousand, of those that only say how
/// fast or how long.
const PACE: &[&str] = &[
    "feed_rate",
    "rotate_rate",
    "bend_rate",
    "feed_acceleration",
    "rotate_acceleration",
    "bend_acceleration",
    "peg_time_ms",
    "home_fast_rate",
    "home_slow_rate",
    "home_time_ms",
    "release_s",
];

/// How far something may go, given in round numbers of another unit: a step apart is rounding.
const BOUNDS: &[&str] = &["feed_most", "home_back_off", "home_travel"];

/// Every setting in the order of their numbers. Numbers that fit no 32 bits become the nearest that does; the
/// settings are checked before.
pub(crate) fn expected(settings: &Settings) -> [i32; SETTINGS.len()] {
    let s = settings;
    let feed = |mm: f64| mm * s.feed_steps_per_mm;
    let rotate = |deg: f64| deg * f64::from(s.rotate_steps_per_turn) / 360.0;
    let bend = |deg: f64| deg * f64::from(s.bend_steps_per_turn) / 360.0;
    let inverted = [s.feed_inverted, s.rotate_inverted, s.bend_inverted, s.switch_closes];
    let bits = inverted.iter().zip([1.0, 2.0, 4.0, 8.0]).map(|(&on, bit)| if on { bit } else { 0.0 }).sum();
    let by_name = |name: &str| match name {
        "feed_steps_per_m" => s.feed_steps_per_mm * 1000.0,
        "rotate_steps_per_rev" => s.rotate_steps_per_turn.into(),
        "bend_steps_per_rev" => s.bend_steps_per_turn.into(),
        "feed_rate" => feed(s.feed_rate_mm_per_s),
        "rotate_rate" => rotate(s.rotate_rate_deg_per_s),
        "bend_rate" => bend(s.bend_rate_deg_per_s),
        "feed_acceleration" => feed(s.feed_acceleration_mm_per_s2),
        "rotate_acceleration" => rotate(s.rotate_acceleration_deg_per_s2),
        "bend_acceleration" => bend(s.bend_acceleration_deg_per_s2),
        "feed_most" => feed(s.feed_most_mm),
        "rotate_limit" => rotate(s.rotate_limit_deg),
        "bend_limit" => bend(s.bend_limit_deg),
        "near_side" => bend(s.near_side_deg),
        "back_off" => bend(s.back_off_deg),
        "peg_in_us" => s.peg_in_us.into(),
        "peg_out_us" => s.peg_out_us.into(),
        "peg_time_ms" => s.peg_time_ms.into(),
        "home_position" => bend(s.home_position_deg),
        "home_fast_rate" => bend(s.home_fast_rate_deg_per_s),
        "home_slow_rate" => bend(s.home_slow_rate_deg_per_s),
        "home_back_off" => bend(s.home_back_off_deg),
        "home_travel" => bend(s.home_travel_deg),
        "home_time_ms" => s.home_time_s * 1000.0,
        "release_s" => s.release_after_s.into(),
        "inputs" => {
            let wired = [(s.hold_input, 1.0), (s.emergency_input, 2.0)];
            wired.into_iter().map(|(wired, bit)| if wired { bit } else { 0.0 }).sum()
        }
        _ => bits,
    };
    SETTINGS.map(|setting| steps(by_name(setting.name)))
}

/// The nearest whole number.
#[expect(
    clippy::cast_possible_truncation,
    reason = "saturates, and settings are checked against their range"
)]
pub(crate) fn steps(exact: f64) -> i32 {
    exact.round() as i32
}

/// Where a controller's settings are not those of the person. Paces may differ by their rounding.
pub(crate) fn differences(settings: &Settings, machine: &[i32; SETTINGS.len()]) -> Vec<Difference> {
    let expected = expected(settings);
    let all = (0..SETTINGS.len()).map(|index| Difference {
        index,
        machine: machine[index],
        expected: expected[index],
    });
    all.filter(|difference| difference.is_one()).collect()
}

impl Difference {
    fn is_pace(self) -> bool {
        PACE.contains(&SETTINGS[self.index].name)
    }

    fn is_one(self) -> bool {
        let apart = self.machine.abs_diff(self.expected);
        let rounding = match SETTINGS[self.index].name {
            _ if self.is_pace() => 1 + self.expected.unsigned_abs() / 1000,
            name if BOUNDS.contains(&name) => 1,
            _ => 0,
        };
        apart > rounding
    }

    /// For a person. Whether it matters: not where it only says how fast.
    pub fn told(self) -> SettingCheck {
        let setting = &SETTINGS[self.index];
        let shown = |value: i32| format!("{value} {}", setting.unit);
        SettingCheck {
            name: setting.name.to_owned(),
            machine: shown(self.machine),
            expected: shown(self.expected),
            matters: !self.is_pace(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::controller::{Controller, Observed};
    use crate::link::{Link, MachineEvent, Request};
    use std::time::Duration;

    /// A board that takes the settings that were compiled in needs no change for the shipped profile.
    #[test]
    fn the_shipped_settings_are_those_of_the_firmware() {
        let mut controller = Controller::new().unwrap();
        let mut link = Link::new(7, None, Duration::from_millis(100), Duration::ZERO);
        link.request(Request::LoadDefaults);
        (1..=SETTINGS.len()).for_each(|id| link.request(Request::Read(u8::try_from(id).unwrap())));
        let mut values = [0; SETTINGS.len()];
        for ms in 1..3000_u64 {
            controller.send(&link.take_bytes());
            let mut bytes = Vec::new();
            while let Some(seen) = controller.run(ms * 16_000) {
                bytes.extend(if let Observed::Sent(byte) = seen.what { Some(byte) } else { None });
            }
            link.advance(&bytes, Duration::from_millis(ms));
            for event in link.take_events() {
                if let MachineEvent::Setting { id, value } = event {
                    values[usize::from(id) - 1] = value;
                }
            }
        }
        assert_eq!(differences(&Settings::default(), &values), []);
        for (value, setting) in expected(&Settings::default()).into_iter().zip(SETTINGS) {
            assert!((setting.min..=setting.max).contains(&value), "{}: {value}", setting.name);
        }
    }
}
