//! What a person can set. The figures are those of the published sketch; README.md derives each.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_driver_api::DriverError;

/// The port, the times of the machine, and what its sketch needs. The comments below are shown in a form.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Settings {
    /// Speed of the serial port, baud.
    #[schemars(range(min = 300, max = 2_000_000))]
    pub baud: u32,
    /// From opening the port until the machine listens, s. Opening it restarts the board; the sketch then moves the bend arm to its switch and back.
    #[schemars(range(min = 0, max = 120))]
    pub boot_s: f64,
    /// Speed of the feed, mm/s.
    #[schemars(range(min = 0.1, max = 10_000))]
    pub feed_rate_mm_per_s: f64,
    /// Speed of the rotation, degrees/s.
    #[schemars(range(min = 0.1, max = 10_000))]
    pub rotate_rate_deg_per_s: f64,
    /// Speed of the arm while it bends, degrees/s.
    #[schemars(range(min = 0.1, max = 10_000))]
    pub bend_rate_deg_per_s: f64,
    /// Speed of the arm on its way back, degrees/s.
    #[schemars(range(min = 0.1, max = 10_000))]
    pub bend_return_rate_deg_per_s: f64,
    /// What every command takes besides its motion, s: the sketch waits for a second of silence before it reads.
    #[schemars(range(min = 0, max = 120))]
    pub command_s: f64,
    /// What every bend takes besides the way out and back, s.
    #[schemars(range(min = 0, max = 120))]
    pub bend_extra_s: f64,
    /// What a bend below zero takes on top of that, s: the arm changes to the other side of the wire and back.
    #[schemars(range(min = 0, max = 120))]
    pub negative_bend_extra_s: f64,
    /// How much longer than computed each command is waited for, percent. The machine does not say when it has finished; too little and commands run together.
    #[schemars(range(min = 0, max = 1000))]
    pub margin_percent: f64,
    /// The longest feed of one command, mm; longer ones are divided. The sketch counts in 16 bits: above 682 mm at 48 steps/mm a feed never ends.
    #[schemars(range(min = 1, max = 100_000))]
    pub most_feed_mm: i32,
    /// Whether `end` is sent after each wire. The published sketch then takes no other wire until it is restarted, so this is for changed ones.
    pub end_each_wire: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            baud: 9600,
            boot_s: 6.0,
            feed_rate_mm_per_s: 25.0,
            rotate_rate_deg_per_s: 31.25,
            bend_rate_deg_per_s: 43.75,
            bend_return_rate_deg_per_s: 75.0,
            command_s: 1.3,
            bend_extra_s: 0.6,
            negative_bend_extra_s: 1.6,
            margin_percent: 25.0,
            most_feed_mm: 682,
            end_each_wire: false,
        }
    }
}

impl Settings {
    /// Refuses a value outside its range by the name of its key.
    pub(crate) fn check(&self) -> Result<(), DriverError> {
        let checked = [
            ("baud", f64::from(self.baud), 300.0, 2e6),
            ("boot_s", self.boot_s, 0.0, 120.0),
            ("feed_rate_mm_per_s", self.feed_rate_mm_per_s, 0.1, 1e4),
            ("rotate_rate_deg_per_s", self.rotate_rate_deg_per_s, 0.1, 1e4),
            ("bend_rate_deg_per_s", self.bend_rate_deg_per_s, 0.1, 1e4),
            ("bend_return_rate_deg_per_s", self.bend_return_rate_deg_per_s, 0.1, 1e4),
            ("command_s", self.command_s, 0.0, 120.0),
            ("bend_extra_s", self.bend_extra_s, 0.0, 120.0),
            ("negative_bend_extra_s", self.negative_bend_extra_s, 0.0, 120.0),
            ("margin_percent", self.margin_percent, 0.0, 1000.0),
            ("most_feed_mm", f64::from(self.most_feed_mm), 1.0, 1e5),
        ];
        match checked.into_iter().find(|(_, value, min, max)| !(*min..=*max).contains(value)) {
            None => Ok(()),
            Some((key, value, min, max)) => {
                let message = format!("'{key}' is {value}; it can be {min} to {max}");
                Err(DriverError::new("settings", message, "set it to what was measured, or leave it out"))
            }
        }
    }
}
