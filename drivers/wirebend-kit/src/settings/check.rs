//! What a form's ranges cannot say.

use wirebend_driver_api::DriverError;

use super::{Settings, expected};
use crate::protocol::SETTINGS;

impl Settings {
    /// Refuses what the firmware would refuse.
    pub(crate) fn check(&self) -> Result<(), DriverError> {
        for (value, setting) in expected(self).into_iter().zip(SETTINGS) {
            if !(setting.least..=setting.most).contains(&value) {
                return Err(wrong(
                    setting.name,
                    &format!(
                        "comes to {value} {}; the firmware takes {} to {}",
                        setting.unit, setting.least, setting.most
                    ),
                ));
            }
        }
        if !(0.0..=30.0).contains(&self.boot_s) {
            return Err(wrong("boot_s", &format!("is {}: a time from 0 to 30 s is expected", self.boot_s)));
        }
        if self.home_position_deg.abs() < self.bend_limit_deg {
            return Err(wrong(
                "home_position_deg",
                &format!(
                    "is {}°, within the limit of the bend axis of {}°: a bend would hit the switch",
                    self.home_position_deg, self.bend_limit_deg
                ),
            ));
        }
        if self.home_back_off_deg > self.home_travel_deg {
            return Err(wrong(
                "home_back_off_deg",
                &format!(
                    "is {}°, more than a whole search of {}°",
                    self.home_back_off_deg, self.home_travel_deg
                ),
            ));
        }
        if self.near_side_deg > self.bend_limit_deg {
            return Err(wrong(
                "near_side_deg",
                &format!(
                    "is {}°, beyond the limit of the bend axis of {}°",
                    self.near_side_deg, self.bend_limit_deg
                ),
            ));
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
