//! What the machine takes, before it is asked to: the soft limits of the firmware in the units of a person.

use wirebend_driver_api::{Axis, AxisLimit, AxisRate, Extent, Limits};

use crate::settings::Settings;

/// The firmware counts the wire in 32 bits and refuses what is beyond half of them: `INT32_MAX / 2` of `controller.c`.
const MOST_FED_STEPS: f64 = 1_073_741_823.0;

/// What `connect` and the firmware would refuse: `line_of` of the session, `check` of `controller.c`.
pub(crate) fn of(settings: &Settings) -> Limits {
    let s = settings;
    let fed = MOST_FED_STEPS / s.feed_steps_per_mm;
    Limits {
        limits: vec![
            AxisLimit::of_setting(Axis::Feed, Extent::Step, s.feed_most_mm, "feed_most_mm"),
            AxisLimit::known(Axis::Feed, Extent::Position, fed, "the firmware counts steps in 32 bits"),
            AxisLimit::of_setting(Axis::Rotate, Extent::Position, s.rotate_limit_deg, "rotate_limit_deg"),
            AxisLimit::of_setting(Axis::Bend, Extent::Step, s.bend_limit_deg, "bend_limit_deg"),
        ],
        rates: vec![
            AxisRate::new(Axis::Feed, s.feed_rate_mm_per_s, &["feed_rate_mm_per_s"]),
            AxisRate::new(Axis::Rotate, s.rotate_rate_deg_per_s, &["rotate_rate_deg_per_s"]),
            AxisRate::new(Axis::Bend, s.bend_rate_deg_per_s, &["bend_rate_deg_per_s"]),
        ],
    }
}
