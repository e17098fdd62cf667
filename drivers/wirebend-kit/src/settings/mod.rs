//! What a person can set: the machine, in millimetres, degrees and seconds. The firmware counts steps.

mod check;
mod stored;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::protocol::Machine;
pub(crate) use stored::{Difference, differences, expected, steps};

/// The machine as it is built. The comments below are shown in a form. What the firmware stores is compared with
/// this when a machine is connected, and written to it when a person says so.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
#[expect(clippy::struct_excessive_bools, reason = "each is a switch of its own in a form")]
pub struct Settings {
    /// How long a board that has just been connected may take to start, s. Opening its port restarts an Uno.
    #[schemars(range(min = 0, max = 30))]
    pub boot_s: f64,
    /// The machine that the firmware on the board must be built for: 1 the WireBend-kit, 2 that of howtomechatronics.com,
    /// another number for a machine of your own in firmware/machines. A board with other pins is refused.
    #[schemars(range(min = 1, max = 255))]
    pub firmware_machine: u32,
    /// Steps of the feed motors for a millimetre of wire: steps a turn by the circumference of the wheel. Feed a metre, measure, and correct.
    #[schemars(range(min = 1, max = 1000))]
    pub feed_steps_per_mm: f64,
    /// Steps of the head for a full turn.
    #[schemars(range(min = 200, max = 1_000_000))]
    pub rotate_steps_per_turn: u32,
    /// Steps of the bend axis for a full turn.
    #[schemars(range(min = 200, max = 1_000_000))]
    pub bend_steps_per_turn: u32,
    /// Speed of the feed, mm/s.
    #[schemars(range(min = 0.1, max = 1000))]
    pub feed_rate_mm_per_s: f64,
    /// Speed of the head, degrees/s.
    #[schemars(range(min = 0.1, max = 10_000))]
    pub rotate_rate_deg_per_s: f64,
    /// Speed of the bend axis, degrees/s.
    #[schemars(range(min = 0.1, max = 10_000))]
    pub bend_rate_deg_per_s: f64,
    /// Acceleration of the feed, mm/s².
    #[schemars(range(min = 1, max = 100_000))]
    pub feed_acceleration_mm_per_s2: f64,
    /// Acceleration of the head, degrees/s².
    #[schemars(range(min = 1, max = 100_000))]
    pub rotate_acceleration_deg_per_s2: f64,
    /// Acceleration of the bend axis, degrees/s².
    #[schemars(range(min = 1, max = 100_000))]
    pub bend_acceleration_deg_per_s2: f64,
    /// Longest feed of one step, mm.
    #[schemars(range(min = 1, max = 100_000))]
    pub feed_most_mm: f64,
    /// How far the head may turn to either side, degrees: its cables.
    #[schemars(range(min = 1, max = 100_000))]
    pub rotate_limit_deg: f64,
    /// How far the bend axis may go to either side, degrees.
    #[schemars(range(min = 1, max = 180))]
    pub bend_limit_deg: f64,
    /// How far before zero the peg comes out, degrees: the angle at which it touches straight wire, and some more.
    #[schemars(range(min = 0.1, max = 180))]
    pub near_side_deg: f64,
    /// How far the peg goes back before it goes in, degrees: more than the wire springs after it.
    #[schemars(range(min = 0, max = 180))]
    pub back_off_deg: f64,
    /// Servo pulse with the peg in, µs.
    #[schemars(range(min = 512, max = 2500))]
    pub peg_in_us: u32,
    /// Servo pulse with the peg out, µs.
    #[schemars(range(min = 512, max = 2500))]
    pub peg_out_us: u32,
    /// Time that the peg takes, ms.
    #[schemars(range(min = 20, max = 5000))]
    pub peg_time_ms: u32,
    /// Where the bend axis stands at the edge of its switch, degrees; the sign says on which side it is.
    #[schemars(range(min = -180, max = 180))]
    pub home_position_deg: f64,
    /// Speed of the first homing move, to the switch, degrees/s.
    #[schemars(range(min = 0.1, max = 1000))]
    pub home_fast_rate_deg_per_s: f64,
    /// Speed of the second homing move, degrees/s.
    #[schemars(range(min = 0.1, max = 1000))]
    pub home_slow_rate_deg_per_s: f64,
    /// Way back from the switch between the homing moves, degrees.
    #[schemars(range(min = 0.1, max = 90))]
    pub home_back_off_deg: f64,
    /// Longest way of a homing move, degrees.
    #[schemars(range(min = 1, max = 720))]
    pub home_travel_deg: f64,
    /// Longest time of homing, s.
    #[schemars(range(min = 1, max = 600))]
    pub home_time_s: f64,
    /// Whether the feed motors turn the other way.
    pub feed_inverted: bool,
    /// Whether the motor of the head turns the other way.
    pub rotate_inverted: bool,
    /// Whether the motor of the bend axis turns the other way.
    pub bend_inverted: bool,
    /// Time at rest after which the motors are released, s; 0 never. The machine has to be homed after it.
    #[schemars(range(min = 0, max = 36_000))]
    pub release_after_s: u32,
    /// Whether a contact for a door or a feed hold is wired (A1): open, the machine slows down and holds.
    pub hold_input: bool,
    /// Whether a sense contact of the emergency stop is wired (A0): open, everything ends, and no step counts as done.
    pub emergency_input: bool,
    /// Whether the switch closes when it is pressed. The published one opens, so that a broken wire is noticed.
    pub switch_closes: bool,
}

impl Default for Settings {
    /// The published machine, as firmware/machines/wirebend-kit.h has it.
    fn default() -> Self {
        Self {
            boot_s: 2.5,
            firmware_machine: Machine::WirebendKit as u32,
            // 6400 a turn of a wheel of 37.42 mm.
            feed_steps_per_mm: 54.44,
            // 6400 a turn, belt 18/7.
            rotate_steps_per_turn: 16457,
            // 800 a turn, gearbox 26.85.
            bend_steps_per_turn: 21480,
            feed_rate_mm_per_s: 110.2,
            rotate_rate_deg_per_s: 131.25,
            bend_rate_deg_per_s: 15.084,
            feed_acceleration_mm_per_s2: 551.06,
            rotate_acceleration_deg_per_s2: 437.5,
            bend_acceleration_deg_per_s2: 67.04,
            feed_most_mm: 7347.54,
            rotate_limit_deg: 360.0,
            bend_limit_deg: 155.0,
            near_side_deg: 18.25,
            // More than the wire springs after the peg.
            back_off_deg: 20.0,
            peg_in_us: 1000,
            peg_out_us: 2000,
            peg_time_ms: 500,
            home_position_deg: -160.0,
            home_fast_rate_deg_per_s: 10.06,
            home_slow_rate_deg_per_s: 1.676,
            home_back_off_deg: 2.0,
            home_travel_deg: 335.2,
            home_time_s: 90.0,
            feed_inverted: false,
            rotate_inverted: false,
            bend_inverted: false,
            release_after_s: 0,
            hold_input: false,
            emergency_input: false,
            switch_closes: false,
        }
    }
}
