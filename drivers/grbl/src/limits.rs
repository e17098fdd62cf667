//! What a program can hold, before it is written: how far positions can be told apart, and the rates of its moves.

use wirebend_driver_api::{Axis, AxisLimit, AxisRate, Extent, Limits};

use crate::program::FARTHEST;
use crate::settings::{Moves, Settings};

/// An axis, what is limited, units of the machine for each mm or degree, rate a minute, and the rate's key.
type Spoken = (Axis, Extent, f64, f64, &'static str);

pub(crate) fn of(settings: &Settings) -> Limits {
    let s = settings;
    let bend = if s.bend_returns { Extent::Step } else { Extent::Position };
    let axes: [Spoken; 3] = [
        (Axis::Feed, Extent::Position, s.feed_units_per_mm, s.feed_rate_mm_per_min, "feed_rate_mm_per_min"),
        (
            Axis::Rotate,
            Extent::Position,
            s.rotate_units_per_deg,
            s.rotate_rate_deg_per_min,
            "rotate_rate_deg_per_min",
        ),
        (Axis::Bend, bend, s.bend_units_per_deg, s.bend_rate_deg_per_min, "bend_rate_deg_per_min"),
    ];
    let reason = format!("grbl counts up to {FARTHEST} units of the machine");
    let limit = |(axis, of, units, ..): Spoken| AxisLimit::known(axis, of, FARTHEST / units, &reason);
    // A rapid move is as fast as the board's own settings let it be.
    let rated = axes.iter().filter(|_| s.moves == Moves::FeedRate);
    let rate = |&(axis, _, _, per_min, key): &Spoken| AxisRate::new(axis, per_min / 60.0, &[key]);
    let rates = rated.map(rate).collect();
    Limits { limits: axes.map(limit).into(), rates }
}
