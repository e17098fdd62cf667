//! What a program can hold, before it is written: how far positions can be distinguished, and the rates of its moves.

use wirebend_driver_api::{Axis, AxisLimit, AxisRate, Extent, Limits};

use crate::program::MAX_POSITION;
use crate::settings::{Moves, Settings};

/// What a board says of itself: no axis is faster than it lets them be ($110 and on), and with soft limits ($20) none goes
/// farther than its travel ($130 and on), however its zero lies in that.
pub(crate) fn of_board(settings: &Settings, setting: impl Fn(&str) -> Option<f64>) -> Limits {
    let extents = [Extent::Position, Extent::Position, bend_counts(settings)];
    let units = [settings.feed_units_per_mm, settings.rotate_units_per_deg, settings.bend_units_per_deg];
    let soft = setting("$20").is_some_and(|on| on != 0.0);
    let mut told = Limits::default();
    let letters = settings.axes().map(|(_, letter)| letter);
    for (((axis, letter), of), units) in AXES.into_iter().zip(letters).zip(extents).zip(units) {
        let of_axis = |group: &str| {
            let key = format!("${group}{}", letter.index());
            setting(&key).filter(|value| value.is_finite() && *value > 0.0).map(|value| (key, value / units))
        };
        let travel = of_axis("13").filter(|_| soft);
        told.limits.extend(travel.map(|(key, max)| {
            AxisLimit::known(axis, of, max, &format!("its travel {key}, with soft limits on ($20)"))
        }));
        told.rates.extend(of_axis("11").map(|(key, per_min)| AxisRate::new(axis, per_min / 60.0, &[&key])));
    }
    told
}

/// Where the bend axis does not go back, each bend counts on from the one before.
const fn bend_counts(settings: &Settings) -> Extent {
    if settings.bend_returns { Extent::Step } else { Extent::Position }
}

const AXES: [Axis; 3] = [Axis::Feed, Axis::Rotate, Axis::Bend];

/// An axis, what is limited, units of the machine for each mm or degree, rate a minute, and the rate's key.
type AxisSpec = (Axis, Extent, f64, f64, &'static str);

pub(crate) fn of(settings: &Settings) -> Limits {
    let s = settings;
    let bend = bend_counts(s);
    let axes: [AxisSpec; 3] = [
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
    let reason = format!("grbl counts up to {MAX_POSITION} units of the machine");
    let limit = |(axis, of, units, ..): AxisSpec| AxisLimit::known(axis, of, MAX_POSITION / units, &reason);
    // A rapid move is as fast as the board's own settings let it be.
    let rated = axes.iter().filter(|_| s.moves == Moves::FeedRate);
    let rate = |&(axis, _, _, per_min, key): &AxisSpec| AxisRate::new(axis, per_min / 60.0, &[key]);
    let rates = rated.map(rate).collect();
    let cutter_mm = (!s.cut.is_empty()).then_some(s.cutter_mm);
    Limits { limits: axes.map(limit).into(), rates, cutter_mm, ..Limits::default() }
}
