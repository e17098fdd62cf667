//! What a form's ranges cannot say.

use wirebend_driver_api::DriverError;

use super::{Settings, expected};
use crate::protocol::SETTINGS;

impl Settings {
    /// Refuses what the firmware would refuse.
    pub(crate) fn check(&self) -> Result<(), DriverError> {
        for (value, setting) in expected(self).into_iter().zip(SETTINGS) {
            if !(setting.min..=setting.max).contains(&value) {
                return Err(wrong(
                    setting.name,
                    &format!(
                        "comes to {value} {}; the firmware takes {} to {}",
                        setting.unit, setting.min, setting.max
                    ),
                ));
            }
        }
        let limit = self.bend_limit_deg;
        let rules = [
            (
                (0.0..=30.0).contains(&self.boot_s),
                "boot_s",
                format!("is {}: a time from 0 to 30 s is expected", self.boot_s),
            ),
            (
                (1..=255).contains(&self.firmware_machine),
                "firmware_machine",
                format!("is {}: a number from 1 to 255 is expected", self.firmware_machine),
            ),
            (
                self.home_position_deg.abs() >= limit,
                "home_position_deg",
                format!(
                    "is {}°, within the limit of the bend axis of {limit}°: a bend would hit the switch",
                    self.home_position_deg
                ),
            ),
            (
                self.home_back_off_deg <= self.home_travel_deg,
                "home_back_off_deg",
                format!(
                    "is {}°, more than a whole homing move of {}°",
                    self.home_back_off_deg, self.home_travel_deg
                ),
            ),
            (
                self.near_side_deg <= limit,
                "near_side_deg",
                format!("is {}°, beyond the limit of the bend axis of {limit}°", self.near_side_deg),
            ),
        ];
        if let Some((_, name, what)) = rules.into_iter().find(|(kept, _, _)| !kept) {
            return Err(wrong(name, &what));
        }
        Ok(())
    }
}

fn wrong(name: &str, what: &str) -> DriverError {
    DriverError::new(
        "settings",
        format!("'{name}' {what}"),
        "correct the driver's settings in the machine's profile",
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each rule by a value just beyond it, in the shipped settings; a number that is none keeps no rule.
    #[test]
    fn what_would_break_something_is_refused_by_name() {
        let shipped = Settings::default();
        shipped.check().unwrap();
        let limit = shipped.bend_limit_deg;
        let beyond = shipped.home_travel_deg + 0.5;
        for (settings, name) in [
            (Settings { boot_s: 30.1, ..shipped.clone() }, "boot_s"),
            (Settings { boot_s: f64::NAN, ..shipped.clone() }, "boot_s"),
            (Settings { firmware_machine: 0, ..shipped.clone() }, "firmware_machine"),
            (Settings { firmware_machine: 256, ..shipped.clone() }, "firmware_machine"),
            (Settings { home_position_deg: -limit + 0.5, ..shipped.clone() }, "home_position_deg"),
            (Settings { home_back_off_deg: beyond, ..shipped.clone() }, "home_back_off_deg"),
            (Settings { near_side_deg: limit + 0.5, ..shipped }, "near_side_deg"),
        ] {
            let error = settings.check().unwrap_err();
            assert!(error.message.contains(&format!("'{name}'")), "{name}: {error}");
        }
    }
}
