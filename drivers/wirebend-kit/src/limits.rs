//! What the machine takes, before it is asked to: the soft limits of the firmware in the units of a person.

use wirebend_driver_api::{Axis, AxisLimit, AxisRate, Extent, Limits};

use crate::protocol::SETTINGS;
use crate::settings::Settings;

/// The firmware counts the fed wire in 32 bits and refuses a feed beyond half of them: `INT32_MAX / 2` in `limits.c`.
const MAX_FED_STEPS: f64 = 1_073_741_823.0;

/// The limits that `line_of` of the session and `limits.c` of the firmware check.
pub(crate) fn of(settings: &Settings) -> Limits {
    let s = settings;
    let fed = MAX_FED_STEPS / s.feed_steps_per_mm;
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
        ..Limits::default()
    }
}

/// What a board refuses by the settings that it has stored. A step of its motors is taken up to half beyond: moves are
/// rounded to whole ones.
pub(crate) fn of_board(stored: &[i32]) -> Limits {
    let of = |name: &str| {
        let place = SETTINGS.iter().position(|setting| setting.name == name);
        place.and_then(|place| stored.get(place)).copied().map(f64::from).unwrap_or_default()
    };
    let (feed, turn, bend) = (
        of("feed_steps_per_m") / 1000.0,
        of("rotate_steps_per_rev") / 360.0,
        of("bend_steps_per_rev") / 360.0,
    );
    let limit = |axis, extent, name: &str, per| {
        AxisLimit::known(axis, extent, (of(name) + 0.5) / per, &format!("its setting {name}"))
    };
    let rate = |axis, name: &str, per| AxisRate::new(axis, of(name) / per, &[name]);
    let mut told = Limits {
        limits: vec![
            limit(Axis::Feed, Extent::Step, "feed_most", feed),
            limit(Axis::Rotate, Extent::Position, "rotate_limit", turn),
            limit(Axis::Bend, Extent::Step, "bend_limit", bend),
        ],
        rates: vec![
            rate(Axis::Feed, "feed_rate", feed),
            rate(Axis::Rotate, "rotate_rate", turn),
            rate(Axis::Bend, "bend_rate", bend),
        ],
        ..Limits::default()
    };
    // Of an axis without steps nothing can be said.
    told.limits.retain(|limit| limit.most.is_finite());
    told.rates.retain(|rate| rate.per_s.is_finite());
    told
}
