//! What the sketch takes, before it is sent, and how fast its axes are.

use wirebend_driver_api::{Axis, AxisLimit, AxisRate, Extent, Limits};

use crate::Settings;
use crate::whole::{MAX_ANGLE_DEG, MAX_FEED_MM};

pub(crate) fn of(settings: &Settings) -> Limits {
    let s = settings;
    let counted = "the sketch counts 16 steps a degree in 16 bits";
    // Longer feeds are divided; this is more wire than any coil has.
    let coil = "no coil has more wire";
    // Out at one speed and back at another: the same time at their harmonic mean.
    let stroke = 2.0 / (1.0 / s.bend_rate_deg_per_s + 1.0 / s.bend_return_rate_deg_per_s);
    // The next command waits as much longer.
    let rate = |axis, per_s: f64, keys: &[&str]| {
        AxisRate::new(axis, per_s / s.with_margin(), &[keys, &["margin_percent"]].concat())
    };
    Limits {
        limits: vec![
            AxisLimit::known(Axis::Feed, Extent::Step, MAX_FEED_MM, coil),
            AxisLimit::known(Axis::Rotate, Extent::Step, MAX_ANGLE_DEG, counted),
            AxisLimit::known(Axis::Bend, Extent::Step, MAX_ANGLE_DEG, counted),
        ],
        rates: vec![
            rate(Axis::Feed, s.feed_rate_mm_per_s, &["feed_rate_mm_per_s"]),
            rate(Axis::Rotate, s.rotate_rate_deg_per_s, &["rotate_rate_deg_per_s"]),
            rate(Axis::Bend, stroke, &["bend_rate_deg_per_s", "bend_return_rate_deg_per_s"]),
        ],
        ..Limits::default()
    }
}
