//! How long commands take, by the published sketch.

use std::time::Duration;

use crate::Settings;
use crate::command::Command;

/// Seconds as a time; settings are checked, and what they make is far below the largest time.
fn time(seconds: f64) -> Duration {
    Duration::try_from_secs_f64(seconds).unwrap_or(Duration::MAX)
}

impl Settings {
    /// From sending a command until its motion is over, with the margin.
    pub(crate) fn whole(&self, command: Command) -> Duration {
        time((self.command_s + self.motion_s(command)) * self.with_margin())
    }

    /// From its beginning until the motion of a command is over, with the margin.
    pub(crate) fn motion(&self, command: Command) -> Duration {
        time(self.motion_s(command) * self.with_margin())
    }

    pub(crate) fn boot(&self) -> Duration {
        time(self.boot_s)
    }

    pub(crate) fn with_margin(&self) -> f64 {
        1.0 + self.margin_percent / 100.0
    }

    fn motion_s(&self, command: Command) -> f64 {
        match command {
            Command::Manual | Command::End => 0.0,
            Command::Feed(mm) => f64::from(mm) / self.feed_rate_mm_per_s,
            Command::Rotate(deg) => f64::from(deg).abs() / self.rotate_rate_deg_per_s,
            Command::Bend(deg) => {
                let size = f64::from(deg).abs();
                let ways = size / self.bend_rate_deg_per_s + size / self.bend_return_rate_deg_per_s;
                let change = if deg < 0 { self.negative_bend_extra_s } else { 0.0 };
                ways + self.bend_extra_s + change
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use wirebend_driver_api::Axis;

    use super::*;

    /// Worked out by hand from the rates of the published sketch: 25 mm/s, 31.25, 43.75 and 75 degrees/s.
    #[test]
    fn a_command_takes_what_the_sketch_takes() {
        let exact = Settings { margin_percent: 0.0, ..Settings::default() };
        let close = |command, expected: f64| {
            assert!((exact.whole(command).as_secs_f64() - expected).abs() < 1e-6, "{command}");
        };
        close(Command::Manual, 1.3);
        close(Command::Feed(50), 1.3 + 2.0);
        close(Command::Rotate(-125), 1.3 + 4.0);
        close(Command::Bend(105), 1.3 + 2.4 + 1.4 + 0.6);
        close(Command::Bend(-105), 1.3 + 2.4 + 1.4 + 0.6 + 1.6);
    }

    /// What is planned with the machine's profile is what a wire takes: seven feeds, turns and bends, of which every second one is
    /// negative.
    #[test]
    fn the_profile_has_the_times_of_the_commands() {
        let profile: serde_json::Value =
            serde_json::from_str(include_str!("../../../machine-profiles/machines/howtomechatronics.json"))
                .unwrap();
        let settings: Settings = serde_json::from_value(profile["driver"]["settings"].clone()).unwrap();
        let fixed = |key: &str| profile["time"][key]["value"].as_f64().unwrap();
        let rates = crate::limits::of(&settings).rates;
        let rate = |axis| rates.iter().find(|rate| rate.axis == axis).unwrap().per_s;
        for (commands, way, axis, key) in [
            (vec![Command::Feed(50)], 50.0, Axis::Feed, "fixed_per_feed_s"),
            (vec![Command::Rotate(-125)], 125.0, Axis::Rotate, "fixed_per_turn_s"),
            (vec![Command::Bend(90), Command::Bend(-90)], 2.0 * 90.0, Axis::Bend, "fixed_per_bend_s"),
        ] {
            let takes: f64 = commands.iter().map(|command| settings.whole(*command).as_secs_f64()).sum();
            let each = takes / f64::from(u32::try_from(commands.len()).unwrap());
            let planned = way / rate(axis) + fixed(key);
            assert!((planned - each).abs() < 0.05, "{key}: {planned} s, and the commands take {each} s");
        }
    }

    #[test]
    fn the_margin_is_on_all_of_it() {
        let settings = Settings { margin_percent: 50.0, ..Settings::default() };
        assert_eq!(settings.whole(Command::Feed(50)), Duration::from_secs_f64(4.95));
        assert_eq!(settings.motion(Command::Feed(50)), Duration::from_secs(3));
    }
}
